// When the picture is drawn smaller.
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/picture/draw_picture.h"

using namespace glint;

namespace {

/// The divisors chosen for 40 pictures on a machine where a picture takes `fixed` + `per_pixels` / divisor²
/// milliseconds.
std::vector<int> divisors(FramePace& pace, double fixed, double per_pixels) {
    std::vector<int> used;
    for (int i = 0; i < 40; ++i) {
        const int divisor = pace.divisor;
        used.push_back(divisor);
        picture_took(pace, divisor, fixed + per_pixels / (divisor * divisor));
    }
    return used;
}

/// Begins a camera drag in which pictures are drawn smaller, as if they had been slow.
void begin_slow_drag(test::HeadlessWindow& bench, int divisor) {
    bench.move(bench.at_pixel({40, 40}));
    bench.button(true);
    bench.move(bench.at_pixel({60, 44}));
    bench.state.pace.slow_ms = slow_picture_ms;
    bench.state.pace.divisor = divisor;
    bench.state.pace.full_ms = divisor > 2 ? 80 : 40;
}

}  // namespace

TEST_CASE("a picture is drawn smaller only when a full one takes more than 33 ms", "[ui][pace]") {
    FramePace pace;
    CHECK(divisors(pace, 0, 33) == std::vector<int>(40, 1));
    pace = {};
    const auto slow = divisors(pace, 0, 60);
    CHECK(slow[0] == 1);
    CHECK(slow[1] == 2);
    CHECK(slow.back() == 2);
    pace = {};
    CHECK(divisors(pace, 0, 1000).back() == largest_divisor);
}

TEST_CASE("the resolution stays constant during motion: no flicker between sizes", "[ui][pace]") {
    for (const double fixed : {0.0, 3.0, 10.0, 20.0})
        for (double per_pixels = 5; per_pixels < 500; per_pixels *= 1.3) {
            FramePace pace;
            const auto used = divisors(pace, fixed, per_pixels);
            int changes = 0;
            for (std::size_t i = 1; i < used.size(); ++i) changes += used[i] != used[i - 1];
            INFO(fixed << " + " << per_pixels);
            CHECK(changes <= 3);
        }
}

TEST_CASE("if fewer pixels do not help, the picture stays full-size", "[ui][pace]") {
    FramePace pace;
    const auto used = divisors(pace, 300, 10);  // the time is spent on a million triangles
    CHECK(used.back() == 1);
    CHECK(pace.in_vain);
    end_of_motion(pace);
    CHECK_FALSE(pace.in_vain);
}

TEST_CASE("a slow picture is small during a camera drag and full-size after a pause", "[ui][pace]") {
    test::HeadlessWindow bench;
    bench.frames(2);
    const PictureSize full = bench.state.rendered->size;
    begin_slow_drag(bench, 2);
    bench.move(bench.at_pixel({80, 50}));
    CHECK(bench.state.rendered->size == divided(full, 2));
    const UiRequests wants = bench.frame();  // the motion has stopped
    CHECK(wants.sleep_s <= rest_before_full);
    bench.frames(12);  // 0.2 s
    CHECK(bench.state.rendered->size == full);
    bench.state.pace.divisor = 2;
    bench.move(bench.at_pixel({90, 55}));
    CHECK(bench.state.rendered->size == divided(full, 2));
    bench.button(false);
    bench.frame();
    CHECK(bench.state.rendered->size == full);
    CHECK(bench.state.rendered_scene == bench.scene());
}

TEST_CASE("in a smaller picture, the picked pixel's explanation matches what it shows", "[ui][pace]") {
    test::HeadlessWindow bench;
    bench.frames(2);
    const PictureSize full = bench.state.rendered->size;
    bench.click(bench.at_pixel({321, 243}));
    REQUIRE(bench.state.on_screen.explanation);
    const std::array<int, 3> whole = bench.state.on_screen.explanation->byte;
    CHECK(bench.state.on_screen.pixel == glm::ivec2(321, 243));
    begin_slow_drag(bench, 3);
    bench.move(bench.at_pixel({90, 50}));
    const Picture& small = *bench.state.rendered;
    REQUIRE(small.size == divided(full, 3));
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.on_screen.pixel == glm::ivec2(321, 243));
    const std::size_t at =
        4 * small.pixel(321 * small.size.width / full.width, 243 * small.size.height / full.height);
    for (std::size_t c = 0; c < 3; ++c)
        CHECK(bench.state.on_screen.explanation->byte[c] == int(small.rgba[at + c]));
    CHECK(bench.state.on_screen.explanation->byte != whole);  // the camera has turned
    bench.button(false);
    bench.frame();
    CHECK(bench.state.rendered->size == full);
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.on_screen.explanation->x == 321);
    CHECK(bench.state.on_screen.explanation->y == 243);
}
