// Polygons with very many corners: values computed once per face, not per pixel or triangle.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <random>
#include <set>

#include "models/scene_file/scene_file.h"
#include "renderer/geometry/object_normals.h"
#include "renderer/renderer.h"
#include "renderer/visibility/visibility.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize discs_size{96, 72};

MeshPtr disc(int corners, glm::vec3 centre, float tilt_deg) {
    const float tilt = glm::radians(tilt_deg);
    std::vector<glm::vec3> around;
    for (int i = 0; i < corners; ++i) {
        const float at = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(corners);
        around.push_back(
            centre + glm::vec3(std::cos(at) * std::cos(tilt), std::sin(at), std::cos(at) * std::sin(tilt)));
    }
    return std::make_shared<const Mesh>(make_polygon(std::move(around)));
}

/// Discs next to each other, so that each row of pixels crosses several; each has a single face, number 0.
Scene discs(int corners) {
    Scene scene;
    scene.camera.eye = {0, 0, 9};
    scene.lights = {Light{}};
    scene.lights[0].kind = LightKind::Directional;
    scene.lights[0].position = {0.3f, 0.4f, 1, 0};
    int place = -2;
    for (const float tilt : {-60.0f, -10.0f, 30.0f})
        scene.objects.push_back(object_of(disc(corners, {2.0f * static_cast<float>(++place), 0, 0}, tilt)));
    return scene;
}

}  // namespace

TEST_CASE("neighbouring faces with many corners have their own facet normals", "[renderer][large-faces]") {
    Renderer renderer(2);
    for (const int corners : {500, 501}) {
        Scene scene = discs(corners);
        scene.shading.mode = ShadingMode::Facet;
        const Picture facet = renderer.render(scene, discs_size, true);
        // The same picture, computed by interpolating the corners' normals, which equal the face's.
        scene.shading.mode = ShadingMode::Phong;
        for (Object& object : scene.objects) object.normals.source = NormalSource::Facet;
        const Picture& interpolated = renderer.render(scene, discs_size, true);
        for (std::size_t i = 0; i < facet.linear.size(); ++i)
            REQUIRE(facet.linear[i] == Approx(interpolated.linear[i]).margin(1e-5));
        CHECK(facet.linear_at(24, 36) != facet.linear_at(48, 36));
        CHECK(facet.linear_at(48, 36) != facet.linear_at(72, 36));
    }
}

TEST_CASE("faces with many corners are culled separately by the light", "[renderer][large-faces]") {
    Scene scene = discs(500);
    scene.shading.mistakes.culled_by_light = true;
    scene.lights[0].position = {-1, 0, 0.7f, 0};  // behind the first disc and in front of the others
    Renderer renderer(2);
    (void)renderer.render(scene, discs_size);
    CHECK(renderer.object_at(24, 36) < 0);
    CHECK(renderer.object_at(48, 36) == 1);
    CHECK(renderer.object_at(72, 36) == 2);
}

TEST_CASE("drawing a face with 200,000 corners takes time linear in corners and pixels",
          "[renderer][large-faces]") {
    // Not timed: an algorithm that visits the entire face for each pixel or triangle takes minutes here.
    Scene scene = discs(200'000);
    scene.shading.mistakes.culled_by_light = true;
    Renderer renderer(2);
    for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Facet}) {
        scene.shading.mode = mode;
        (void)renderer.render(scene, {640, 480});
        CHECK(renderer.object_at(320, 240) == 1);
    }
}

// The tile lists that contain each triangle.
namespace {

/// Triangles of any size in the plane of the screen: pixels are units, y up.
Scene flat_scene(const std::vector<glm::vec3>& corners, PictureSize size) {
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3) faces.push_back({i, i + 1, i + 2});
    Scene scene;
    scene.camera.projection = Orthographic{static_cast<float>(size.height), 0.1f, 100};
    scene.objects = {object_of(polygon_mesh(corners, faces))};
    return scene;
}

TileLists sorted(const Scene& scene, PictureSize size) {
    Geometry g;
    REQUIRE(update_geometry(g, scene, size));
    TileLists lists;
    bin_into_tiles(lists, g, Cull::None, false);
    return lists;
}

/// The triangles passed to a tile, with repetitions.
std::multiset<std::uint32_t> drawn_in_tile(const TileLists& lists, std::uint32_t x, std::uint32_t y) {
    std::multiset<std::uint32_t> numbers;
    for (std::uint32_t level = 0; level < CellGrid::levels; ++level) {
        const std::uint32_t cell = lists.grid.cell_at(level, x, y);
        for (std::size_t i = lists.cell_first[cell]; i < lists.cell_first[cell + 1]; ++i)
            numbers.insert(lists.entries[i].number);
    }
    return numbers;
}

}  // namespace

TEST_CASE("every tile gets each triangle whose box meets it, once", "[visibility][binning]") {
    std::mt19937 random(31);
    const PictureSize size{1900, 1300};
    for (int round = 0; round < 20; ++round) {
        std::vector<glm::vec3> corners;
        for (int i = 0; i < 60; ++i) {
            const float spread = i < 30 ? 100.0f : 1500.0f;
            const glm::vec3 middle{uniform(random, -900, 900), uniform(random, -600, 600), 0};
            for (int k = 0; k < 3; ++k)
                corners.push_back(middle + glm::vec3(uniform(random, -spread, spread),
                                                     uniform(random, -spread, spread), 0));
        }
        const TileLists lists = sorted(flat_scene(corners, size), size);
        std::vector<std::multiset<std::uint32_t>> drawn;
        for (std::uint32_t y = 0; y < lists.grid.tiles_y; ++y)
            for (std::uint32_t x = 0; x < lists.grid.tiles_x; ++x)
                drawn.push_back(drawn_in_tile(lists, x, y));
        int missing = 0, twice = 0;
        for (std::uint32_t t = 0; t < corners.size() / 3; ++t) {
            const glm::vec3 *a = &corners[3 * t], *b = a + 1, *c = a + 2;
            const float left = std::min({a->x, b->x, c->x}) + 950, right = std::max({a->x, b->x, c->x}) + 950;
            const float top = 650 - std::max({a->y, b->y, c->y}), bottom = 650 - std::min({a->y, b->y, c->y});
            for (std::uint32_t y = 0; y < lists.grid.tiles_y; ++y)
                for (std::uint32_t x = 0; x < lists.grid.tiles_x; ++x) {
                    const auto x0 = static_cast<float>(64 * x), y0 = static_cast<float>(64 * y);
                    const float x1 = std::min(x0 + 64, 1900.0f), y1 = std::min(y0 + 64, 1300.0f);
                    const bool meets = left < x1 - 1 && right > x0 + 1 && top < y1 - 1 && bottom > y0 + 1;
                    const std::size_t times = drawn[y * lists.grid.tiles_x + x].count(t);
                    missing += meets && times == 0;
                    twice += times > 1;
                }
        }
        CHECK(missing == 0);
        CHECK(twice == 0);
    }
}
