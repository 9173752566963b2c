// Light by term, big pixels, and where the equation is evaluated.
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/scenes.h"
#include "ui/features/views/views.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

TEST_CASE("grid: the cells' linear pictures add up to the picture", "[ui][grid]") {
    Scene scene = test::busy_scene();
    constexpr PictureSize size{80, 60};
    Renderer full(1), small(1);
    const Picture& picture = full.render(scene, size, true);
    std::vector<glm::vec3> sum(std::size_t{80} * 60, glm::vec3(0));
    for (const GridCell cell : grid_cells(scene)) {
        const Picture& part = small.render(with_cells(scene, {cell}), size, true);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) sum[part.pixel(x, y)] += part.linear_at(x, y);
    }
    int surface = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (full.object_at(x, y) < 0) continue;
            ++surface;
            CHECK(glm::length(sum[picture.pixel(x, y)] - picture.linear_at(x, y)) < 1e-5f);
        }
    CHECK(surface > 500);
    CHECK(with_cells(scene, grid_cells(scene)) == scene);
}

TEST_CASE("grid: a faint term is brightened by a power of 2, an empty one shows 0", "[ui][grid]") {
    Scene scene;
    scene.camera.eye = {0, 0, 4};
    scene.objects = {test::object_of(test::primitive(Primitive::Sphere, 24))};
    scene.objects[0].material.diffuse = glm::vec3(0.5f);
    scene.lights.resize(1);
    scene.lights[0].space = LightSpace::Camera;
    scene.lights[0].position = {0, 0, 1, 0};
    scene.lights[0].kind = LightKind::Directional;
    constexpr PictureSize size{60, 60};
    Renderer renderer(1);
    const auto gain = [&](GridCell cell) {
        return gain_of(renderer, renderer.render(with_cells(scene, {cell}), size, true),
                       scene.display.exposure);
    };
    // n·l is nearly 1 at the centre, which shows 0.5 I. With gain, the brightest 5 % may exceed 1.
    for (const auto& [intensity, wanted] :
         {std::pair{2.0f, 1}, {0.9f, 2}, {0.45f, 4}, {0.2f, 8}, {0.1f, 16}, {1e-4f, 16}}) {
        scene.lights[0].intensity = intensity;
        CAPTURE(intensity);
        CHECK(gain({0, 1}) == wanted);
    }
    CHECK(gain({0, 0}) == 0);
    const Scene alone = with_cells(scene, {{0, 1}});
    const glm::vec3 middle = renderer.render(alone, size, true).linear_at(30, 30);
    const Picture& brighter = renderer.render(brightened(alone, 16), size);
    const std::size_t pixel = 4 * brighter.pixel(30, 30);
    CHECK(int(brighter.rgba[pixel]) == int(std::lround(255 * 16 * middle.x)));
    const glm::vec3 background = scene.display.background;
    CHECK(int(brighter.rgba[2]) == int(std::lround(255 * background.z)));
}

TEST_CASE("grid: a click shows one term alone while the tab is open and edits nothing",
          "[ui][window][grid]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Grid);
    bench.frames(30);
    const Scene before = bench.scene();
    TermGridState& grid = bench.state.get<TermGridState>();
    CHECK(grid.next == grid_cells(before).size());
    const PictureSize cell = grid.sheet.cell;
    CHECK(grid.sheet.picture.size.width == 3 * cell.width);
    // The sheet contains the output of a small renderer.
    Renderer renderer(1);
    REQUIRE(grid.gains.size() == grid_cells(before).size());
    const int gain = grid.gains[3];  // of the first light's diffuse term
    const Picture& small = renderer.render(brightened(with_cells(before, {{0, 1}}), gain), cell);
    const std::size_t middle = 4 * small.pixel(cell.width / 2, cell.height / 2);
    const std::size_t there = 4 * grid.sheet.picture.pixel(cell.width * 3 / 2, cell.height + cell.height / 2);
    CHECK(small.rgba[middle] == grid.sheet.picture.rgba[there]);
    grid.solo = GridCell{0, 1};
    bench.frames(2);
    CHECK(bench.state.rendered_scene == with_cells(before, {{0, 1}}));
    CHECK(bench.scene() == before);
    grid.solo.reset();
    grid.muted = {{0, 2}};
    bench.frames(2);
    CHECK(bench.state.rendered_scene.lights[0].specular == glm::vec3(0));
    CHECK(bench.state.rendered_scene.lights[1] == before.lights[1]);
    bench.state.get<InspectorState>().tab = InspectorTab::Equation;
    bench.frames(3);
    CHECK(bench.state.rendered_scene == before);
    CHECK_FALSE(bench.state.editor.history.can_undo());
}

TEST_CASE("big pixels zoom in on the pixel under the cursor and redraw nothing", "[ui][window][magnify]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    const auto serial = bench.state.picture_serial;
    const glm::dvec2 pixel{300.5, 200.5};
    bench.move(bench.at_pixel(pixel));
    ImGui::GetIO().KeyCtrl = true;
    for (int i = 0; i < 5; ++i) {
        ImGui::GetIO().MouseWheel = 1;
        bench.frames(1);
        ImGui::GetIO().MouseWheel = 0;
    }
    ImGui::GetIO().KeyCtrl = false;
    CHECK(bench.state.get<MagnifierState>().zoom == 32);
    CHECK(bench.scene() == before);
    CHECK(bench.state.picture_serial == serial);
    bench.frames(1);
    bench.button(true);
    bench.button(false);
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(std::abs(bench.state.on_screen.explanation->x - 300) <= 1);
    CHECK(std::abs(bench.state.on_screen.explanation->y - 200) <= 1);
    bench.key(Key::M);
    CHECK(bench.state.get<MagnifierState>().zoom == 1);
    // Several wheel steps in one slow frame, and a step of a wheel with smooth scrolling.
    ImGui::GetIO().KeyCtrl = true;
    for (const auto& [steps, zoom] : {std::pair{3.0f, 8}, {-2.0f, 2}, {0.2f, 4}, {9.0f, 64}, {-9.0f, 1}}) {
        ImGui::GetIO().MouseWheel = steps;
        bench.frames(1);
        ImGui::GetIO().MouseWheel = 0;
        CHECK(bench.state.get<MagnifierState>().zoom == zoom);
    }
    ImGui::GetIO().KeyCtrl = false;
}

TEST_CASE("magnified positions map to the window and back, the picture fills its area", "[ui][magnify]") {
    PictureView plain;
    plain.origin = {10, 20};
    plain.map.size = {640, 480};
    const Rect area{{10, 20}, {650, 500}};
    for (const glm::dvec2 centre : {glm::dvec2(0), glm::dvec2(0.3, 0.8), glm::dvec2(1)})
        for (const int zoom : {2, 16, 64}) {
            PictureView view = plain;
            magnify(view, area, {zoom, centre});
            const glm::dvec2 back = view.to_pixel(view.to_window({123.25, 45.5}));
            CHECK(back.x == Approx(123.25).margin(1e-3));
            CHECK(view.to_window({0, 0}).x <= area.low.x);
            CHECK(view.to_window({640, 480}).y >= area.high.y - 1);
        }
}

TEST_CASE("dots: flat shading is evaluated per face, Gouraud per corner, Phong per pixel", "[ui][dots]") {
    Scene scene = test::busy_scene();
    constexpr PictureSize size{160, 120};
    Renderer renderer(1);
    scene.shading.mode = ShadingMode::Gouraud;
    renderer.render(scene, size);
    const std::vector<LitDot> corners = lit_dots(renderer, size, 160, {{0, 0}, {160, 120}});
    // Sampling every pixel finds each lit corner once.
    const std::uint64_t sources = 3 + 4;  // an area light counts once per sample
    const std::uint64_t lit = renderer.stats().evaluations / sources;
    CHECK(corners.size() <= lit);  // at a pole, the faces' corners coincide
    CHECK(double(corners.size()) > 0.6 * double(lit));
    scene.shading.mode = ShadingMode::Flat;
    renderer.render(scene, size);
    const std::vector<LitDot> faces = lit_dots(renderer, size, 160, {{0, 0}, {160, 120}});
    CHECK(faces.size() == renderer.stats().evaluations / sources);
    scene.shading.mode = ShadingMode::Phong;
    renderer.render(scene, size);
    CHECK(lit_dots(renderer, size, 160, {{0, 0}, {160, 120}}).size() == renderer.stats().shaded_pixels);
    for (const LitDot& dot : faces) CHECK(glm::length(dot.normal) == Approx(1));
}

TEST_CASE("dots: the counter shows the renderer's count", "[ui][window][dots]") {
    DrawnWindow bench;
    bench.key(Key::J);
    bench.key(Key::N);
    bench.frames(2);
    REQUIRE(bench.state.get<LitDotsState>().found.value() != nullptr);
    CHECK(bench.state.get<LitDotsState>().found.value()->at(0).dots.size() > 100);
    const std::string text = evaluations_text(*bench.state.renderer, bench.state.rendered_scene);
    CHECK(text.find(std::to_string(bench.state.renderer->stats().evaluations)) != std::string::npos);
    CHECK(text.find("pixels × 2 lights") != std::string::npos);
    bench.key(Key::J);
    bench.key(Key::N);
    bench.frames(1);
    CHECK(bench.state.get<LitDotsState>().found.value() == nullptr);
}

TEST_CASE("dots: each part of a comparison has its own dots, and its own count",
          "[ui][window][dots][compare]") {
    DrawnWindow bench;
    set_parts(bench.state.get<CompareState>().choice,
              {variant_of(ShadingMode::Flat), variant_of(ShadingMode::Phong)});
    bench.key(Key::C);
    bench.key(Key::J);
    bench.frames(2);
    const PictureSize size = bench.state.rendered->size;
    const auto* found = bench.state.get<LitDotsState>().found.value();
    REQUIRE(found != nullptr);
    REQUIRE(found->size() == 2);
    CHECK(found->at(0).rect.high.x == found->at(1).rect.low.x);
    Scene flat = bench.scene();
    flat.shading.mode = ShadingMode::Flat;
    Renderer of_flat(1);
    (void)of_flat.render(flat, size);
    const std::vector<LitDot> expected = lit_dots(of_flat, size, 40, found->at(0).rect),
                              smooth = lit_dots(*bench.state.renderer, size, 40, found->at(1).rect);
    REQUIRE(found->at(0).dots.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK(found->at(0).dots[i].place == expected[i].place);
    CHECK(found->at(1).dots.size() == smooth.size());
    const auto told = [&](double share) {
        bench.move(bench.at_pixel({share * size.width, 40.5}));
        bench.frames(1);
        for (const NamedControl& control : bench.controls())
            if (control.name == "evaluations") return std::string(control.key);
        return std::string();
    };
    CHECK(told(0.25) == "Flat shading: " + evaluations_text(of_flat, flat));
    CHECK(told(0.75) == "Phong shading: " + evaluations_text(*bench.state.renderer, bench.scene()));
}
