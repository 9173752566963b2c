// How much of a highlight a coarse mesh keeps, shown next to the mesh.
#include "models/scene_file/scene_file.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "ui/fields/panels.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

constexpr PictureSize size{320, 180};

SceneDocument lost_highlight() {
    return std::get<SceneDocument>(open_document(project_file("assets/scenes/lost-highlight.json")));
}

Scene with_detail(int detail) {
    const Assignment set{"/objects/0/mesh/detail", std::to_string(detail)};
    return std::get<Scene>(scene_variant(lost_highlight(), {set}));
}

}  // namespace

TEST_CASE("a plate with no corners in the cone loses its highlight; one with many keeps it",
          "[ui][highlight]") {
    // A plate of one square has corners 1.84 from its middle; the cone's radius on it is 1.9 tan 28° = 1.01.
    CHECK(highlight_share(with_detail(1), 0, size).value() == 0);
    const double some = highlight_share(with_detail(6), 0, size).value();
    CHECK(some > 0.05);
    CHECK(some < 0.95);
    CHECK(highlight_share(with_detail(64), 0, size).value() == Approx(1).margin(0.03));
    Scene phong = with_detail(1);
    phong.shading.mode = ShadingMode::Phong;
    CHECK(highlight_share(phong, 0, size).value() == 1);
    Scene matte = with_detail(64);
    matte.objects[0].material.specular = glm::vec3(0);
    CHECK_FALSE(highlight_share(matte, 0, size));
}

TEST_CASE("the highlight's share is shown next to a mesh that is lit at its corners",
          "[ui][window][highlight]") {
    HeadlessWindow bench;
    bench.state.editor.document = lost_highlight();
    bench.frames(2);
    HighlightShareState& kept = bench.state.get<HighlightShareState>();
    const auto words = [&] { return highlight_words(kept, bench.scene(), 0, size); };
    CHECK(words() == "Highlight: 0.00 of what Phong shading shows");
    bench.scene() = with_detail(64);
    CHECK(words().find("nearly complete") != std::string::npos);
    bench.scene().shading.mode = ShadingMode::Phong;
    CHECK(words().empty());
}
