// The functions available in expressions. Angles are in degrees.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lessons/expression_node.h"
#include "models/json/json.h"
#include "models/numbers.h"

namespace glint {
namespace {

using Values = std::vector<Json>;

const Json::array_t& as_list(const Json& value) {
    if (!value.is_array()) throw ExpressionProblem{in_words(value) + " is not a list", "a list"};
    return elements_of(value);
}

Json each(const Json& value, double (*f)(double)) {
    if (!value.is_array()) return f(as_number(value));
    Json::array_t results;
    for (const Json& element : elements_of(value)) results.push_back(each(element, f));
    return Json(std::move(results));
}
/// Applies a function to each number of the argument.
template <double (*f)(double)> Json of_each(const Values& v) { return each(v[0], f); }

double magnitude(double x) { return std::abs(x); }
double square_root(double x) { return std::sqrt(x); }
double exponential(double x) { return std::exp(x); }
double logarithm(double x) { return std::log(x); }
double sine(double deg) { return std::sin(deg * degree); }
double cosine(double deg) { return std::cos(deg * degree); }
double tangent(double deg) { return std::tan(deg * degree); }
double arc_sine(double x) { return std::asin(x) / degree; }
double arc_cosine(double x) { return std::acos(x) / degree; }
double arc_tangent(double x) { return std::atan(x) / degree; }
double nearest_whole(double x) { return std::round(x); }

double quotient(double a, double b) { return a / b; }
double plus(double a, double b) { return a + b; }
double times(double a, double b) { return a * b; }

Json sum(const Json& list) {
    Json total(0.0);
    for (const Json& element : as_list(list)) total = combined(total, element, plus);
    return total;
}

double dot(const Json& a, const Json& b) {
    as_list(a);
    as_list(b);
    return as_number(sum(combined(a, b, times)));
}

double length(const Json& v) { return std::sqrt(dot(v, v)); }

Json cross(const Json& a, const Json& b) {
    if (as_list(a).size() != 3 || as_list(b).size() != 3)
        throw ExpressionProblem{"cross() is given lists of other lengths", "two lists of three numbers"};
    std::array<double, 3> x{}, y{};
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = as_number(elements_of(a)[i]);
        y[i] = as_number(elements_of(b)[i]);
    }
    return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

/// Multiplies a matrix (a list of rows) by a vector.
Json mul(const Json& matrix, const Json& vector) {
    Json::array_t rows;
    for (const Json& row : as_list(matrix)) rows.emplace_back(dot(row, vector));
    return Json(std::move(rows));
}

/// The index of the first element in the order `before`. Skips NaN.
Json place_of(const Json& list, bool (*before)(double, double)) {
    const Json::array_t& elements = as_list(list);
    std::size_t best = elements.size();
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const double x = as_number(elements[i]);
        if (std::isnan(x)) continue;
        if (best == elements.size() || before(x, as_number(elements[best]))) best = i;
    }
    if (best == elements.size()) throw ExpressionProblem{"the list holds no numbers", "one at least"};
    return best;
}
bool is_less(double a, double b) { return a < b; }
bool is_more(double a, double b) { return a > b; }

Json extreme(const Values& v, bool (*before)(double, double)) {
    const Json list = v.size() == 1 ? v[0] : Json(v);
    const auto at = static_cast<std::size_t>(place_of(list, before).get<double>());
    return elements_of(list)[at];
}

Json part(const Values& v) {
    const auto size = static_cast<double>(as_list(v[0]).size());
    const double from = as_number(v[1]), to = as_number(v[2]);
    const bool whole = std::floor(from) == from && std::floor(to) == to;
    if (!(whole && from >= 0 && to >= from && to < size))
        throw ExpressionProblem{"part() is asked for what the list does not have", "0 to its last place"};
    const auto begin = elements_of(v[0]).begin();
    return Json(Json::array_t(begin + static_cast<std::ptrdiff_t>(from),
                              begin + static_cast<std::ptrdiff_t>(to) + 1));
}

Json mean(const Values& v) {
    return combined(sum(v[0]), static_cast<double>(as_list(v[0]).size()), quotient);
}

struct Function {
    std::string_view name;
    std::size_t least, most;  // minimum and maximum number of arguments
    Json (*value)(const Values& v);
};

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

constexpr std::array functions{
    Function{"abs", 1, 1, of_each<magnitude>},
    Function{"sqrt", 1, 1, of_each<square_root>},
    Function{"exp", 1, 1, of_each<exponential>},
    Function{"log", 1, 1, of_each<logarithm>},
    Function{"round", 1, 1, of_each<nearest_whole>},
    Function{"sin", 1, 1, of_each<sine>},
    Function{"cos", 1, 1, of_each<cosine>},
    Function{"tan", 1, 1, of_each<tangent>},
    Function{"asin", 1, 1, of_each<arc_sine>},
    Function{"acos", 1, 1, of_each<arc_cosine>},
    Function{"atan", 1, 1, of_each<arc_tangent>},
    Function{"pi", 0, 0, [](const Values&) { return Json(std::numbers::pi); }},
    Function{"count", 1, 1, [](const Values& v) { return Json(as_list(v[0]).size()); }},
    Function{"sum", 1, 1, [](const Values& v) { return sum(v[0]); }},
    Function{"mean", 1, 1, mean},
    Function{"min", 1, unlimited, [](const Values& v) { return extreme(v, is_less); }},
    Function{"max", 1, unlimited, [](const Values& v) { return extreme(v, is_more); }},
    Function{"where_min", 1, 1, [](const Values& v) { return place_of(v[0], is_less); }},
    Function{"where_max", 1, 1, [](const Values& v) { return place_of(v[0], is_more); }},
    Function{"part", 3, 3, part},
    Function{"dot", 2, 2, [](const Values& v) { return Json(dot(v[0], v[1])); }},
    Function{"length", 1, 1, [](const Values& v) { return Json(length(v[0])); }},
    Function{"unit", 1, 1, [](const Values& v) { return combined(v[0], length(v[0]), quotient); }},
    Function{"cross", 2, 2, [](const Values& v) { return cross(v[0], v[1]); }},
    Function{"mul", 2, 2, [](const Values& v) { return mul(v[0], v[1]); }},
};

const Function* function_of(std::string_view name) {
    const auto* const at =
        std::find_if(functions.begin(), functions.end(), [&](const Function& f) { return f.name == name; });
    return at == functions.end() ? nullptr : at;
}

}  // namespace

double as_number(const Json& value) {
    if (value.is_number()) return value.get<double>();
    if (value == Json()) return std::numeric_limits<double>::quiet_NaN();
    throw ExpressionProblem{in_words(value) + " is not a number", "a number"};
}

std::string in_words(const Json& value) {
    if (!value.is_number() || std::isfinite(value.get<double>())) return shortened(json_line(value));
    if (std::isnan(value.get<double>())) return "undefined";
    return value.get<double>() < 0 ? "-infinite" : "infinite";
}

Json combined(const Json& a, const Json& b, double (*op)(double, double)) {
    if (!a.is_array() && !b.is_array()) return op(as_number(a), as_number(b));
    const std::size_t size = a.is_array() ? elements_of(a).size() : elements_of(b).size();
    if (a.is_array() && b.is_array() && elements_of(b).size() != size)
        throw ExpressionProblem{"lists of " + std::to_string(size) + " and of " +
                                    std::to_string(elements_of(b).size()) + " values meet",
                                "two of one length, or a number and a list"};
    Json::array_t results;
    results.reserve(size);
    for (std::size_t i = 0; i < size; ++i)
        results.push_back(
            combined(a.is_array() ? elements_of(a)[i] : a, b.is_array() ? elements_of(b)[i] : b, op));
    return Json(std::move(results));
}

bool known_function(std::string_view name) { return function_of(name) != nullptr; }

std::vector<std::string> function_names() {
    std::vector<std::string> names;
    names.reserve(std::size(functions));
    for (const Function& f : functions) names.emplace_back(f.name);
    return names;
}

Json call_function(const std::string& name, const std::vector<Json>& arguments) {
    const Function& f = *function_of(name);
    if (arguments.size() < f.least || arguments.size() > f.most)
        throw ExpressionProblem{name + "() is given " + std::to_string(arguments.size()) + " values",
                                std::to_string(f.least) + (f.most == unlimited ? " at least" : "")};
    return f.value(arguments);
}

}  // namespace glint
