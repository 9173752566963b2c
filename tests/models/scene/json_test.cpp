// JSON: written values can be read back, and invalid texts are refused.
#include "models/json/json.h"

#include <cmath>
#include <limits>

#include "models/problem.h"
#include "models/utf8.h"
#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("reading either text form of a JSON value gives an equal value", "[json]") {
    Json json{{"name", "Kugel \"1\" ✓"}, {"on", true}, {"none", Json()}, {"share", 0.1}, {"count", 3}};
    json["list"] = Json::array();
    json["list"].push_back({1, 2.5, "x"});
    json["empty"] = Json::object();
    CHECK(json_or_null(json_line(json)) == json);
    CHECK(json_or_null(json_text(json)) == json);
    CHECK(
        json_line(json) ==
        R"({"name":"Kugel \"1\" ✓","on":true,"none":null,"share":0.1,"count":3,"list":[[1,2.5,"x"]],"empty":{}})");
}

TEST_CASE("readable JSON has one member per line and lists of plain values on one line", "[json]") {
    const Json json{{"at", {1, 2, 3}}, {"lights", {Json{{"n", 1}}, Json{{"n", 2}}}}};
    CHECK(json_text(json) ==
          "{\n  \"at\": [1, 2, 3],\n  \"lights\": [\n    {\n      \"n\": 1\n    },\n    {\n      \"n\": 2\n  "
          "  }\n  ]\n}\n");
    CHECK(json_text(Json::object()) == "{}\n");
    CHECK(json_text(Json::array()) == "[]\n");
}

TEST_CASE("pairs that begin with text make an object, anything else an array", "[json]") {
    CHECK(Json{{"x", 1}, {"y", 2}}.is_object());
    CHECK(Json{{1, 2}, {3, 4}}.is_array());
    CHECK(Json{1, 2, 3}.is_array());
    CHECK(Json{{"x", 1}, 2}.is_array());
}

TEST_CASE("text that is not JSON or is nested deeper than 64 levels is refused", "[json]") {
    const auto is_read = [](const std::string& text) { return problem_of(read_json(text, "")) == nullptr; };
    for (const char* text :
         {"", "{", "[1,]", "{\"a\":1", "nul", "1 2", "\"\xff\"", "[1e999]", "{1:2}", "// x\n1"})
        CHECK_FALSE(is_read(text));
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    CHECK(is_read(nested(64)));
    CHECK_FALSE(is_read(nested(65)));
    CHECK_FALSE(is_read(std::string(8'000'000, '[')));
}

TEST_CASE("an object has at most 4096 keys, although a text may have more values", "[json]") {
    const auto object_of = [](int keys) {
        std::string text = "{\"a\": 0";
        for (int i = 1; i < keys; ++i) text += ", \"" + std::to_string(i) + "\": 0";
        return text + "}";
    };
    CHECK(problem_of(read_json(object_of(4096), "f")) == nullptr);
    const Result<Json> refused = read_json(object_of(4097), "f");
    REQUIRE(problem_of(refused) != nullptr);
    CHECK(problem_of(refused)->text() == "f:1: too many keys; expected at most 4096 in an object");
}

TEST_CASE("numbers are compared by value and keep their written form", "[json]") {
    CHECK(Json(1) == Json(1.0));
    CHECK_FALSE(Json(1) == Json(true));
    CHECK(json_line(1.0) == "1.0");
    CHECK(json_line(-0.0) == "-0.0");
    CHECK(json_line(0.1f) == "0.10000000149011612");  // the float's exact value
    CHECK(json_line(std::numeric_limits<double>::infinity()) == "null");
    CHECK(json_line(std::numeric_limits<std::int64_t>::min()) == "-9223372036854775808");
    CHECK(json_or_null("18446744073709551615").get<double>() == 18446744073709551615.0);
    CHECK(json_line("\xff") == "\"\xEF\xBF\xBD\"");
    // U+001B, 007F, 009B, 00A0, 2027, 2028, 202E, 202F, 2065 to 2069, 206A
    CHECK(json_line("\x1b\x7f\xC2\x9B\xC2\xA0\xE2\x80\xA7\xE2\x80\xA8\xE2\x80\xAE\xE2\x80\xAF") ==
          "\"\\u001b\\u007f\\u009b\xC2\xA0\xE2\x80\xA7\\u2028\\u202e\xE2\x80\xAF\"");
    CHECK(json_line("\xE2\x81\xA5\xE2\x81\xA6\xE2\x81\xA9\xE2\x81\xAA\xF0\x9F\x98\x80") ==
          "\"\xE2\x81\xA5\\u2066\\u2069\xE2\x81\xAA\xF0\x9F\x98\x80\"");
}

TEST_CASE("a problem is printed on one line: file, line, pointer, error, expected input", "[problem]") {
    CHECK(
        Problem{"scene.json", "/lights/2/spot/cutoff_deg", "120 is out of range", "0 to 90, or 180"}.text() ==
        "scene.json: /lights/2/spot/cutoff_deg: 120 is out of range; expected 0 to 90, or 180");
    CHECK(Problem{"scene.json", "", "unexpected \"x\"", "a comma", 7}.text() ==
          "scene.json:7: unexpected \"x\"; expected a comma");
    CHECK(Problem{"", "", "no display", ""}.text() == "no display");
    CHECK(Problem{"", "/npr", "is not drawn yet", ""}.text() == "/npr: is not drawn yet");
}

TEST_CASE("control characters and invalid bytes are escaped, other characters are kept", "[problem]") {
    const auto text_of = [](std::string what) { return Problem{"", "", std::move(what), ""}.text(); };
    CHECK(text_of("a\nb\tc\rd\x1b[0m\x7f") == "a\\nb\\tc\\rd\\x1b[0m\\x7f");
    // Characters that reverse the display order: U+202E and U+2066.
    CHECK(text_of("a\xE2\x80\xAE.\xE2\x81\xA6z") == "a\\xe2\\x80\\xae.\\xe2\\x81\\xa6z");
    CHECK(text_of(std::string("a\0b", 3)) == "a\\x00b");
    CHECK(text_of("π ≤ 4, 茶壺, 😀") == "π ≤ 4, 茶壺, 😀");
    CHECK(text_of("\xff|\xc3|\xc0\xaf|\xed\xa0\x80|\xf5") == "\\xff|\\xc3|\\xc0\\xaf|\\xed\\xa0\\x80|\\xf5");
    CHECK(text_of("\xc2\x85|\xe2\x80\xa8") == "\\xc2\\x85|\\xe2\\x80\\xa8");  // next line, line separator
}

TEST_CASE("a name stays complete and on one line when many characters are escaped", "[problem]") {
    CHECK(on_one_line("").empty());
    CHECK(on_one_line("Left lamp, 茶") == "Left lamp, 茶");
    CHECK(on_one_line("\n\x07\xff") == "\\n\\x07\\xff");
    CHECK(on_one_line(std::string(9000, '\a')).size() == 4 * 9000);
}

TEST_CASE("a long problem is truncated to 4096 bytes and keeps the expected input", "[problem]") {
    for (const std::string& filler :
         {std::string("x"), std::string("\n"), std::string("茶"), std::string("\xff")}) {
        std::string longer;
        while (longer.size() < 100'000) longer += filler;
        for (const Problem& p : {Problem{"scene.json", "/lights", longer, "a number", 3},
                                 Problem{longer, "/lights", "is wrong", "a number"},
                                 Problem{longer, longer, longer, longer, 2'000'000'000}}) {
            const std::string text = p.text();
            CHECK(text.size() + std::string("glint: warning: \n").size() <= 4096);
            CHECK(first_invalid_utf8(text) == text.size());
            CHECK(text.find("…") != std::string::npos);
            CHECK(text.find("; expected ") != std::string::npos);
        }
        const std::string text = Problem{"scene.json", "/lights", longer, "a number", 3}.text();
        CHECK(text.substr(0, 22) == "scene.json:3: /lights:");
        CHECK(text.substr(text.size() - 19) == "; expected a number");
        CHECK(text.size() > 3900);
    }
}

TEST_CASE("each warning is reported once, and those beyond a hundred are counted", "[problem]") {
    WarningList list;
    for (int i = 0; i < 250; ++i)
        for (int twice = 0; twice < 2; ++twice) list.add("warning " + std::to_string(i));
    const Warnings all = list.take();
    REQUIRE(all.size() == 101);
    CHECK(all[0] == "warning 0");
    CHECK(all[99] == "warning 99");
    CHECK(all[100] == "150 more warnings of this kind");
    CHECK(list.take().empty());
    for (int i = 0; i < 100; ++i) list.add("warning " + std::to_string(i));
    CHECK(list.take().size() == 100);
}

TEST_CASE("nearest() finds the intended name", "[problem]") {
    const std::vector<std::string> keys{"name", "type", "space", "position", "spot", "diffuse"};
    CHECK(nearest("positon", keys) == "position");
    CHECK(nearest("POSITION", keys) == "position");
    CHECK(nearest("dffiuse", keys) == "diffuse");
    CHECK(nearest("nmae", keys) == "name");
    // Swapping two neighbours is one edit; changing two letters is two.
    CHECK(nearest("fnoe", {"face", "fone"}) == "fone");
    CHECK(nearest("no_clamp", {"bytes_wrap", "no_clamp_of_cosine"}) == "no_clamp_of_cosine");
    CHECK(nearest(std::string(1'000'000, 'x'), keys) ==
          "name");  // all names are equally far: picks the first, quickly
    CHECK(nearest("", keys) == "name");
    CHECK(nearest("p", {"lobe", "position"}) == "position");
    CHECK(nearest("x", {}).empty());
    CHECK(nearest("KD", {"kd", "KD"}) == "KD");
}
