// Bounced light in the window: few paths at first, all of them after a while, and numbers that agree.
#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <thread>
#include <vector>

#include "renderer/explain/equation_text.h"
#include "tests/support/headless_inspector.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// A ball on a floor, small in the picture, so that few pixels have paths.
struct BouncingWindow : HeadlessWindow {
    BouncingWindow() : HeadlessWindow({1280, 1400}) {  // tall: nothing needs scrolling
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
    /// Opens the equation of the ball's lowest visible pixel right of the middle, which the floor lights.
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
    // The local model has nothing to refine: all samples at once.
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
    bench.click(bench.control("Show a path"));
    bench.frames(2);
    CHECK_FALSE(inspector.path.empty());
    CHECK(inspector.path.front().throughput == glm::vec3(1));
    bench.click(bench.control("Show the ray"));
    CHECK(inspector.shows_ray);
    bench.frames(2);
}
