// The picture fills an area of any shape, and shows everything that the command line shows.
#include <glm/geometric.hpp>

#include "models/scene_file/scene_file.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/headless_inspector.h"
#include "ui/features/export/export_picture.h"
#include "ui/picture/draw_picture.h"

using namespace glint;
using namespace glint::test;

namespace {

const ImVec2 windows[] = {{1024, 768}, {1280, 800}, {1920, 1080}, {700, 1000}};

PictureView view_in(HeadlessWindow& bench) {
    return picture_view(lay_out(ImGui::GetIO().DisplaySize, bench.state.layout, 1).centre, bench.state);
}

/// The position of a point, -1 to 1 from edge to edge; nullopt behind the eye.
std::optional<glm::dvec2> on_picture(const Camera& camera, PictureSize size, glm::dvec3 world) {
    const glm::dvec4 clip =
        clip_from_view(camera.projection, size) * view_from_world(camera) * glm::dvec4(world, 1);
    if (clip.w <= 0) return {};
    return glm::dvec2(clip) / clip.w;
}
bool is_seen(std::optional<glm::dvec2> at) {
    return at && std::abs(at->x) <= 1 + 1e-6 && std::abs(at->y) <= 1 + 1e-6;
}

/// Corners of the bounds of every object.
std::vector<glm::dvec3> bounds_corners(const Scene& scene) {
    std::vector<glm::dvec3> all;
    for (const Object& object : scene.objects)
        for (const glm::dvec3& corner : corners_of(object.mesh->bounds))
            all.emplace_back(world_from_object(object.transform) * glm::dvec4(corner, 1));
    return all;
}

}  // namespace

TEST_CASE("at every size the window contains the command line's picture of a shipped scene", "[ui][scenes]") {
    int whole = 0;
    for (const std::string& path : asset_scenes()) {
        CAPTURE(path);
        Result<SceneDocument> opened = open_document(path);
        REQUIRE(problem_of(opened) == nullptr);
        const Scene scene = std::get<SceneDocument>(opened).scene;
        for (const ImVec2 window : windows) {
            CAPTURE(window.x, window.y);
            HeadlessWindow bench(window);
            take_document(bench.state.editor, std::get<SceneDocument>(opened));
            const PictureSize shown = view_in(bench).map.size;
            int seen = 0, all = 0, lost = 0;
            for (const glm::dvec3& corner : bounds_corners(scene)) {
                const bool by_command = is_seen(on_picture(scene.camera, {1280, 720}, corner));
                lost += by_command && !is_seen(on_picture(scene.camera, shown, corner));
                seen += by_command;
                ++all;
            }
            CHECK(lost == 0);
            whole += seen == all;
        }
    }
    CHECK(whole > 40);
}

TEST_CASE("the picture fills its area except for a margin", "[ui]") {
    for (const ImVec2 window : windows) {
        HeadlessWindow bench(window);
        const Rect room = lay_out(window, bench.state.layout, 1).centre;
        const ImVec2 picture = picture_area(room, 1).size();
        CHECK(room.size().x - picture.x <= 21);
        CHECK(room.size().y - picture.y <= 21);
    }
}

TEST_CASE("a picture narrower than 16:9 keeps the width of the view, a wider one its height", "[camera]") {
    for (const Projection& projection : {Projection(Perspective{50}), Projection(Orthographic{3})}) {
        const glm::dmat4 composed = clip_from_view(projection, {1600, 900});
        for (const PictureSize narrow : {PictureSize{400, 300, true}, {300, 300, true}, {100, 700, true}}) {
            const glm::dmat4 m = clip_from_view(projection, narrow);
            CHECK(m[0][0] == Approx(composed[0][0]).epsilon(1e-6));
            CHECK(m[1][1] == Approx(m[0][0] * narrow.width / narrow.height).epsilon(1e-6));
        }
        const PictureSize wide{2000, 900, true}, plain{400, 300};
        CHECK(clip_from_view(projection, wide)[1][1] == composed[1][1]);
        CHECK(clip_from_view(projection, plain)[1][1] == composed[1][1]);
    }
    const Projection frustum = Frustum{};
    CHECK(clip_from_view(frustum, {100, 700, true}) == clip_from_view(frustum, {100, 700}));
}

TEST_CASE("an exported picture has the visible field of view", "[ui]") {
    Scene scene = first_scene().scene;
    const PictureSize narrow{400, 300};
    const Scene shown = as_shown(scene, narrow);
    CHECK(clip_from_view(shown.camera.projection, narrow) ==
          clip_from_view(scene.camera.projection, {400, 300, true}));
    CHECK(as_shown(scene, {1920, 1080}) == scene);
}

TEST_CASE("the picked point stays the same surface point in every picture shape", "[ui]") {
    DrawnWindow bench;
    bench.click(bench.at_pixel(
        {double(bench.state.rendered->size.width) * 0.45, double(bench.state.rendered->size.height) * 0.45}));
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation);
    REQUIRE(bench.state.on_screen.explanation->hit);
    const glm::vec3 picked = bench.state.on_screen.explanation->spaces.world;
    for (const Key key : {Key::F9, Key::F11, Key::F10}) {
        bench.key(key);
        bench.frames(3);
        REQUIRE(bench.state.on_screen.explanation);
        CHECK(glm::length(bench.state.on_screen.explanation->spaces.world - picked) <
              0.01);  // half a pixel is 0.003
    }
    ImGui::GetIO().DisplaySize = {1000, 900};
    bench.frames(3);
    CHECK(glm::length(bench.state.on_screen.explanation->spaces.world - picked) < 0.01);
}

TEST_CASE("the edges of the columns can be dragged, and reset by a double-click", "[ui]") {
    HeadlessWindow bench;
    bench.frames(3);
    bench.drag({280, 400}, {330, 400});
    CHECK(bench.state.layout.left_width == Approx(330).margin(4));
    const float before = bench.state.layout.right_width, right = 1280 - before;
    bench.drag({right, 400}, {right - 60, 400});
    CHECK(bench.state.layout.right_width == Approx(before + 60).margin(4));
}

TEST_CASE("in projector mode the equation stays, and the scene list makes room", "[ui]") {
    for (const ImVec2 window : {ImVec2(1280, 800), ImVec2(1920, 1080)}) {
        DrawnWindow bench(window);
        const LayoutState before = bench.state.layout;
        bench.key(Key::F9);
        const Layout shown = lay_out(window, bench.state.layout, 1);
        CHECK((shown.has_right || (shown.has_left && bench.state.left_shows_inspector)));
        CHECK_FALSE((shown.has_left && shown.has_right));
        bench.key(Key::F9);
        CHECK(bench.state.layout == before);
    }
}

TEST_CASE("in a narrow window the scene column and the WHY column replace each other", "[ui]") {
    DrawnWindow bench({1000, 760});
    const WindowCommand &scene = command_named("Scene column"), &why = command_named("Why column");
    REQUIRE(scene.is_on(bench.state));
    why.run(bench.state);
    CHECK(why.is_on(bench.state));
    CHECK_FALSE(scene.is_on(bench.state));
    scene.run(bench.state);
    CHECK(scene.is_on(bench.state));
    CHECK(lay_out({1000, 760}, bench.state.layout, 1).has_left);
}

TEST_CASE("a frozen picture keeps its handles in place while the scene is edited", "[ui]") {
    HeadlessWindow bench;
    bench.frames(3);
    bench.state.viewport.touched = true;  // the first hint has been read
    bench.key(Key::F8);
    bench.frames(2);
    const auto drawn = [&bench] {
        bench.frames(1);
        std::vector<ImVec2> places;
        for (const ImDrawList* list :
             std::span(ImGui::GetDrawData()->CmdLists, ImGui::GetDrawData()->CmdListsCount))
            if (std::string_view(list->_OwnerName) == "##view")
                for (const ImDrawVert& v : list->VtxBuffer) places.push_back(v.pos);
        return places;
    };
    const auto before = drawn();
    bench.scene().lights[1].position.x += 0.7f;
    bench.scene().camera.eye.x += 1;
    bench.key(Key::L, false, true);  // adds a light and selects it
    bench.frames(2);
    const auto after = drawn();
    REQUIRE(before.size() == after.size());
    bool same = true;
    for (std::size_t i = 0; i < before.size(); ++i)
        same = same && before[i].x == after[i].x && before[i].y == after[i].y;
    CHECK(same);
    bench.key(Key::F8);
    CHECK(drawn().size() != 0);
}

TEST_CASE("the copy of unsaved work is not offered during a presentation", "[ui]") {
    // tests/ui/document/unsaved_work_test.cpp checks that it is offered otherwise.
    HeadlessWindow bench;
    bench.state.persistence.orphans.push_back({{"a.autosave", nullptr}, "x.json", "14:05"});
    const auto offers = [&bench] {
        bench.frames(2);
        return std::any_of(bench.controls().begin(), bench.controls().end(),
                           [](const NamedControl& c) { return c.name == "Recover"; });
    };
    CHECK(offers());
    for (const Key key : {Key::F9, Key::F10, Key::F11, Key::F8, Key::W}) {
        const bool shift = key == Key::W;
        bench.key(key, false, shift);
        CHECK_FALSE(offers());
        bench.key(key, false, shift);
        CHECK(offers());
    }
    bench.state.get<AnimateState>().open = true;  // its panel is in the same place
    CHECK_FALSE(offers());
    bench.state.get<AnimateState>().open = false;
    // Where the left column leaves the picture little room, the offer is not cut off.
    ImGui::GetIO().DisplaySize = {640, 500};
    REQUIRE(offers());
    CHECK(lay_out(ImGui::GetIO().DisplaySize, bench.state.layout, 1).has_left);
    const ImGuiWindow* const offer = test::window_named("##recovery");
    REQUIRE(offer != nullptr);
    CHECK(offer->Pos.x + offer->Size.x <= 640);
}
