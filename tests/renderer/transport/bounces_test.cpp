// Bounced light and shadows in pictures: closed forms of a furnace, and guarantees for every picture.
#include <cmath>
#include <glm/geometric.hpp>

#include "models/progress.h"
#include "renderer/renderer.h"
#include "tests/support/as_fresh.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize size{32, 24};

/// A ball seen from inside. If it has two halves, every point in it sees both halves equally.
Scene furnace(float k_d, glm::vec3 emission) {
    Scene scene;
    scene.camera.eye = {0.2f, 0.1f, 0.3f};
    scene.camera.target = {0, 0, -1};
    scene.camera.projection = Perspective{60, 0.01f, 10};
    scene.objects = {object_of(primitive(Primitive::Sphere, 96), "Ball")};
    scene.objects[0].normals.flip = true;
    scene.objects[0].material.diffuse = glm::vec3(k_d);
    scene.objects[0].material.emission = emission;
    scene.shading.reflection = Reflection::Lambert;
    scene.transport = {TransportModel::Bounces, 16, 4, 1};
    return scene;
}

/// A furnace of two hemispheres, one of which reflects and emits more.
Scene furnace_of_halves() {
    Scene scene = furnace(0.5f, glm::vec3(0));
    const Mesh& ball = *scene.objects[0].mesh;
    std::vector<std::vector<std::uint32_t>> halves[2];
    for (std::uint32_t f = 0; f < ball.face_count(); ++f) {
        const auto corners = ball.corners_of(f);
        float x = 0;
        for (const std::uint32_t c : corners) x += ball.positions[c].x;
        halves[x > 0].emplace_back(corners.begin(), corners.end());
    }
    scene.objects.push_back(scene.objects[0]);
    for (std::size_t i = 0; i < 2; ++i) {
        scene.objects[i].mesh = polygon_mesh(ball.positions, halves[i]);
        scene.objects[i].material.diffuse = glm::vec3(i == 0 ? 0.2f : 0.8f);
        scene.objects[i].material.emission = glm::vec3(i == 0 ? 0.1f : 1.5f);
    }
    return scene;
}

/// The light that arrives in this furnace after at most `bounces` surfaces: the mean emission of 0.8, halved
/// by each additional surface.
double arriving_in_halves(int bounces) {
    double sum = 0;
    for (int k = 0; k < bounces; ++k) sum += 0.8 * std::pow(0.5, k);
    return sum;
}

/// busy_scene() on a ground plane, with a light of each kind.
Scene transport_scene(TransportModel model, ShadingMode mode) {
    Scene scene = busy_scene();
    scene.objects.push_back(object_of(primitive(Primitive::Plane, 1), "Ground"));
    scene.objects.back().transform = {{0, -0.8f, 0}, {}, {4, 1, 4}};
    scene.objects.back().material.diffuse = {0.2f, 0.7f, 0.3f};
    scene.shading.mode = mode;
    scene.transport = {model, 5, 3, 1};
    return scene;
}

}  // namespace

TEST_CASE("a white furnace is as bright as its truncated series", "[transport]") {
    for (const int bounces : {0, 1, 4, 16}) {
        Scene scene = furnace(0.5f, glm::vec3(1));
        scene.transport.bounces = bounces;
        Renderer renderer;
        const Picture& picture = renderer.render(scene, size, true);
        const float expected = static_cast<float>(2 - std::pow(0.5, bounces));
        for (int y = 0; y < size.height; y += 5)
            for (int x = 0; x < size.width; x += 5) CHECK(picture.linear_at(x, y).x == Approx(expected));
    }
}

TEST_CASE("light in a furnace of two halves is within four standard errors of its series", "[transport]") {
    Scene scene = furnace_of_halves();
    scene.transport.paths = 2000;
    for (const int bounces : {1, 5}) {
        scene.transport.bounces = bounces;
        Renderer renderer;
        (void)renderer.render(scene, {8, 6});
        const Explanation e = renderer.explain(4, 3);
        CHECK(e.at.bounces.paths == 2000);
        const double error = double(e.at.bounces.standard_error.x);
        CHECK(error > 0.005);
        CHECK(error < 0.04);
        CHECK(std::abs(double(e.at.bounces.arrives.x) - arriving_in_halves(bounces)) < 4 * error);
    }
}

TEST_CASE("the error of bounced light falls with the square root of the number of paths", "[transport]") {
    const Scene scene = furnace_of_halves();
    const double expected = arriving_in_halves(4);
    const auto error_with = [&](int paths) {
        Scene with = scene;
        with.transport.paths = paths;
        Renderer renderer;
        (void)renderer.render(with, size);
        double squares = 0;
        int count = 0;
        for (int y = 0; y < size.height; y += 2)
            for (int x = 0; x < size.width; x += 2, ++count)
                squares += std::pow(double(renderer.explain(x, y).at.bounces.arrives.x) - expected, 2);
        return std::sqrt(squares / count);
    };
    const double slope = std::log2(error_with(256) / error_with(4)) / 6;
    CHECK(slope == Approx(-0.5).margin(0.05));
}

TEST_CASE("an explanation equals its pixel under shadows and bounces", "[transport][explain]") {
    for (const TransportModel model : {TransportModel::Shadows, TransportModel::Bounces})
        for (const ShadingMode mode :
             {ShadingMode::Phong, ShadingMode::Facet, ShadingMode::Gouraud, ShadingMode::Flat}) {
            Scene scene = transport_scene(model, mode);
            for (const bool mistake : {false, true}) {
                INFO("model " << int(model) << " mode " << int(mode) << " mistake " << mistake);
                scene.shading.mistakes.no_clamp_of_cosine = mistake;
                Renderer renderer, local;
                Scene before = scene;
                before.transport = {};
                (void)local.render(before, size);
                const Picture& picture = renderer.render(scene, size, true);
                int differing = 0, blocked = 0;
                for (int y = 0; y < size.height; ++y)
                    for (int x = 0; x < size.width; ++x) {
                        const Explanation e = renderer.explain(x, y);
                        differing += same_bits(e.sum, picture.linear_at(x, y)) ? 0 : 1;
                        if (x % 8 == 4 && y % 8 == 4)
                            differing += same_bits(local.explain_as(scene, x, y).sum, e.sum) ? 0 : 1;
                        for (const ExplainedLight& light : e.at.lights) blocked += light.reached < 1 ? 1 : 0;
                    }
                CHECK(differing == 0);
                const bool lit_at_pixels = mode == ShadingMode::Phong || mode == ShadingMode::Facet;
                CHECK((blocked > 50) == lit_at_pixels);
            }
        }
}

TEST_CASE("a picture refined path by path has the same bytes as one with all paths at once", "[transport]") {
    Scene scene = transport_scene(TransportModel::Bounces, ShadingMode::Phong);
    Renderer refined(1), at_once(2);
    for (const int paths : {1, 2, 5, 9}) {
        scene.transport.paths = paths;
        (void)refined.render(scene, size, true);
    }
    CHECK(refined.render(scene, size, true).linear == at_once.render(scene, size, true).linear);
    scene.transport.paths = 3;  // fewer paths than before
    draw_as_fresh(refined, scene, size, true);
}

TEST_CASE("a cancelled picture is discarded, and the next one is complete", "[transport]") {
    Scene scene = transport_scene(TransportModel::Bounces, ShadingMode::Phong);
    Renderer renderer;
    LoadProgress load;
    const ProgressScope scope(load);
    load.cancelled = true;
    CHECK_THROWS_AS((void)renderer.render(scene, size), LoadCancelled);
    load.cancelled = false;
    int last = 0;
    renderer.on_paths([&last](int done, int all) { last = done == all ? done : 0; });
    draw_as_fresh(renderer, scene, size, true);
    CHECK(last == scene.transport.paths);
    scene.transport.model = TransportModel::Local;
    load.cancelled = true;  // no rays, nothing to cancel
    draw_as_fresh(renderer, scene, size);
}

TEST_CASE("a penumbra shows the visible part of an area light", "[transport]") {
    // A blade from x = -3 to 0 at height 1, a lamp from x = -0.5 to 0.5 at height 3: from the ground at x,
    // the blade's edge hides the lamp up to -2 x.
    Scene scene;
    scene.camera.eye = {0, 20, 0};
    scene.camera.up = {0, 0, -1};
    scene.camera.projection = Orthographic{0.2f, 0.1f, 40};  // one pixel: 0.005
    Light lamp;
    lamp.name = "Lamp";
    lamp.kind = LightKind::Area;
    lamp.position = {0, 3, 0, 1};
    lamp.area = {{0.5f, 0, 0}, {0, 0, 0.5f}, 64};
    scene.lights = {lamp};
    Object blade = object_of(primitive(Primitive::Plane, 1), "Blade"),
           ground = object_of(primitive(Primitive::Plane, 1), "Ground");
    blade.transform = {{-1.5f, 1, 0}, {}, {1.5f, 1, 3}};
    ground.transform.scale = {10, 1, 10};
    scene.objects = {ground, blade};
    scene.transport.model = TransportModel::Shadows;
    Renderer renderer;
    const PictureSize large{400, 40};
    (void)renderer.render(scene, large);
    int partial = 0;
    for (int x = 201; x < large.width; x += 2) {  // to the left, the blade is in the camera's way
        const Explanation e = renderer.explain(x, 20);
        const double at = double(e.at.point.world.x), visible = std::clamp(0.5 + 2 * at, 0.0, 1.0);
        CHECK(std::abs(double(e.at.lights[0].reached) - visible) <= 1.0 / 16 + 1e-3);
        if (e.at.lights[0].reached == 1) continue;
        ++partial;
        CHECK(e.at.lights[0].blocked_by == "Blade");
    }
    CHECK(partial > 5);
}

TEST_CASE("the steps of a path add up to the light that the path contributes", "[transport]") {
    Scene scene = transport_scene(TransportModel::Bounces, ShadingMode::Phong);
    scene.transport.paths = 1;
    Renderer renderer;
    (void)renderer.render(scene, size);
    int longest = 0;
    for (int x = 8; x < 24; ++x) {
        glm::vec3 sum(0), throughput(1);
        const std::vector<PathStep> steps = renderer.bounce_path(x, 14, 0);
        for (const PathStep& step : steps) {
            sum += step.throughput * (step.emission + step.direct);
            CHECK(same_bits(step.throughput, throughput));
            if (step.object >= 0)
                throughput *= scene.objects[static_cast<std::size_t>(step.object)].material.diffuse;
        }
        const Explanation e = renderer.explain(x, 14);
        if (e.hit) CHECK(same_bits(e.at.bounces.arrives, sum));
        longest = std::max(longest, static_cast<int>(steps.size()));
    }
    CHECK(longest == 3);
}
