// The scan-line scope: it plots what `glint profile` prints, for the picture on the screen.
#include "ui/features/views/scope.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/document/document_actions.h"
#include "ui/features/plots/plot.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

/// Draws the scope's line across the ball.
HeadlessWindow& with_line(HeadlessWindow& bench) {
    bench.frames(2);
    bench.key(Key::P);
    bench.frames(1);
    const PictureSize size = bench.state.rendered->size;
    bench.drag(bench.at_pixel({size.width * 0.3, size.height * 0.4}),
               bench.at_pixel({size.width * 0.7, size.height * 0.6}));
    bench.frames(1);
    return bench;
}

std::vector<ProfileSample> fresh_profile(HeadlessWindow& bench) {
    Renderer renderer(1);
    const PictureSize size = bench.state.rendered->size;
    const Picture& picture = renderer.render(bench.scene(), size, true);
    const ScopeState& scope = bench.state.get<ScopeState>();
    return profile(renderer, picture, pixel_of(scope.from, size), pixel_of(scope.to, size));
}

void check_equal(const std::vector<ProfileSample>& a, const std::vector<ProfileSample>& b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK(a[i].pixel == b[i].pixel);
        CHECK(a[i].color == b[i].color);
        CHECK(a[i].second_difference == b[i].second_difference);
    }
}

}  // namespace

TEST_CASE("the scope's key activates its tool, and a drag sets the line", "[ui][window][scope]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    bench.key(Key::P);
    CHECK(bench.state.get<ScopeState>().armed);
    bench.frames(1);
    const glm::dvec2 from{90, 60}, to{400, 200};
    bench.drag(bench.at_pixel(from), bench.at_pixel(to));
    const ScopeState& scope = bench.state.get<ScopeState>();
    const PictureSize size = bench.state.rendered->size;
    CHECK_FALSE(scope.armed);
    CHECK(pixel_of(scope.from, size) == glm::ivec2(from));
    CHECK(pixel_of(scope.to, size) == glm::ivec2(to));
    CHECK(bench.scene() == before);
    CHECK_FALSE(bench.state.viewport.probe);
    bench.key(Key::P);
    CHECK_FALSE(scope.open);
}

TEST_CASE("the scope's line is reset for a different scene and kept on a reload", "[ui][window][scope]") {
    HeadlessWindow bench;
    ScopeState& scope = bench.state.get<ScopeState>();
    const ScopeState level;
    SceneDocument one, other;
    one.path = "one.json";
    other.path = "other.json";
    take_scene(bench.state, one);
    scope.from = {0.1, 0.9};
    scope.to = {0.2, 0.9};
    take_scene(bench.state, one);
    CHECK(scope.from == glm::dvec2(0.1, 0.9));
    CHECK(scope.to == glm::dvec2(0.2, 0.9));
    take_scene(bench.state, other);
    CHECK(scope.from == level.from);
    CHECK(scope.to == level.to);
}

TEST_CASE("the scope's line ends where the button is released, at any picture width", "[ui][window][scope]") {
    for (const float width : {1280.0f, 1279.0f, 1260.0f, 1203.0f}) {
        HeadlessWindow bench({width, 800});
        with_line(bench);
        const ScopeState& scope = bench.state.get<ScopeState>();
        for (int x = 300; x < 340; x += 3) {
            const glm::dvec2 end(pixel_of(scope.to, bench.state.rendered->size));
            bench.drag(bench.at_pixel(end + 0.5), bench.at_pixel({x, 60}));
            CAPTURE(width, x);
            CHECK(pixel_of(scope.to, bench.state.rendered->size).x == x);
            CHECK(pixel_of(scope.to, bench.state.rendered->size).y == 60);
        }
    }
}

TEST_CASE("the scope shows the command's numbers, even while a light is dragged", "[ui][window][scope]") {
    HeadlessWindow bench;
    with_line(bench);
    check_equal(bench.state.get<ScopeState>().samples, fresh_profile(bench));
    const double before = bench.state.get<ScopeState>().samples[100].intensity;
    bench.scene().lights[0].position = {-1, 0.2f, 1, 0};
    bench.frames(1);
    check_equal(bench.state.get<ScopeState>().samples, fresh_profile(bench));
    CHECK(bench.state.get<ScopeState>().samples[100].intensity != before);
}

TEST_CASE("the scope's line and ends can be dragged, Shift keeps it horizontal or vertical",
          "[ui][window][scope]") {
    HeadlessWindow bench;
    with_line(bench);
    ScopeState& scope = bench.state.get<ScopeState>();
    const PictureSize size = bench.state.rendered->size;
    const Camera camera = bench.scene().camera;
    const glm::ivec2 from = pixel_of(scope.from, size), to = pixel_of(scope.to, size);
    bench.drag(bench.at_pixel(glm::dvec2(to) + 0.5), bench.at_pixel({500.5, 60.5}));
    CHECK(pixel_of(scope.to, size) == glm::ivec2(500, 60));
    CHECK(pixel_of(scope.from, size) == from);
    ImGui::GetIO().KeyShift = true;
    bench.drag(bench.at_pixel({500.5, 60.5}), bench.at_pixel({520.5, from.y + 20.0}));
    ImGui::GetIO().KeyShift = false;
    CHECK(pixel_of(scope.to, size) == glm::ivec2(520, from.y));
    const glm::dvec2 middle = (glm::dvec2(from) + glm::dvec2(520, from.y)) / 2.0;
    bench.drag(bench.at_pixel(middle + 0.5), bench.at_pixel(middle + glm::dvec2(0.5, 40.5)));
    CHECK(pixel_of(scope.from, size).y == from.y + 40);
    CHECK(pixel_of(scope.to, size).y == from.y + 40);
    CHECK(bench.scene().camera == camera);
}

TEST_CASE("a click with the scope's tool selects the full scan line, Escape ends the tool",
          "[ui][window][scope]") {
    DrawnWindow bench;
    bench.key(Key::P);
    bench.frames(1);
    bench.click(bench.at_pixel({100.5, 77.5}));
    const ScopeState& scope = bench.state.get<ScopeState>();
    const PictureSize size = bench.state.rendered->size;
    CHECK(pixel_of(scope.from, size) == glm::ivec2(0, 77));
    CHECK(pixel_of(scope.to, size) == glm::ivec2(size.width - 1, 77));
    bench.state.get<ScopeState>().armed = true;
    bench.key(Key::Escape);
    CHECK_FALSE(scope.armed);
    CHECK(scope.open);
}

TEST_CASE("hovering over the scope's panel selects the sample under the cursor", "[ui][window][scope]") {
    HeadlessWindow bench;
    with_line(bench);
    const Layout layout = lay_out({1280, 800}, bench.state.layout, 1);
    REQUIRE(layout.has_scope);
    const float left = layout.scope.low.x + 4 + 56, right = layout.scope.high.x - 4 - 96 - 6;
    bench.move({left + 0.25f * (right - left), layout.scope.high.y - 90});
    bench.frames(1);
    const ScopeState& scope = bench.state.get<ScopeState>();
    REQUIRE(scope.hovered >= 0);
    const double share =
        scope.samples[static_cast<std::size_t>(scope.hovered)].position / scope.samples.back().position;
    CHECK(share == Approx(0.25).margin(0.005));
    bench.move(bench.at_pixel({10, 10}));
    bench.frames(1);
    CHECK(scope.hovered == -1);
}

TEST_CASE("the grey card is next to the sharpest bend and leaves the picture unchanged",
          "[ui][window][scope]") {
    HeadlessWindow bench;
    with_line(bench);
    const std::vector<std::uint8_t> bytes = bench.state.rendered->rgba;
    ScopeState& scope = bench.state.get<ScopeState>();
    scope.card = true;
    place_card(scope, bench.state.rendered->size);
    bench.frames(2);
    CHECK(bench.state.rendered->rgba == bytes);
    double sharpest = 0;
    glm::ivec2 bend{0};
    for (const ProfileSample& s : scope.samples)
        if (std::abs(s.second_difference.value_or(0)) > sharpest) {
            sharpest = std::abs(*s.second_difference);
            bend = s.pixel;
        }
    const double edge = (scope.card_at.x - scope.card_size.x / 2) * bench.state.rendered->size.width;
    CHECK(edge == Approx(bend.x + 0.5));
}

TEST_CASE("ticks are round numbers within their range", "[ui][plot]") {
    CHECK(ticks({0, 1}, 6) == std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1});
    CHECK(ticks({-0.3, 0.3}, 3) == std::vector<double>{-0.2, 0, 0.2});
    CHECK(ticks({12, 948}, 5) == std::vector<double>{200, 400, 600, 800});
    CHECK(ticks({12, 948}, 3) == std::vector<double>{500});
    CHECK(ticks({0.12, 0.62}, 3) == std::vector<double>{0.2, 0.4, 0.6000000000000001});  // the scope's plot
    CHECK(ticks({1e30, 1.0001e30}, 4).size() <= 4);
    CHECK(tick_text(-1e-18, 0.1) == "0");
    CHECK(tick_text(0.25, 0.05) == "0.25");
    CHECK(tick_text(200, 50) == "200");
}

TEST_CASE("mapping a plot's value to the window and back gives the same value", "[ui][plot]") {
    const PlotArea area{{{100, 50}, {300, 150}}, {-2, 2}, {0, 10}};
    CHECK(area.at({-2, 0}).x == 100);
    CHECK(area.at({-2, 0}).y == 150);
    CHECK(area.at({2, 10}).y == 50);
    const glm::dvec2 back = area.value(area.at({0.5, 7}));
    CHECK(back.x == Approx(0.5));
    CHECK(back.y == Approx(7));
}

TEST_CASE("the scope counts the edges of polygons and the diagonals within them", "[ui][scope]") {
    const auto seen = [](std::uint32_t face, std::uint32_t triangle) {
        SeenPoint point;
        point.face = face, point.triangle = triangle;
        return point;
    };
    std::vector<ProfileSample> samples(7);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i].position = double(i);
    samples[1].seen = seen(0, 0), samples[2].seen = seen(0, 1), samples[3].seen = seen(0, 1);
    samples[4].seen = seen(1, 2), samples[5].seen = seen(1, 2);
    const std::vector<ScopeEdge> expected{{0.5, false}, {1.5, true}, {3.5, false}, {5.5, false}};
    CHECK(edges_along(samples) == expected);
    CHECK(edge_words(samples) == "7 pixels, 3 edges, 1 diagonal");
    CHECK(edge_words({samples.begin() + 4, samples.begin() + 6}) == "2 pixels, 0 edges");
}
