// glint diagnose as a user runs it.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;
using nlohmann::json;

namespace {

const char* const balls = R"({"glint": 1, "objects": [
    {"mesh": {"primitive": "sphere", "detail": 24}, "transform": {"translate": [-1, 0, 0], "scale": [1, 0.7, 1]}},
    {"mesh": {"primitive": "torus", "detail": 24}, "transform": {"translate": [1.2, 0, 0], "rotate_deg": [60, 0, 0]}}],
    "lights": [{"name": "Bulb", "position": [2, 3, 4]}]})";

struct Files {
    TemporaryDirectory directory;
    std::string scene = directory.file("scene.json", balls);

    std::string drawn(const std::string& name, const std::vector<std::string>& options) const {
        std::vector<std::string> line{"render", scene, "--size", "160x120", "-o", directory.path(name)};
        line.insert(line.end(), options.begin(), options.end());
        REQUIRE(run_glint(line).status == 0);
        return directory.path(name);
    }
};

}  // namespace

TEST_CASE("glint diagnose names a mistake in a PNG, a PFM and an EXR", "[cli][diagnose]") {
    const Files files;
    for (const char* name : {"wrong.png", "wrong.pfm", "wrong.exr"}) {
        const std::string wrong = files.drawn(name, {"--set", "/shading/mistakes/normals_flipped=true"});
        const Ended ended = run_glint({"diagnose", files.scene, wrong, "--format", "json"});
        REQUIRE(ended.status == 0);
        CHECK(ended.err.empty());
        const json answer = json::parse(ended.out);
        CHECK(answer["verdict"] == "mistake");
        CHECK(answer["display"] == json::object());
        const json& first = answer["candidates"][0];
        CHECK(first["name"] == "normals_flipped");
        CHECK(first["also"].is_array());
        CHECK(first["explained"] == 1);
        CHECK(first["residual"] == 0);
        CHECK(first["mine"] == first["as_mistaken"]);
        CHECK(first["mine"] != first["reference"]);
        CHECK(answer["experiment"]["set"].size() == 1);
        CHECK(answer["experiment"]["shows"].size() >= 2);
    }
}

TEST_CASE("glint diagnose says what it found in at most five lines", "[cli][diagnose]") {
    const Files files;
    const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
    const std::string right = files.drawn("right.png", {"--set", "/display/exposure=0.8"});
    const Ended same = run_glint({"diagnose", files.scene, right});
    CHECK(same.status == 0);
    CHECK(same.out ==
          "No mistake: the picture shows the scene as Glint does.\n"
          "Taken away first, as no mistake of lighting: all brightness times 0.8.\n");
    const std::string wrong = files.drawn("wrong.png", {"--set", "/shading/mistakes/normals_flipped=true"});
    const Ended mistake = run_glint({"diagnose", files.scene, wrong, "--pairs"});
    CHECK(mistake.status == 0);
    CHECK(mistake.out.starts_with("Mistake: normals_flipped. Every normal points inwards"));
    CHECK(lines(mistake.out) <= 5);
}

TEST_CASE("glint diagnose writes a sheet of four pictures", "[cli][diagnose]") {
    const Files files;
    const std::string wrong = files.drawn("wrong.png", {"--set", "/shading/mistakes/normals_flipped=true"});
    const std::string out = files.directory.path("sheet.png");
    REQUIRE(run_glint({"diagnose", files.scene, wrong, "-o", out}).status == 0);
    const auto sheet = read_png(out);
    REQUIRE(problem_of(sheet) == nullptr);
    CHECK(std::get<Picture>(sheet).size.width > 4 * 160);
    CHECK(std::get<Picture>(sheet).size.width < 5 * 160);
}

TEST_CASE("glint diagnose refuses bad input in one line", "[cli][diagnose][bad-input]") {
    const Files files;
    const auto check = [](const Ended& ended, int status, const std::string& line) {
        CHECK(ended.status == status);
        CHECK(ended.out.empty());
        CHECK(ended.err == "glint: error: " + line + "\n");
    };
    check(run_glint({"diagnose", files.scene}), 2,
          "PICTURE: is missing; expected a picture of the scene that another program drew");
    check(run_glint({"diagnose", files.scene, files.scene}), 1,
          files.scene + ": cannot be read; expected a picture whose name ends in .png, .pfm or .exr");
    const std::string wrong = files.drawn("wrong.png", {});
    check(run_glint({"diagnose", files.scene, wrong, "--format", "csv"}), 2,
          "--format: csv is not known; expected text, json");
    check(run_glint({"diagnose", files.scene, wrong, "-o", "sheet.jpg"}), 2,
          "-o: sheet.jpg cannot be written; expected a name that ends in .png");
    const std::string bytes = bytes_of(wrong);
    const std::string cut = files.directory.file("cut.png", bytes.substr(0, bytes.size() / 2));
    const Ended corrupt = run_glint({"diagnose", files.scene, cut});
    CHECK(corrupt.status == 1);
    CHECK(corrupt.out.empty());
    CHECK(corrupt.err.starts_with("glint: error: " + cut + ": cannot be read as a PNG"));
    CHECK(std::count(corrupt.err.begin(), corrupt.err.end(), '\n') == 1);
}
