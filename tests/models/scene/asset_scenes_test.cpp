// The scenes that come with Glint.
#include "tests/support/asset_scenes.h"

#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("every scene in assets opens, draws without a warning, and fills its picture", "[assets]") {
    const std::vector<std::string> paths = test::asset_scenes();
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
