// Checks the face at each sample against ray casting in double and against the rule that every sample of a
// closed surface belongs to exactly one face.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <limits>

#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

Scene looking_at(MeshPtr mesh) {
    Scene scene;
    scene.objects.push_back(object_of(std::move(mesh)));
    return scene;
}

/// A ray from the eye through a pixel's centre, in world coordinates.
struct PixelRay {
    glm::dvec3 from, direction;  // the direction's -z is 1 in camera coordinates
};

PixelRay ray_through(const Camera& camera, PictureSize size, int x, int y) {
    const glm::dmat4 view_from_clip = glm::inverse(clip_from_view(camera.projection, size));
    const glm::dvec4 ndc((x + 0.5) / size.width * 2 - 1, 1 - (y + 0.5) / size.height * 2, -1, 1);
    const glm::dvec4 p = view_from_clip * ndc;
    const glm::dvec3 on_near = glm::dvec3(p) / p.w;
    const glm::dvec3 d = on_near / -on_near.z;
    const glm::dmat4 world = world_from_view(camera);
    return {glm::dvec3(world[3]), glm::dvec3(world * glm::dvec4(d, 0))};
}

/// The depth (-z) at which a ray meets a triangle, or infinity; `margin` is the smallest barycentric weight
/// there.
double meet(const PixelRay& ray, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, double& margin) {
    const glm::dvec3 e1 = b - a, e2 = c - a, p = glm::cross(ray.direction, e2);
    const double det = glm::dot(e1, p);
    margin = -1;
    if (det == 0) return std::numeric_limits<double>::infinity();
    const glm::dvec3 s = ray.from - a, q = glm::cross(s, e1);
    const double u = glm::dot(s, p) / det, v = glm::dot(ray.direction, q) / det;
    margin = std::min({u, v, 1 - u - v});
    return margin >= 0 ? glm::dot(e2, q) / det : std::numeric_limits<double>::infinity();
}

}  // namespace

TEST_CASE("every pixel of a triangulated plane belongs to exactly one of its faces", "[visibility]") {
    // A jittered grid without folds that fills the picture. Any partition of its faces into two sets gives
    // two complementary coverages: no pixel twice, none lost, even if samples are exactly on edges (the
    // grid's rim).
    std::mt19937 random(3);
    const int n = 24;
    std::vector<glm::vec3> positions;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const bool rim = i == 0 || j == 0 || i == n || j == n;
            const float jitter = rim ? 0.0f : 0.02f;  // less than a quarter of a cell: no face is folded
            const float x = static_cast<float>(i) / n * 2 - 1 + uniform(random, -jitter, jitter);
            const float y = static_cast<float>(j) / n * 2 - 1 + uniform(random, -jitter, jitter);
            positions.emplace_back(x, y, 0);
        }
    Scene scene;
    scene.camera.projection = Orthographic{2, 0.1f, 100};
    const PictureSize size{97, 97};
    for (int round = 0; round < 8; ++round) {
        std::vector<std::vector<std::uint32_t>> parts[2];
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
                parts[random() % 2].push_back({a, b, c});
                parts[random() % 2].push_back({a, c, d});
            }
        std::vector<int> hits(static_cast<std::size_t>(size.width) * 97, 0);
        for (const auto& part : parts) {
            Scene one = looking_at(polygon_mesh(positions, part));
            one.camera = scene.camera;
            Renderer renderer(2);
            renderer.render(one, size);
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    hits[static_cast<std::size_t>(y * 97 + x)] += renderer.object_at(x, y) == 0;
        }
        CHECK(std::count(hits.begin(), hits.end(), 1) == 97 * 97);
    }
}

TEST_CASE("a sample exactly on a shared edge belongs to one face", "[visibility]") {
    // Two quads meet at x = 0; with 4 x 4 pixels over [-2, 2] shifted by half a pixel, samples are on the
    // edge.
    const std::vector<glm::vec3> p{{-2, -2, 0}, {0, -2, 0}, {2, -2, 0}, {-2, 2, 0}, {0, 2, 0}, {2, 2, 0}};
    Scene scene = looking_at(polygon_mesh(p, {{0, 1, 4, 3}}));
    scene.objects.push_back(object_of(polygon_mesh(p, {{1, 2, 5, 4}})));
    scene.camera.projection = Orthographic{4, 0.1f, 100};
    scene.camera.eye.x = scene.camera.target.x = 0.5f;
    Renderer renderer(1);
    renderer.render(scene, {4, 4});
    // Samples at x = -1, 0, 1, 2 in the world: the second is on the shared edge, a left edge of the right
    // quad; the last on the right quad's right edge, which would belong to its (missing) neighbour.
    for (int y = 0; y < 4; ++y) {
        CHECK(renderer.object_at(0, y) == 0);
        CHECK(renderer.object_at(1, y) == 1);
        CHECK(renderer.object_at(2, y) == 1);
        CHECK(renderer.object_at(3, y) == -1);
    }
}

TEST_CASE("random triangles are visible where rays from the eye meet them first",
          "[visibility][brute force]") {
    std::mt19937 random(17);
    const PictureSize size{120, 90};
    for (int round = 0; round < 6; ++round) {
        std::vector<glm::vec3> positions;
        std::vector<std::vector<std::uint32_t>> faces;
        for (std::uint32_t t = 0; t < 40; ++t) {
            for (int k = 0; k < 3; ++k) positions.push_back(uniform_vec3(random, -4, 4));
            faces.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        }
        Scene scene = looking_at(polygon_mesh(positions, faces));
        scene.camera.eye = uniform_vec3(random, -1, 1);  // many of them cross the near plane
        scene.camera.target = {0.3f, 0.1f, -3};
        scene.camera.projection = Perspective{60, 0.1f, 50};
        Renderer renderer(2);
        renderer.render(scene, size);
        int compared = 0, wrong = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const PixelRay ray = ray_through(scene.camera, size, x, y);
                double nearest = std::numeric_limits<double>::infinity(), second = nearest, edge = 1;
                int face = -1;
                for (std::uint32_t t = 0; t < faces.size(); ++t) {
                    double margin = 0;
                    const double depth =
                        meet(ray, positions[3 * t], positions[3 * t + 1], positions[3 * t + 2], margin);
                    edge = std::min(edge, std::abs(margin));
                    if (depth < 0.1 || depth > 50) continue;
                    if (std::abs(depth - 0.1) < 1e-3) edge = 0;
                    if (depth < nearest) {
                        second = nearest;
                        nearest = depth;
                        face = static_cast<int>(t);
                    } else {
                        second = std::min(second, depth);
                    }
                }
                if (edge < 0.002 || second - nearest < 1e-3 * nearest) continue;  // too close to call
                ++compared;
                const Explanation e = renderer.explain(x, y);
                const int seen = e.hit ? static_cast<int>(e.face) : -1;
                wrong += seen != face;
                if (e.hit && seen == face) {
                    CHECK(-e.at.point.camera.z == Approx(nearest).epsilon(1e-4));
                }
            }
        CHECK(compared > 5000);
        CHECK(wrong == 0);
    }
}

TEST_CASE("ground that extends from behind the eye to the far plane ends at its horizon", "[visibility]") {
    for (const float extent : {50.0f, 1e4f, 1e6f, 1e9f}) {
        const std::vector<glm::vec3> p{
            {-extent, 0, extent}, {extent, 0, extent}, {extent, 0, -extent}, {-extent, 0, -extent}};
        Scene scene = looking_at(polygon_mesh(p, {{0, 1, 2, 3}}));
        scene.camera = {{0.3f, 1, 0.2f}, {0.3f, 0.9f, -5}, {0, 1, 0}, Perspective{50, 0.1f, 1000}};
        const PictureSize size{64, 48};
        Renderer renderer(1);
        renderer.render(scene, size);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const PixelRay ray = ray_through(scene.camera, size, x, y);
                const double depth = -ray.from.y / ray.direction.y;
                const glm::dvec3 hit = ray.from + depth * ray.direction;
                const bool within = std::abs(hit.x) < extent && std::abs(hit.z) < extent;
                if (std::abs(depth - 1000) < 50) continue;  // the far plane's edge
                CAPTURE(extent, x, y, depth);
                const bool seen = renderer.object_at(x, y) == 0;
                CHECK(seen == (depth > 0.1 && depth < 1000 && within));
                if (seen) {
                    CHECK(renderer.depth_at(x, y) == Approx(depth).epsilon(1e-5));
                }
            }
    }
}

TEST_CASE("at equal depth the first object is visible, and of its faces the first", "[visibility]") {
    const std::vector<glm::vec3> p{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    Scene scene = looking_at(polygon_mesh(p, {{0, 1, 2, 3}, {0, 1, 2, 3}}));
    scene.objects.push_back(scene.objects[0]);
    Renderer renderer(2);
    renderer.render(scene, {60, 60});
    for (int i = 0; i < 3600; ++i) {
        const Explanation e = renderer.explain(i % 60, i / 60);
        if (e.hit) {
            CHECK(e.object_index == 0);
            CHECK(e.face == 0);
        }
    }
}

TEST_CASE("culling drops the named side, even of a mirrored object", "[visibility]") {
    const std::vector<glm::vec3> p{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    const int side = GENERATE(9, 401);  // faces smaller than a tile are dropped before larger ones
    for (const float mirror : {1.0f, -1.0f}) {
        Scene scene = looking_at(polygon_mesh(p, {{0, 1, 2, 3}}));
        scene.objects[0].transform.scale.x = mirror;
        for (const bool from_behind : {false, true}) {
            scene.camera.eye = {0, 0, from_behind ? -5.0f : 5.0f};
            Renderer renderer(1);
            for (const Cull cull : {Cull::None, Cull::Back, Cull::Front}) {
                scene.shading.cull = cull;
                renderer.render(scene, {side, side});
                const bool dropped = cull == (from_behind ? Cull::Back : Cull::Front);
                CHECK(renderer.object_at(side / 2, side / 2) == (dropped ? -1 : 0));
                scene.objects[0].double_sided = true;
                renderer.render(scene, {side, side});
                CHECK(renderer.object_at(side / 2, side / 2) == 0);
                scene.objects[0].double_sided = false;
            }
        }
    }
}
