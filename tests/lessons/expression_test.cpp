// Tests for expressions in lessons: values worked out by hand, errors, and hostile text.
#include "lessons/expression.h"

#include <cmath>
#include <random>

#include "tests/support/catch.h"

using namespace glint;

namespace {

const NamedValues& names() {
    static const NamedValues values{
        {"a", json_or_null(R"({"n": 0.5, "list": [1, 2, 3], "word": "Ball", "none": null,
                                    "lights": [{"x": 1, "l": {"camera": [0, 0.6, 0.8]}}, {"x": 2}]})")},
        {"m", json_or_null("[[0, -1], [1, 0]]")},
        {"angle", Json(60)}};
    return values;
}

Json value_of(const std::string& text) {
    const Result<Expression> parsed = Expression::parse(text);
    INFO(text);
    REQUIRE(problem_of(parsed) == nullptr);
    const Result<Json> value = std::get<Expression>(parsed).value(names());
    if (const Problem* problem = problem_of(value)) FAIL(problem->text());
    return std::get<Json>(value);
}

/// The problem that is found while an expression is parsed or evaluated.
std::string problem_with(const std::string& text) {
    const Result<Expression> parsed = Expression::parse(text);
    if (const Problem* problem = problem_of(parsed)) return problem->text();
    const Result<Json> value = std::get<Expression>(parsed).value(names());
    const Problem* problem = problem_of(value);
    return problem == nullptr ? "" : problem->text();
}

}  // namespace

TEST_CASE("expressions evaluate to their arithmetic values", "[lesson]") {
    const std::vector<std::pair<std::string, double>> worked{{"1 + 2 * 3", 7},
                                                             {"(1 + 2) * 3", 9},
                                                             {"10 - 4 - 3", 3},
                                                             {"2 ^ 3 ^ 2", 512},
                                                             {"-2 ^ 2", -4},
                                                             {"12 / 3 / 2", 2},
                                                             {"1.5e1", 15},
                                                             {"cos(60)", 0.5},
                                                             {"asin(1)", 90},
                                                             {"atan(1)", 45},
                                                             {"sqrt(a.n * 32)", 4},
                                                             {"a.list[0] + a.list[2]", 4},
                                                             {"a.lights[1].x", 2},
                                                             {"sum(a.list)", 6},
                                                             {"mean(a.list)", 2},
                                                             {"max(a.list)", 3},
                                                             {"min(4, 2, 8)", 2},
                                                             {"where_max([3, 9, 4])", 1},
                                                             {"count(a.lights)", 2},
                                                             {"dot([1, 2, 3], a.list)", 14},
                                                             {"length([3, 4])", 5},
                                                             {"sum(a.lights.x)", 3},
                                                             {"abs(-3)", 3},
                                                             {"cos(angle)", 0.5},
                                                             {"pi()", 3.14159265358979},
                                                             {"exp(log(7))", 7},
                                                             {"part(a.list, 1, 2)[1]", 3}};
    for (const auto& [text, expected] : worked) {
        CAPTURE(text);
        CHECK(value_of(text).get<double>() == Approx(expected).epsilon(1e-12));
    }
}

TEST_CASE("lists are combined element by element", "[lesson]") {
    CHECK(json_line(value_of("[1, 2] + [10, 20]")) == "[11.0,22.0]");
    CHECK(json_line(value_of("2 * a.list")) == "[2.0,4.0,6.0]");
    CHECK(json_line(value_of("-a.list")) == "[-1.0,-2.0,-3.0]");
    CHECK(json_line(value_of("cross([1, 0, 0], [0, 1, 0])")) == "[0.0,0.0,1.0]");
    CHECK(json_line(value_of("mul(m, [2, 5])")) == "[-5.0,2.0]");  // a quarter turn
    CHECK(value_of("unit([0, 3, 4])[2]").get<double>() == Approx(0.8));
    CHECK(json_line(value_of("sum([[1, 2], [3, 4]])")) == "[4.0,6.0]");
}

TEST_CASE("a condition holds if and only if its comparison is true", "[lesson]") {
    for (const char* const text :
         {"1 = 1", "1 != 2", "1 < 2", "2 <= 2", "3 > 2", "3 >= 3", "0.5 = 0.51 within 0.02",
          "[1, 2] = [1, 2.001] within 0.01", "a.list > 0", "a.word = \"Ball\"", "a.word != \"ball\"",
          "not 1 = 2", "1 = 2 or 2 = 2", "1 = 1 and 2 = 2", "(1 = 1) = true", "[0, 0] = 0",
          "a.lights[0].l.camera = [0, 0.6, 0.8]", "1 != 2 within 0.5"}) {
        CAPTURE(text);
        CHECK(value_of(text).get<bool>());
    }
    for (const char* const text : {"1 = 2", "0.5 = 0.53 within 0.02", "a.list > 1", "[1, 2] = [1, 3]",
                                   "1 != 2 within 1", "[1, 2] != [1, 2]", "1 = 1 and 1 = 2"}) {
        CAPTURE(text);
        CHECK_FALSE(value_of(text).get<bool>());
    }
}

TEST_CASE("comparisons with NaN are false", "[lesson]") {
    for (const char* const symbol : {"=", "!=", "<", "<=", ">", ">="}) {
        CAPTURE(symbol);
        CHECK_FALSE(value_of("a.none " + std::string(symbol) + " 1").get<bool>());
        CHECK_FALSE(value_of("0 / 0 " + std::string(symbol) + " [1, 1]").get<bool>());
        CHECK_FALSE(value_of("sqrt(-1) " + std::string(symbol) + " 0").get<bool>());
    }
}

TEST_CASE("an invalid expression reports its problem", "[lesson][bad-input]") {
    CHECK(problem_with("") == "\"\" ends too early; expected a value");
    CHECK(problem_with("1 +") == "\"1 +\" ends too early; expected a value");
    CHECK(problem_with("(1") == "\"(1\" ends too early; expected \")\"");
    CHECK(problem_with("1 2") ==
          "\"1 2\" has \"2\" where it does not belong; expected an operator or the end");
    CHECK(problem_with("sqr(1)") == "\"sqr(1)\" \"sqr\" is not a function; expected \"sqrt\"");
    CHECK(problem_with("1 < 2 within 1") ==
          "\"1 < 2 within 1\" has a tolerance after \"<\"; expected \"within\" after = or != only");
    CHECK(problem_with("b.n") == "\"b.n\": \"b\" is not known; expected \"a\"");
    CHECK(problem_with("a.m") == "\"a.m\": there is no \"m\"; expected \"n\"");
    CHECK(problem_with("a.list[3]") ==
          "\"a.list[3]\": there is no element 3 in a list of 3; expected 0 to 2");
    CHECK(problem_with("[][0]") ==
          "\"[][0]\": there is no element 0 in a list of 0; expected a list with elements");
    CHECK(problem_with("[] = 2") == "\"[] = 2\": an empty list is compared; expected a list with elements");
    CHECK(problem_with("1 = 1 within 0 / 0").ends_with("has the tolerance undefined; expected 0 or more"));
    CHECK(problem_with("a.list[0.5]").find("no element 0.5") != std::string::npos);
    CHECK(problem_with("part(a.list, 0.5, 1)").find("part() has a position outside its list") !=
          std::string::npos);
    CHECK(problem_with("a.list + [1]").find("lists of 3 and 1 values are combined") != std::string::npos);
    CHECK(problem_with("a.word + 1").find("is not a number") != std::string::npos);
    CHECK(problem_with("cos()").find("is given 0 values") != std::string::npos);
    CHECK(problem_with("1 and 2").find("neither true nor false") != std::string::npos);
    CHECK(problem_with(std::string(1001, '1')).find("too long") != std::string::npos);
    for (const char bracket : {'(', '[', '-'}) {
        CAPTURE(bracket);
        CHECK(problem_with(std::string(900, bracket)).find("nested too deeply") != std::string::npos);
    }
}

TEST_CASE("an expression may be nested 32 deep, counting brackets, signs, powers and nots",
          "[lesson][bad-input]") {
    struct Nested {
        std::string open, value, close;
    };
    const auto repeated = [](const std::string& part, int times) {
        std::string text;
        for (int i = 0; i < times; ++i) text += part;
        return text;
    };
    for (const Nested& n : {Nested{"(", "1", ")"},
                            {"[", "1", "]"},
                            {"sqrt(", "1", ")"},
                            {"-", "1", ""},
                            {"1^", "1", ""},
                            {"not ", "true", ""},
                            {"a.list[", "0", "]"}}) {
        CAPTURE(n.open);
        const auto nested = [&](int deep) {
            return repeated(n.open, deep) + n.value + repeated(n.close, deep);
        };
        CHECK(problem_of(Expression::parse(nested(32))) == nullptr);
        CHECK(problem_with(nested(33)).find("nested too deeply; expected at most 32 levels") !=
              std::string::npos);
    }
}

TEST_CASE("the false part of a condition is shown with its values", "[lesson]") {
    const auto shown = [](const std::string& text) {
        return std::get<Expression>(Expression::parse(text)).with_values(names());
    };
    CHECK(shown("a.n = 0.4 within 0.01") == "0.5 = 0.4 within 0.01");
    CHECK(shown("1 = 1 and a.n > cos(0)") == "0.5 > 1.0");
    CHECK(shown("1 = 1 and not true") == "1 = 1 and not true");
    CHECK(shown("1 / 0 = 5") == "infinite = 5.0");
    CHECK(shown("-1 / 0 > 5") == "-infinite > 5.0");
    CHECK(shown("0 / 0 = 5") == "undefined = 5.0");
}

TEST_CASE("no expression crashes the program", "[lesson][fuzz]") {
    const std::string good = R"(a.lights[0].l.camera + part([1, 2, 3], 0, 2) * -cos(60) ^ 2 = "x" within 1)";
    std::mt19937 random(11);
    int valid = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = good;
        for (auto edits = random() % 6 + 1; edits > 0; --edits) {
            const std::size_t at = random() % text.size();
            if (random() % 2 == 0)
                text[at] = static_cast<char>(random() % 256);
            else
                text.insert(at, std::string(random() % 3, good[random() % good.size()]));
        }
        const Result<Expression> parsed = Expression::parse(text);
        if (problem_of(parsed)) continue;
        ++valid;
        (void)std::get<Expression>(parsed).value(names());
        (void)std::get<Expression>(parsed).with_values(names());
    }
    CHECK(valid > 20);
}

TEST_CASE("a constant negative tolerance is rejected when parsed, others when evaluated",
          "[lesson][bad-input]") {
    CHECK(problem_with("1 = 1 within -1") ==
          "\"1 = 1 within -1\" has the tolerance -1.0; expected 0 or more");
    CHECK(problem_of(Expression::parse("1 = 1 within 2 - 3")) != nullptr);
    CHECK(problem_of(Expression::parse("not (true and a.n != 1 within -1e-9)")) != nullptr);
    CHECK(problem_of(Expression::parse("a.n = 1 within 0 - a.n")) == nullptr);
    CHECK(problem_with("a.n = 1 within 0 - a.n") ==
          "\"a.n = 1 within 0 - a.n\": has the tolerance -0.5; expected 0 or more");
    CHECK(value_of("1 = 1 within 0") == Json(true));
    CHECK(value_of("1 = 2 within 1/0") == Json(true));
    CHECK(value_of("1 = 1.5 within a.n") == Json(true));
}
