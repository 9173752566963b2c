// JSON: written values read back, and invalid texts are refused.
#include "models/json/json.h"

#include <cmath>
#include <limits>

#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("a JSON value reads back equal from both of its text forms", "[json]") {
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
