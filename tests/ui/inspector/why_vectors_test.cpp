// The vectors at the picked point: explained without a click, drawn in the right place, built up step by
// step.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <string>

#include "models/scene_file/scene_file.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/vectors/arrows.h"
#include "ui/features/inspector/vectors/vectors_tab.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

/// All vertices drawn in the last frame over the picture.
std::vector<ImVec2> drawn_corners() {
    std::vector<ImVec2> corners;
    const ImDrawData* data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i)
        for (const ImDrawVert& v : data->CmdLists[i]->VtxBuffer) corners.push_back(v.pos);
    return corners;
}

bool draws_near(ImVec2 at, float within) {
    for (const ImVec2& corner : drawn_corners())
        if (std::hypot(corner.x - at.x, corner.y - at.y) < within) return true;
    return false;
}

}  // namespace

TEST_CASE("Alt explains the pixel under the cursor, on release, the picked pixel returns",
          "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Equation, {0.5, 0.5});
    const int x = bench.state.on_screen.explanation->x;
    ImGui::GetIO().KeyAlt = true;
    bench.move(bench.at_pixel({220.5, 260.5}));
    bench.frames(1);
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.on_screen.explanation->x == 220);
    CHECK(bench.state.on_screen.explanation->y == 260);
    CHECK(bench.state.viewport.probe->x == Approx(0.5));
    ImGui::GetIO().KeyAlt = false;
    bench.frames(2);
    CHECK(bench.state.on_screen.explanation->x == x);
}

TEST_CASE("without a picked pixel, Alt explains the hovered one only while held", "[ui][window][why]") {
    DrawnWindow bench;
    ImGui::GetIO().KeyAlt = true;
    bench.move(bench.at_pixel({300.5, 240.5}));
    bench.frames(1);
    CHECK(bench.state.on_screen.explanation.has_value());
    ImGui::GetIO().KeyAlt = false;
    bench.frames(1);
    CHECK_FALSE(bench.state.on_screen.explanation.has_value());
}

TEST_CASE("the arrow n ends where a normal of its length would end", "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Vectors, {0.42, 0.4});
    const Scene start = bench.scene();
    const ExplainedPoint& point = bench.state.on_screen.explanation->at;
    const ScreenMap map = screen_map(bench.scene().camera, bench.state.rendered->size);
    // 92 logical pixels at the point's depth, computed from the field of view without the drawing code.
    const double depth = -double(point.point.camera.z);
    // In a picture narrower than 16:9 the width of the view is that of 16:9.
    const double per_pixel =
        2 * depth * std::tan(0.5 * 45 * 3.14159265358979 / 180) * 16 / 9 / map.size.width;
    const glm::dvec3 tip = glm::dvec3(point.point.world) + 92 * per_pixel * glm::dvec3(point.normal.world);
    const ImVec2 at = bench.at_pixel(project(map, tip).pixel);
    CHECK(draws_near(at, 1.5f));
    bench.state.get<InspectorState>().shows_vectors = false;
    bench.frames(2);
    CHECK_FALSE(draws_near(at, 1.5f));
    CHECK(bench.scene() == start);
}

TEST_CASE("the facet's edges and normal are those of the mesh, and match each other", "[ui][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Vectors, {0.45, 0.4});
    const auto facet = picked_facet(*bench.state.on_screen.explanation, bench.scene());
    REQUIRE(facet);
    REQUIRE(facet->corners.size() == 4);
    CHECK(glm::dot(facet->of_edges, facet->newell) > 0.9999f);
    CHECK(std::abs(glm::dot(facet->cross, facet->edge_a)) < 1e-6f);
    CHECK(std::abs(glm::dot(facet->cross, facet->edge_b)) < 1e-6f);
    // The facet's normal points away from the ball's centre.
    CHECK(glm::dot(facet->newell, facet->corners.front()) > 0);
    Explanation background;
    CHECK_FALSE(picked_facet(background, bench.scene()));
}

TEST_CASE("a facet's outline is clipped where it passes behind the eye", "[ui][window][why]") {
    HeadlessWindow bench;
    Scene& scene = bench.scene();
    scene.camera.eye = {0, 0.5f, 0};
    scene.camera.target = {0, 0, -2};
    auto mesh = std::make_shared<Mesh>();  // one face below the eye, 4 wide, from z = -10 to z = 10
    mesh->positions = {{-2, 0, 10}, {2, 0, 10}, {2, 0, -10}, {-2, 0, -10}};
    mesh->first_corner = {0, 4};
    mesh->corner_position = {0, 1, 2, 3};
    finish_mesh(*mesh);
    scene.objects.resize(1);
    scene.objects[0] = Object{};
    scene.objects[0].mesh = mesh;
    test::ask(bench, InspectorTab::Vectors);
    REQUIRE(bench.state.on_screen.explanation->hit);
    const PictureView view = picture_view(window_layout(bench.state).centre, bench.state);
    const glm::dvec3 back_left{-2, 0, 10}, far_left{-2, 0, -10}, far_right{2, 0, -10};
    REQUIRE_FALSE(project(view.map, back_left).in_front);
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushClipRectFullScreen();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    draw_facet(list, bench.state, view);
    const auto nearest = [&list](ImVec2 to) {
        float distance = HUGE_VALF;
        for (const ImDrawVert& v : list.VtxBuffer)
            distance = std::min(distance, std::hypot(v.pos.x - to.x, v.pos.y - to.y));
        return distance;
    };
    CHECK(nearest(view.to_window({0, 0})) > 50);
    CHECK(nearest(view.shown(far_left)) < 3);
    CHECK(nearest(view.shown(far_right)) < 3);
    // The left edge leaves the picture at the bottom before it is clipped.
    const ImVec2 on_edge = view.shown({-2, 0, -0.01});
    CHECK(on_edge.y > view.end().y);
}

TEST_CASE("the steps of r and the length of n are settings of the window, not of the scene",
          "[ui][window][why]") {
    HeadlessWindow bench({1280, 1200});
    test::ask(bench, InspectorTab::Vectors, {0.45, 0.4});
    const Scene start = bench.scene();
    for (int step = 0; step <= 4; ++step) {
        bench.state.get<InspectorState>().mirror_step = step;
        bench.state.get<InspectorState>().normal_length = 2;
        bench.state.get<InspectorState>().shows_facet = true;
        bench.frames(2);
    }
    CHECK(bench.scene() == start);
    CHECK_FALSE(bench.state.editor.history.can_undo());
}

TEST_CASE("the vectors show the selected light, or otherwise the main light", "[ui][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Vectors, {0.62, 0.35});
    bench.state.editor.selection = {Selection::Kind::Light, 1};
    const ExplainedPoint& point = bench.state.on_screen.explanation->at;
    CHECK(asked_light(bench.state, point)->index == 1);
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    CHECK(asked_light(bench.state, point)->index == 0);
    bench.state.get<InspectorState>().pointed_light = 1;
    CHECK(asked_light(bench.state, point)->index == 1);
    CHECK(asked_light(bench.state, ExplainedPoint{}) == nullptr);
}

TEST_CASE("a Gouraud pixel's corners are drawn at their positions", "[ui][window][why]") {
    HeadlessWindow bench;
    bench.scene().shading.mode = ShadingMode::Gouraud;
    test::ask(bench, InspectorTab::Equation, {0.45, 0.4});
    const ScreenMap map = screen_map(bench.scene().camera, bench.state.rendered->size);
    REQUIRE(bench.state.on_screen.explanation->corners.size() == 3);
    for (const ExplainedCorner& corner : bench.state.on_screen.explanation->corners) {
        const ImVec2 at = bench.at_pixel(project(map, glm::dvec3(corner.at.point.world)).pixel);
        CHECK(draws_near(at, 6));
    }
}

TEST_CASE("the letters of nearly collinear vectors do not overlap each other or arrows",
          "[ui][window][why]") {
    HeadlessWindow bench;
    bench.scene().shading.reflection = Reflection::BlinnPhong;
    // v is seen end on, and h is between l and v: its letter would cover the arrow of l.
    bench.scene().lights.resize(1);
    bench.scene().lights[0].kind = LightKind::Directional;
    bench.scene().lights[0].position = {-1, 0.3f, 0.1f, 0};
    test::ask(bench, InspectorTab::Vectors, {0.38, 0.4});
    bench.frames(1);
    std::vector<Rect> letters;
    for (const NamedControl& control : bench.controls())
        if (control.name == "Letter of a vector") letters.push_back(control.at);
    REQUIRE(letters.size() == 4);  // h, l, v, n
    for (std::size_t i = 0; i < letters.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const Rect &a = letters[i], &b = letters[k];
            const bool apart =
                a.high.x <= b.low.x || b.high.x <= a.low.x || a.high.y <= b.low.y || b.high.y <= a.low.y;
            CHECK(apart);
        }
    const ExplainedPoint& point = bench.state.on_screen.explanation->at;
    const ScreenMap map = screen_map(bench.scene().camera, bench.state.rendered->size);
    const double depth = -double(point.point.camera.z);
    const double reach = 92 * 2 * depth * std::tan(0.5 * 45 * 3.14159265358979 / 180) / map.size.height;
    const glm::dvec3 foot(point.point.world);
    for (const glm::vec3 v :
         {point.lights[0].l.world, point.lights[0].h.world, point.view.world, point.normal.world})
        for (double share = 0.2; share < 0.95; share += 0.05) {
            const glm::dvec2 at = project(map, foot + share * reach * glm::dvec3(v)).pixel;
            for (const Rect& letter : letters) CHECK_FALSE(letter.holds(bench.at_pixel(at)));
        }
}

TEST_CASE("the pixel's heading follows the cursor only over the picture", "[ui][why]") {
    DrawnWindow bench({1280, 800});
    ImGui::GetIO().KeyAlt = true;
    bench.move(bench.at_pixel({100, 100}));
    bench.frames(2);
    CHECK(asks_at_cursor(bench.state));
    bench.move({1200, 400});  // over the column
    bench.frames(2);
    CHECK_FALSE(asks_at_cursor(bench.state));
    ImGui::GetIO().KeyAlt = false;
}
