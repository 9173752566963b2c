// Compares the coverage of several samples per pixel with known areas, and their colours with one sample's.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "renderer/renderer.h"
#include "renderer/simd/isa/kernel_set.h"
#include "renderer/visibility/visibility.h"
#include "tests/places.h"
#include "tests/support/as_fresh.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

/// A white quad on black, seen without perspective: the picture is two units high, so each of its n x n
/// pixels is 2/n units wide.
Scene white_quad(std::vector<glm::vec3> corners) {
    Scene scene;
    scene.objects.push_back(object_of(polygon_mesh(std::move(corners), {{0, 1, 2, 3}})));
    scene.objects[0].material.emission = {1, 1, 1};
    scene.global_ambient = {0, 0, 0};
    scene.display.background = {0, 0, 0};
    scene.camera.projection = Orthographic{2, 0.1f, 100};
    return scene;
}

}  // namespace

TEST_CASE("the samples of a pixel are spread over it and balanced around its centre", "[multisample]") {
    for (const int samples : {1, 2, 4, 8}) {
        int x = 0, y = 0;
        for (int s = 0; s < samples; ++s) {
            const SampleOffset o = sample_offset(samples, s);
            CHECK(std::max(std::abs(o.x), std::abs(o.y)) < 128);
            x += o.x;
            y += o.y;
            for (int other = 0; other < s; ++other) {  // no two share a row or a column
                CHECK(sample_offset(samples, other).x != o.x);
                CHECK(sample_offset(samples, other).y != o.y);
            }
        }
        CHECK(x == 0);
        CHECK(y == 0);
    }
}

TEST_CASE("an edge within a column of pixels mixes face and background by sample count", "[multisample]") {
    // 8 x 8 pixels of 1/4 unit; the edge is at 1/4 * share inside column 4.
    for (const int samples : {2, 4, 8})
        for (const float share : {0.1f, 0.3f, 0.5f, 0.7f, 0.9f}) {
            const float edge = 0.25f * share;
            Scene scene = white_quad({{-2, -2, 0}, {edge, -2, 0}, {edge, 2, 0}, {-2, 2, 0}});
            scene.display.background.y = 0.25f;
            int inside = 0;
            for (int s = 0; s < samples; ++s) {
                const double x = 0.5 + sample_offset(samples, s).x / 256.0;  // in the pixel, 0 to 1
                inside += x < share;
            }
            Renderer renderer(2);
            const Picture& p = renderer.render(scene, {8, 8}, true, samples);
            CAPTURE(samples, share);
            CHECK(p.linear_at(3, 5).x == 1);
            const double covered = static_cast<double>(inside) / samples;
            CHECK(p.linear_at(4, 5).x == Approx(covered));
            CHECK(p.linear_at(4, 5).y == Approx(covered + (1 - covered) * 0.25));
            CHECK(p.linear_at(5, 5).x == 0);
        }
}

TEST_CASE("a tilted edge covers its area to within one sample per row of pixels", "[multisample]") {
    const Scene scene = white_quad({{-2, -2, 0}, {0.3f, -2, 0}, {-0.1f, 2, 0}, {-2, 2, 0}});
    Renderer renderer(2);
    const Picture& p = renderer.render(scene, {64, 64}, true, 8);
    double worst = 0;
    for (int y = 0; y < 64; ++y) {
        double covered = 0;
        for (int x = 0; x < 64; ++x) covered += p.linear_at(x, y).x;
        const double height = 1 - (y + 0.5) / 32;                   // of the row's centre, in the world
        const double edge = 0.3 + (-0.1 - 0.3) * (height + 2) / 4;  // where the edge crosses that height
        worst = std::max(worst, std::abs(covered - (edge + 1) * 32));
    }
    CHECK(worst < 1.0 / 8);
}

TEST_CASE("inside a face, several samples give the same colour as one", "[multisample][release]") {
    // The second scene has two faces of one object, one seen from behind, lit on both sides.
    Scene both_sides = white_quad({{-2, -2, 0}, {0.1f, -2, 0}, {0.1f, 2, 0}, {-2, 2, 0}});
    both_sides.objects[0] = object_of(
        polygon_mesh({{-2, -2, 0}, {0.1f, -2, 0}, {0.1f, 2, 0}, {-2, 2, 0}, {2, -2, 0.3f}, {2, 2, 0}},
                     {{0, 1, 2, 3}, {1, 2, 5, 4}}));
    both_sides.shading.two_sided = true;
    both_sides.lights.resize(1);
    both_sides.lights[0].position = {0.5f, 0.2f, 2, 1};
    Scene scene = GENERATE_COPY(busy_scene(), both_sides);
    for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong}) {
        scene.shading.mode = mode;
        Renderer one(2), many(2);
        const PictureSize size{96, 72};
        const Picture& a = one.render(scene, size, true);
        for (const int samples : {2, 4, 8}) {
            const Picture& b = many.render(scene, size, true, samples);
            int compared = 0;
            for (int y = 1; y + 1 < size.height; ++y)
                for (int x = 1; x + 1 < size.width; ++x) {
                    const Explanation e = one.explain(x, y);
                    const auto same = [&](int dx, int dy) {
                        const Explanation o = one.explain(x + dx, y + dy);
                        return e.hit && o.hit && o.object_index == e.object_index && o.face == e.face &&
                               o.triangle == e.triangle;
                    };
                    if (!(same(-1, 0) && same(1, 0) && same(0, -1) && same(0, 1))) continue;
                    ++compared;
                    for (int c = 0; c < 3; ++c)
                        REQUIRE(b.linear_at(x, y)[c] == Approx(a.linear_at(x, y)[c]).margin(1e-5));
                }
            CHECK(compared > 150);
        }
    }
}

namespace {

/// A convex polygon that fills the picture, whose fan has inner edges across many pixels, under a light so
/// near that a highlight changes from pixel to pixel.
Scene lit_polygon() {
    Scene scene =
        white_quad({{-2, -2, 0}, {2, -2.2f, 0}, {2.3f, 0.4f, 0}, {0.6f, 2.1f, 0}, {-2.1f, 1.7f, 0}});
    std::vector<std::uint32_t> corners{0, 1, 2, 3, 4};
    scene.objects[0] = object_of(polygon_mesh(
        {{-2, -2, 0}, {2, -2.2f, 0}, {2.3f, 1.4f, 0}, {0.6f, 2.1f, 0}, {-2.1f, 1.7f, 0}}, {corners}));
    scene.objects[0].material.shininess = 60;
    Light light;
    light.position = {0.1f, 0.2f, 0.5f, 1};
    scene.lights = {light};
    return scene;
}

}  // namespace

TEST_CASE("a face is lit once per pixel, independent of its triangulation", "[multisample]") {
    for (const ShadingMode mode : {ShadingMode::Phong, ShadingMode::Facet}) {
        Scene scene = lit_polygon();
        scene.shading.mode = mode;
        Renderer one(2), many(2);
        const PictureSize size{31, 23};
        const Picture& a = one.render(scene, size, true);
        REQUIRE(one.stats().shaded_pixels == 31 * 23);
        for (const int samples : {2, 4, 8}) {
            const Picture& b = many.render(scene, size, true, samples);
            CHECK(many.stats().evaluations == 31 * 23);  // one light
            double worst = 0;  // all samples show the face: their mean is the centre
            for (std::size_t i = 0; i < a.linear.size(); ++i)
                worst = std::max(worst, static_cast<double>(std::abs(a.linear[i] - b.linear[i])));
            CHECK(worst < 2e-6);
        }
    }
}

TEST_CASE("faces that share an edge are each lit in the pixels on that edge", "[multisample]") {
    // Two quads that meet at x = 0, in the centre of pixel column 2 of 5, so each of that column's pixels has
    // two lit points.
    Scene scene = white_quad({{-2, -2, 0}, {0, -2, 0}, {0, 2, 0}, {-2, 2, 0}});
    scene.objects[0] =
        object_of(polygon_mesh({{-2, -2, 0}, {0, -2, 0}, {0, 2, 0}, {-2, 2, 0}, {2, -2, 0}, {2, 2, 0}},
                               {{0, 1, 2, 3}, {1, 4, 5, 2}}));
    scene.lights = {Light{}};
    Renderer renderer(2);
    (void)renderer.render(scene, {5, 5}, true, 4);
    CHECK(renderer.stats().evaluations == 5 * 5 + 5);
}

TEST_CASE("a face in half of a pixel is lit at the mean of its own samples", "[multisample]") {
    // The colour is the position: a vertex colour from x = -1 at the left of the picture to 1 at its right,
    // equal in both triangles of the quad. The quad ends within column 3 of 4, at x = 3/4.
    Scene scene = white_quad({{-2, -2, 0}, {0.75f, -2, 0}, {0.75f, 2, 0}, {-2, 2, 0}});
    auto mesh = std::make_shared<Mesh>(*scene.objects[0].mesh);
    for (const glm::vec3& p : mesh->positions) mesh->colors.push_back(glm::vec3(p.x + 2));
    scene.objects[0].mesh = mesh;
    scene.shading.reflection = Reflection::None;
    Renderer renderer(2);
    const Picture& p = renderer.render(scene, {4, 4}, true, 8);
    double sum = 0;
    int count = 0;
    for (int s = 0; s < 8; ++s) {
        const double x = 0.5 + 0.5 * (0.5 + sample_offset(8, s).x / 256.0);  // of the sample, in the world
        if (x >= 0.75) continue;
        sum += x;
        ++count;
    }
    REQUIRE(count == 4);
    for (int y = 0; y < 4; ++y) CHECK(p.linear_at(3, y).x == Approx(0.5 * (sum / count + 2)));
}

// GLINT_ISA forces an instruction set: the bytes of a picture must not depend on it.
namespace {

/// Sets GLINT_ISA for the programs that this test starts.
class Forced {
  public:
    explicit Forced(const char* set) { setenv("GLINT_ISA", set, 1); }
    ~Forced() { unsetenv("GLINT_ISA"); }
    Forced(const Forced&) = delete;
    Forced& operator=(const Forced&) = delete;
};

/// The bytes of a float picture.
std::string drawn(const std::vector<std::string>& settings) {
    const TemporaryDirectory folder;
    std::vector<std::string> words{
        "render", project_file("tests/bench/knot.json"), "--size", "159x91", "-o", folder.path("out.pfm")};
    for (const std::string& setting : settings) {
        words.emplace_back("--set");
        words.push_back(setting);
    }
    const Ended ended = run_glint(words);
    CHECK(ended.err.empty());
    return bytes_of(folder.path("out.pfm"));
}

}  // namespace

TEST_CASE("every instruction set draws the same bytes in every mode and model", "[cli][renderer][isa]") {
    std::vector<std::vector<std::string>> scenes;
    for (const char* model : {"lambert", "phong", "blinn-phong", "retro", "oren-nayar", "cook-torrance"})
        scenes.push_back({std::string("/shading/reflection=") + model});
    for (const char* mode : {"flat", "facet", "gouraud"})
        scenes.push_back({std::string("/shading/mode=") + mode});
    scenes.push_back({"/shading/two_sided=true", "/shading/cull=front"});
    scenes.push_back({"/npr/cool_to_warm=true"});
    // 60 taken as radians has a negative cosine: a cone wider than the half space in front of it.
    scenes.push_back({"/shading/mistakes/degrees_for_radians=true", "/lights/7/spot/cutoff_deg=60"});
    for (const auto& scene : scenes) {
        std::string first;
        for (const char* set : {"scalar", "sse2", "avx2", "avx512"}) {
            const Forced forced(set);
            if (instruction_set_problem()) continue;  // this processor lacks it
            const std::string bytes = drawn(scene);
            REQUIRE(!bytes.empty());
            if (first.empty()) first = bytes;
            INFO(set << " " << scene.front());
            CHECK((bytes == first));
        }
    }
}

TEST_CASE("an instruction set that does not exist is reported in one line as wrong usage", "[cli][isa]") {
    const Forced forced("sse9");
    const Ended ended = run_glint({"--version"});
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(ended.err ==
          "glint: error: GLINT_ISA: sse9 is not an instruction set; expected one of scalar, sse2, avx2, "
          "avx512\n");
}
