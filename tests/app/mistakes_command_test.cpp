// glint mistakes, as a user runs it.
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

TEST_CASE("glint mistakes lists what a scene can switch on, as text and as JSON", "[cli][mistakes]") {
    const Ended text = run_glint({"mistakes"}), json = run_glint({"mistakes", "--format", "json"});
    REQUIRE(text.status == 0);
    REQUIRE(json.status == 0);
    const auto all = nlohmann::json::parse(json.out)["mistakes"];
    CHECK(all.size() == 52);
    std::string scene = R"({"glint": 1, "shading": {"mistakes": {)";
    for (const auto& mistake : all) {
        const std::string name = mistake["name"];
        CAPTURE(name);
        CHECK(text.out.find("\n  " + name + "\n    " + std::string(mistake["does"])) != std::string::npos);
        for (const std::string source : mistake["sources"])  // a comma belongs to a title, not between two
            CHECK(text.out.find(source) != std::string::npos);
        scene += (scene.back() == '{' ? "\"" : ", \"") + name + "\": true";
    }
    CHECK(run_glint({"info", "-"}, scene + "}}}").status == 0);
}

TEST_CASE("a pixel that is no number is explained as JSON all the same, and black in bytes",
          "[cli][mistakes]") {
    const char* const ball =
        R"({"glint": 1, "lights": [{"type": "directional", "position": [0.6, 0, 0.8, 0]}],
        "objects": [{"mesh": {"primitive": "sphere"}, "material": {"shininess": 0}}],
        "shading": {"mistakes": {"power_zero_is_nan": true}}})";
    int black = 0;
    for (int x = 30; x < 48; x += 1) {
        const Ended ended = run_glint(
            {"explain", "-", "--pixel", std::to_string(x) + ",32", "--size", "64x64", "--format", "json"},
            ball);
        REQUIRE(ended.status == 0);
        const auto e = nlohmann::json::parse(ended.out);
        if (!e["sum"].is_array() || !e["sum"][0].is_null()) continue;
        CHECK(e["byte"] == nlohmann::json({0, 0, 0}));
        ++black;
    }
    CHECK(black > 0);
}
