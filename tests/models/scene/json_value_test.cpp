// JSON as a value: what is written reads back, what is not JSON is nothing, and no text is too deep.
#include "models/json/json_value.h"

#include <cmath>
#include <limits>

#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("a JSON value reads back equal from both of its texts", "[json]") {
    JsonValue json{
        {"name", "Kugel \"1\" ✓"}, {"on", true}, {"none", JsonValue()}, {"share", 0.1}, {"count", 3}};
    json["list"] = JsonValue::array();
    json["list"].push_back({1, 2.5, "x"});
    json["empty"] = JsonValue::object();
    CHECK(JsonValue::parse(json.text()) == json);
    CHECK(JsonValue::parse(json_text(json)) == json);
    CHECK(
        json.text() ==
        R"({"name":"Kugel \"1\" ✓","on":true,"none":null,"share":0.1,"count":3,"list":[[1,2.5,"x"]],"empty":{}})");
}

TEST_CASE("as Glint prints JSON, members stand one a line and plain values on one", "[json]") {
    const JsonValue json{{"at", {1, 2, 3}}, {"lights", {JsonValue{{"n", 1}}, JsonValue{{"n", 2}}}}};
    CHECK(json_text(json) ==
          "{\n  \"at\": [1, 2, 3],\n  \"lights\": [\n    {\n      \"n\": 1\n    },\n    {\n      \"n\": 2\n  "
          "  }\n  ]\n}\n");
    CHECK(json_text(JsonValue::object()) == "{}\n");
    CHECK(json_text(JsonValue::array()) == "[]\n");
}

TEST_CASE("pairs that begin with text make an object, anything else an array", "[json]") {
    CHECK(JsonValue{{"x", 1}, {"y", 2}}.is_object());
    CHECK(JsonValue{{1, 2}, {3, 4}}.is_array());
    CHECK(JsonValue{1, 2, 3}.is_array());
    CHECK(JsonValue{{"x", 1}, 2}.is_array());
}

TEST_CASE("what is not JSON, or nested deeper than 64, is nothing", "[json]") {
    for (const char* text :
         {"", "{", "[1,]", "{\"a\":1", "nul", "1 2", "\"\xff\"", "[1e999]", "{1:2}", "// x\n1"})
        CHECK_FALSE(JsonValue::parse(text));
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    CHECK(JsonValue::parse(nested(64)));
    CHECK_FALSE(JsonValue::parse(nested(65)));
    CHECK_FALSE(JsonValue::parse(std::string(8'000'000, '[')));
}

TEST_CASE("of two members of one name the last counts, where the first stood", "[json]") {
    const auto json = JsonValue::parse(R"({"a": 1, "b": {"a": 5, "c": []}, "a": 3})");
    REQUIRE(json);
    CHECK(json->text() == R"({"a":3,"b":{"a":5,"c":[]}})");
}

TEST_CASE("numbers are equal by their value and stay as they are in text", "[json]") {
    CHECK(JsonValue(1) == JsonValue(1.0));
    CHECK_FALSE(JsonValue(1) == JsonValue(true));
    CHECK(JsonValue(1.0).text() == "1.0");
    CHECK(JsonValue(-0.0).text() == "-0.0");
    CHECK(JsonValue(0.1f).text() == "0.10000000149011612");  // the double that the float is
    CHECK(JsonValue(std::numeric_limits<double>::infinity()).text() == "null");
    CHECK(JsonValue(std::numeric_limits<std::int64_t>::min()).text() == "-9223372036854775808");
    const auto large = JsonValue::parse("18446744073709551615");
    REQUIRE(large);
    CHECK(large->number() == 18446744073709551615.0);
    CHECK(JsonValue("short").memory() == 0);
    CHECK(JsonValue(std::string(1000, 'x')).memory() == 1001);
    CHECK(JsonValue(std::vector<int>(1000)).memory() == 1000 * sizeof(JsonValue));
    CHECK(JsonValue({{std::string(1000, 'n'), std::vector<int>(10)}}).memory() >
          10 * sizeof(JsonValue) + 1000);
    CHECK(JsonValue("\xff").text() == "\"\xEF\xBF\xBD\"");
    // U+001B, 007F, 009B, 00A0, 2027, 2028, 202E, 202F, 2065 to 2069, 206A
    CHECK(JsonValue("\x1b\x7f\xC2\x9B\xC2\xA0\xE2\x80\xA7\xE2\x80\xA8\xE2\x80\xAE\xE2\x80\xAF").text() ==
          "\"\\u001b\\u007f\\u009b\xC2\xA0\xE2\x80\xA7\\u2028\\u202e\xE2\x80\xAF\"");
    CHECK(JsonValue("\xE2\x81\xA5\xE2\x81\xA6\xE2\x81\xA9\xE2\x81\xAA\xF0\x9F\x98\x80").text() ==
          "\"\xE2\x81\xA5\\u2066\\u2069\xE2\x81\xAA\xF0\x9F\x98\x80\"");
}
