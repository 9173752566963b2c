// Quantities shown in place of the picture.
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/features/views/views.h"

using namespace glint;
using test::DrawnWindow;

TEST_CASE("a key cycles through the quantities and back to the picture", "[ui][window][debug_view]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    for (int i = 1; i <= debug_view_count; ++i) {
        const auto serial = bench.state.picture_serial;
        bench.key(Key::I);
        bench.frames(1);
        CHECK(bench.state.get<DebugViewState>().set.choice.view ==
              static_cast<DebugView>(i % debug_view_count));
        CHECK(bench.state.picture_serial > serial);
        REQUIRE(bench.state.displayed != nullptr);
        CHECK(bench.state.displayed->size == bench.state.rendered->size);
    }
    CHECK(bench.state.displayed == bench.state.rendered);
    CHECK(bench.scene() == before);
    bench.key(Key::I, false, true);
    CHECK(bench.state.get<DebugViewState>().set.choice.view == DebugView::Specular);
}

TEST_CASE("a shown quantity is repainted when the scene changes, and only then", "[ui][window][debug_view]") {
    DrawnWindow bench;
    show_quantity(bench.state, DebugView::NDotL);
    bench.frames(2);
    const PictureSize size = bench.state.rendered->size;
    const auto check = [&] {
        const DebugViewPainter& painter = *bench.state.get<DebugViewState>().painter;
        const Explanation e = bench.state.renderer->explain(size.width / 2, size.height / 2);
        REQUIRE(e.hit);
        CHECK(painter.value_at(e.x, e.y) == e.at.lights[0].n_dot_l);
    };
    check();
    bench.scene().lights[0].position = {-1, 0.4f, 0.2f, 0};
    bench.frames(1);
    check();
    const auto serial = bench.state.picture_serial;
    bench.frames(4);
    CHECK(bench.state.picture_serial == serial);
}

TEST_CASE("a scene without lights has no n·l", "[ui][window][debug_view]") {
    DrawnWindow bench;
    show_quantity(bench.state, DebugView::NDotL);
    bench.state.get<DebugViewState>().set.choice.light = 1;
    bench.frames(2);
    bench.scene().lights.clear();
    bench.frames(2);
    const PictureSize size = bench.state.rendered->size;
    CHECK(bench.state.get<DebugViewState>().painter->value_text(size.width / 2, size.height / 2) ==
          "background");
}

TEST_CASE("a comparison and a quantity are never shown together", "[ui][window][debug_view]") {
    DrawnWindow bench;
    bench.key(Key::C);
    bench.key(Key::I);
    CHECK_FALSE(bench.state.get<CompareState>().choice.on);
    bench.key(Key::C);
    CHECK(bench.state.get<DebugViewState>().set.choice.view == DebugView::Picture);
}

TEST_CASE("over-range stripes change the shown picture, not the drawn one", "[ui][window][debug_view]") {
    DrawnWindow bench;
    bench.scene().lights[0].intensity = 5;
    bench.frames(1);
    const std::vector<std::uint8_t> bytes = bench.state.rendered->rgba;
    bench.key(Key::O);
    bench.frames(1);
    CHECK(bench.state.get<DebugViewState>().clipped > 100);
    CHECK(bench.state.displayed->rgba != bytes);
    CHECK(((*bench.state.unpainted).rgba == bytes));  // big pixels show numbers from it
    bench.state.get<DebugViewState>().set.choice.view = DebugView::Depth;
    bench.frames(1);
    CHECK(bench.state.displayed->rgba != bytes);
    CHECK(((*bench.state.unpainted).rgba == bytes));
    bench.state.get<DebugViewState>().set.choice.view = DebugView::Picture;
    bench.frames(1);
    CHECK(bench.state.rendered->rgba == bytes);
    bench.key(Key::O);
    bench.frames(1);
    CHECK(bench.state.displayed->rgba == bytes);
}

TEST_CASE("a key shows and hides the front and back sides of faces", "[ui][window][debug_view]") {
    DrawnWindow bench;
    bench.key(Key::N, false, true);
    bench.frames(2);
    CHECK(bench.state.get<DebugViewState>().set.choice.view == DebugView::Orientation);
    CHECK(bench.state.displayed != bench.state.rendered);
    bench.key(Key::N, false, true);
    bench.frames(2);
    CHECK(bench.state.displayed == bench.state.rendered);
}

TEST_CASE("the legend of normals has the picture's colours, even for normals facing away",
          "[ui][window][debug_view]") {
    DrawnWindow bench;
    show_quantity(bench.state, DebugView::Normal);
    bench.frames(2);
    const auto drawn = [](std::array<std::uint8_t, 3> c) {
        const ImDrawData* data = ImGui::GetDrawData();
        for (int i = 0; i < data->CmdListsCount; ++i)
            for (const ImDrawVert& v : data->CmdLists[i]->VtxBuffer)
                if (v.col == IM_COL32(c[0], c[1], c[2], 255)) return true;
        return false;
    };
    // The normals at the centres of the balls point almost exactly towards the camera and away from it.
    const float near = 0.5f * 2 / 24, z = std::sqrt(1 - 2 * near * near);
    CHECK(drawn(normal_color({near, near, z})));
    int away = 0;
    for (int i = 0; i < 8; ++i) away += drawn(turned_away_color(normal_color({near, near, -z}), i, 0));
    CHECK(away > 0);
}

TEST_CASE("a key returns to the previous point after Escape or another pick", "[ui][window][probe]") {
    DrawnWindow bench;
    const PictureSize size = bench.state.rendered->size;
    const glm::dvec2 middle{size.width / 2.0, size.height / 2.0};
    bench.click(bench.at_pixel(middle));
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation);
    const glm::ivec2 first{bench.state.on_screen.explanation->x, bench.state.on_screen.explanation->y};
    const auto asked = [&] {
        bench.frames(2);
        return bench.state.on_screen.explanation
                   ? glm::ivec2(bench.state.on_screen.explanation->x, bench.state.on_screen.explanation->y)
                   : glm::ivec2(-1);
    };
    bench.key(Key::Escape);
    CHECK(asked() == glm::ivec2(-1));
    bench.key(Key::V, false, true);
    CHECK(asked() == first);
    bench.click(bench.at_pixel(middle + glm::dvec2(-60, 30)));
    const glm::ivec2 second = asked();
    CHECK_FALSE(second == first);
    bench.key(Key::V, false, true);
    CHECK(asked() == first);
    bench.key(Key::V, false, true);
    CHECK(asked() == second);
}
