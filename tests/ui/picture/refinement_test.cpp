// Bounced light in the window: few paths at first, all of them after a while, and numbers that agree.
#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <thread>
#include <vector>

#include "renderer/explain/equation_text.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/headless_window.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/views/views.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/screen.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

/// A ball on a floor, small in the picture, so that few pixels have paths.
struct BouncingWindow : HeadlessWindow {
    BouncingWindow() : HeadlessWindow({1280, 1400}) {  // tall enough that nothing needs scrolling
        Object floor = scene().objects[0];
        floor.name = "Floor";
        floor.source = default_mesh(Primitive::Plane);
        floor.mesh = nullptr;
        floor.transform.translate = {0, -1, 0};
        floor.transform.scale = glm::vec3(2);
        scene().objects.push_back(floor);
        REQUIRE(problem_of(load_meshes(scene(), "", "")) == nullptr);
        scene().camera.eye = {0, 4, 16};
        scene().transport = {TransportModel::Bounces, 16, 2, 1};
        (void)frame();
    }
    void refine() {
        const auto is_complete = [this] {
            return state.refinement.progress() == 1 && state.parts_progress == 1;
        };
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
        while (!is_complete() && std::chrono::steady_clock::now() < end) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            (void)frame();
        }
        REQUIRE(is_complete());
    }
    /// Opens the equation of the ball's lowest visible pixel right of the centre, which is lit by the floor.
    void ask_ball() {
        const PictureSize size = state.rendered->size;
        glm::ivec2 at{size.width / 2 + 2, size.height - 1};
        while (at.y > 0 && state.renderer->object_at(at.x, at.y) != 0) --at.y;
        REQUIRE(at.y > 0);
        state.get<InspectorState>().tab = InspectorTab::Equation;
        state.viewport.probe = (glm::dvec2(at) + 0.5) / glm::dvec2(size.width, size.height);
        state.viewport.shares_of = size;
        frames(3);
    }
    /// Whether the picture equals that of a separate renderer.
    [[nodiscard]] bool is_complete_picture() {
        Renderer alone(1);
        return state.rendered->rgba == alone.render(scene(), state.rendered->size).rgba;
    }
};

std::vector<EquationLine> asked_lines(const HeadlessWindow& bench) {
    const Explanation& asked = *bench.state.on_screen.explanation;
    return unlit_lines(bench.state.rendered_scene, asked, asked.at);
}

}  // namespace

TEST_CASE("the formula for a traced scene contains the symbols for traced light", "[ui][transport]") {
    BouncingWindow bench;
    bench.ask_ball();
    const auto in_formula = [&](Quantity quantity) {
        const float table = bench.area_of("d  diffuse", test::right_column(bench)).low.y;
        (void)bench.frame();
        return std::any_of(bench.controls().begin(), bench.controls().end(), [&](const NamedControl& c) {
            return c.name == text_of(quantity) && c.at.low.y < table;
        });
    };
    CHECK(in_formula(Quantity::Bounced));
    CHECK(in_formula(Quantity::Reach));
    CHECK_FALSE(in_formula(Quantity::GlobalAmbient));
    CHECK_FALSE(asked_lines(bench)[1].term == Quantity::AmbientTerm);
    bench.scene().transport.model = TransportModel::Local;
    bench.frames(3);
    CHECK_FALSE(in_formula(Quantity::Bounced));
    CHECK_FALSE(in_formula(Quantity::Reach));
    CHECK(in_formula(Quantity::GlobalAmbient));
    CHECK(asked_lines(bench)[1].term == Quantity::AmbientTerm);
}

TEST_CASE("bounced light is refined in the background until it has all its paths", "[ui][transport]") {
    BouncingWindow bench;
    CHECK(bench.state.refinement.progress() == Approx(1.0 / 16));
    (void)bench.area_of("Light paths: 6 %");
    CHECK_FALSE(bench.is_complete_picture());
    const std::uint64_t serial = bench.state.picture_serial;
    bench.refine();
    CHECK(bench.state.picture_serial > serial);
    CHECK(bench.is_complete_picture());
    // A change restarts the refinement, even before it is complete.
    bench.scene().transport.paths = 65536;
    bench.frames(30);
    CHECK(bench.state.refinement.progress() < 1);
    bench.scene().transport = {TransportModel::Bounces, 16, 2, 2};
    (void)bench.frame();
    CHECK(bench.state.refinement.progress() == Approx(1.0 / 16));
    bench.refine();
    CHECK(bench.is_complete_picture());
    bench.scene().transport.model = TransportModel::Local;
    (void)bench.frame();
    CHECK(bench.state.refinement.progress() == 1);
    CHECK(bench.is_complete_picture());
}

TEST_CASE("the shadow of an area light is refined like bounced light", "[ui][transport]") {
    BouncingWindow bench;
    bench.scene().transport.model = TransportModel::Shadows;
    bench.scene().lights[0].kind = LightKind::Area;
    bench.scene().lights[0].position = {0, 4, 0, 1};
    bench.scene().lights[0].area = {.edge_u = {1, 0, 0}, .edge_v = {0, 0, 1}, .samples = 64};
    (void)bench.frame();
    CHECK(bench.state.refinement.progress() == Approx(1.0 / 64));
    CHECK_FALSE(bench.is_complete_picture());
    bench.refine();
    CHECK(bench.is_complete_picture());
    // The local model has nothing to refine: it uses all samples at once.
    bench.scene().transport.model = TransportModel::Local;
    (void)bench.frame();
    CHECK(bench.state.refinement.progress() == 1);
    CHECK(bench.is_complete_picture());
}

TEST_CASE("the picture returns with all its paths after a preview", "[ui][transport]") {
    BouncingWindow bench;
    bench.refine();
    const std::vector<std::uint8_t> complete = bench.state.rendered->rgba;
    Scene other = bench.scene();
    other.lights[0].enabled = false;
    show_instead(bench.state, other, "Preview");
    (void)bench.frame();
    CHECK((bench.state.rendered->rgba != complete));  // in parentheses, so that they are not printed
    (void)bench.frame();
    CHECK((bench.state.rendered->rgba == complete));
    CHECK(bench.state.refinement.progress() == 1);
}

TEST_CASE("terms and pixel agree at any number of paths, also in parts of a comparison", "[ui][transport]") {
    BouncingWindow bench;
    bench.scene().transport.model = TransportModel::Local;  // only a part has bounced light
    bench.compare({variant_of(TransportModel::Local), variant_of(TransportModel::Bounces)});
    bench.ask_ball();
    const auto check = [&bench] {
        REQUIRE(bench.state.on_screen.explanation);
        const Explanation& e = *bench.state.on_screen.explanation;
        const TermSums sums = term_sums(e);
        const glm::vec3 sum = sums.emission + sums.ambient + sums.diffuse + sums.specular + sums.bounced;
        CHECK(glm::distance(sum, e.sum) < 1e-5f);
        CHECK(sums.bounced != glm::vec3(0));
        const std::size_t at = 4 * bench.state.displayed->pixel(e.x, e.y);
        for (std::size_t i = 0; i < 3; ++i) CHECK(int(bench.state.displayed->rgba[at + i]) == e.byte[i]);
        return e.at.bounces.paths;
    };
    bench.refine();
    CHECK(check() == 16);
    (void)bench.area_of("b  bounced");  // a row of the table
    bench.scene().lights[0].intensity *= 1.5f;
    bench.frames(2);
    CHECK(check() < 16);
}

TEST_CASE("a path of the picked pixel is drawn and listed step by step", "[ui][transport][why]") {
    BouncingWindow bench;
    bench.refine();
    bench.ask_ball();
    InspectorState& inspector = bench.state.get<InspectorState>();
    CHECK(inspector.rays.size() == bench.state.on_screen.explanation->at.lights.size());
    CHECK(inspector.path.empty());
    bench.click_on("Show a path");
    CHECK_FALSE(inspector.path.empty());
    CHECK(inspector.path.front().throughput == glm::vec3(1));
    bench.click(bench.control("Show the ray"));
    CHECK(inspector.shows_ray);
    bench.frames(2);
}

// Tests of when the picture is drawn smaller.
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
    DrawnWindow bench;
    const PictureSize full = bench.state.rendered->size;
    begin_slow_drag(bench, 2);
    bench.move(bench.at_pixel({80, 50}));
    CHECK(bench.state.rendered->size == divided(full, 2));
    const UiRequests wants = bench.frame();  // the motion has stopped
    CHECK(wants.sleep_s <= rest_before_full);
    bench.frames(12);  // for 0.2 s
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
    DrawnWindow bench;
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

// Pixels that were picked in a picture of a different size.
namespace {

/// Picks the pixel at these fractions of the picture; a smaller picture does not contain it.
void ask_at(HeadlessWindow& window, glm::dvec2 share) {
    window.frames(2);
    const PictureSize size = window.state.rendered->size;
    const glm::ivec2 pixel = nearest_pixel(size, share * glm::dvec2(size.width, size.height));
    window.click(window.at_pixel(glm::dvec2(pixel) + 0.5));
    window.move({1, 1});
    window.frames(2);
    REQUIRE(window.state.on_screen.explanation);
    REQUIRE(window.state.on_screen.explanation->x == pixel.x);
}

void make_small(HeadlessWindow& window) {
    ImGui::GetIO().DisplaySize = {900, 420};
    window.frames(3);
}

bool shows_explained_bytes(const UiState& state) {
    const Explanation& e = *state.on_screen.explanation;
    const std::size_t at = 4 * state.displayed->pixel(e.x, e.y);
    for (std::size_t i = 0; i < 3; ++i)
        if (e.byte[i] != state.displayed->rgba[at + i]) return false;
    return true;
}

}  // namespace

TEST_CASE("a frozen comparison explains a pixel that exists after the window shrinks",
          "[ui][window][compare]") {
    DrawnWindow window;
    run_command(window.state, command(CommandId::Compare));
    window.state.get<CompareState>().choice.wipes = {0.6, 0.8};
    ask_at(window, {0.5, 0.6});  // another renderer drew this pixel
    REQUIRE(window.state.on_screen.explanation->hit);
    REQUIRE(window.state.on_screen.explanation->mode == ShadingMode::Flat);
    run_command(window.state, command(CommandId::Freeze));
    window.frames(2);
    make_small(window);
    REQUIRE(window.state.on_screen.explanation);
    REQUIRE(is_inside(window.state.displayed->size,
                      {window.state.on_screen.explanation->x, window.state.on_screen.explanation->y}));
    CHECK(shows_explained_bytes(window.state));
}
