// The scenes that come with Glint.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "models/scene_file.h"
#include "renderer/renderer.h"
#include "tests/catch.h"

using namespace glint;

namespace {

std::vector<std::string> asset_scenes() {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(GLINT_SOURCE_DIR "/assets/scenes"))
        if (entry.path().extension() == ".json") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace

TEST_CASE("every scene in assets opens and draws without a warning, and fills its picture", "[assets]") {
    const std::vector<std::string> paths = asset_scenes();
    REQUIRE(paths.size() >= 7);
    for (const std::string& path : paths) {
        CAPTURE(path);
        const auto document = open_document(path);
        if (const Problem* problem = problem_of(document)) FAIL(problem->text());
        const auto& opened = std::get<SceneDocument>(document);
        CHECK(opened.warnings.empty());
        Renderer renderer(1);
        renderer.render(opened.scene, {160, 90});
        CHECK(renderer.warnings().empty());
        CHECK(renderer.stats().shaded_pixels > 160 * 90 / 16);
    }
}
