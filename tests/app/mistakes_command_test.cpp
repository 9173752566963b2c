// Tests of glint mistakes as a user runs it.
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

TEST_CASE("glint mistakes lists the catalogue as text and as JSON", "[cli][mistakes]") {
    const Ended text = run_glint({"mistakes"}), json = run_glint({"mistakes", "--format", "json"});
    REQUIRE(text.status == 0);
    REQUIRE(json.status == 0);
    const auto all = nlohmann::json::parse(json.out)["mistakes"];
    CHECK(all.size() == 79);
    std::string scene = R"({"glint": 1, "shading": {"mistakes": {)";
    for (const auto& mistake : all) {
        const std::string name = mistake["name"];
        CAPTURE(name);
        CHECK(text.out.find("\n  " + name + "\n    " + std::string(mistake["does"])) != std::string::npos);
        for (const std::string source : mistake["sources"])  // a comma is part of a title, not a separator
            CHECK(text.out.find(source) != std::string::npos);
        scene += (scene.back() == '{' ? "\"" : ", \"") + name + "\": true";
    }
    CHECK(run_glint({"info", "-"}, scene + "}}}").status == 0);
}

namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns {a, b} for "--set 'a' --set 'b'".
std::vector<std::string> settings_in(const std::string& line) {
    std::vector<std::string> words;
    const std::regex form("--set '([^']*)'");
    for (std::sregex_iterator at(line.begin(), line.end(), form), end; at != end; ++at)
        words.insert(words.end(), {"--set", (*at)[1].str()});
    return words;
}

}  // namespace

TEST_CASE("docs/diagnose.md shows every mistake as it is currently drawn", "[cli][mistakes][docs][release]") {
    const std::string docs = project_file("docs/");
    const std::string page = text_of(docs + "diagnose.md");
    const std::string pictures = docs + "pictures/museum/";
    const TemporaryDirectory directory;
    const auto all = nlohmann::json::parse(run_glint({"mistakes", "--format", "json"}).out)["mistakes"];
    for (const auto& mistake : all) {
        const std::string name = mistake["name"];
        CAPTURE(name);
        const std::size_t begin = page.find("\n### " + name + "\n");
        REQUIRE(begin != std::string::npos);
        const std::string entry = page.substr(begin, page.find("\n### ", begin + 1) - begin);
        CHECK(entry.find(std::string(mistake["does"]) + " **" + std::string(mistake["looks"]) + "**") !=
              std::string::npos);
        for (const std::string alike : mistake["look_alikes"])
            CHECK(entry.find("[`" + alike + "`]") != std::string::npos);
        const std::string drawn = directory.path(name + ".png");
        std::vector<std::string> line{"render", docs + "museum.json", "--size", "288x216", "-o", drawn};
        const auto settings = settings_in(entry.substr(0, entry.find("Looks like")));
        CHECK(settings.back() == "/shading/mistakes/" + name + "=true");
        line.insert(line.end(), settings.begin(), settings.end());
        REQUIRE(run_glint(line).status == 0);
        std::string shown = pictures;
        shown.append(name).append(".png");
        CHECK(nlohmann::json::parse(run_glint({"compare", shown, drawn}).out)["max_error"] == 0);
    }
}

TEST_CASE("a NaN pixel can be explained as JSON, and is black in the picture", "[cli][mistakes]") {
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
