// Compares pictures with closed forms: the equation in double at each pixel's ray, in world coordinates,
// while the renderer works in camera coordinates.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <optional>

#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;
using glm::dvec3;

namespace {

constexpr PictureSize size{97, 73};

/// The camera's ray through a pixel's sample, in world coordinates.
struct Rays {
    dvec3 eye, u, v, w;
    double half_height;

    explicit Rays(const Camera& c) : eye(c.eye) {
        w = glm::normalize(eye - dvec3(c.target));
        u = glm::normalize(glm::cross(dvec3(c.up), w));
        v = glm::cross(w, u);
        half_height = std::tan(glm::radians(double{std::get<Perspective>(c.projection).fov_y_deg}) / 2);
    }
    [[nodiscard]] dvec3 through(int x, int y) const {
        const double right = (x + 0.5 - size.width / 2.0) / (size.height / 2.0);
        const double up = (size.height / 2.0 - y - 0.5) / (size.height / 2.0);
        return glm::normalize(half_height * (right * u + up * v) - w);
    }
    [[nodiscard]] dvec3 world(const glm::vec4& a, LightSpace space) const {
        if (space == LightSpace::World) return dvec3(a);
        return double{a.x} * u + double{a.y} * v + double{a.z} * w + double{a.w} * eye;
    }
};

struct Place {
    dvec3 p, n;
};

/// The contribution of one point of light from direction l: Lambert's term and Phong's highlight.
dvec3 added(const Light& light, const Material& m, const Place& at, dvec3 l, dvec3 v, double strength) {
    const double n_l = glm::dot(at.n, l);
    const dvec3 r = 2 * n_l * at.n - l;
    const double shine = n_l > 0 ? std::pow(std::max(glm::dot(r, v), 0.0), double{m.shininess}) : 0;
    return strength * double{light.intensity} *
           (dvec3(m.ambient) * dvec3(light.ambient) +
            std::max(n_l, 0.0) * dvec3(m.diffuse) * dvec3(light.diffuse) +
            shine * dvec3(m.specular) * dvec3(light.specular));
}

dvec3 added_by_area(const Light& light, const Material& m, const Place& at, dvec3 v) {
    const dvec3 eu = light.area.edge_u, ev = light.area.edge_v, across = glm::cross(2.0 * eu, 2.0 * ev);
    const int n = static_cast<int>(std::lround(std::sqrt(light.area.samples)));
    dvec3 sum(0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const dvec3 to =
                dvec3(light.position) + ((2 * i + 1.0) / n - 1) * eu + ((2 * j + 1.0) / n - 1) * ev - at.p;
            const double r = glm::length(to);
            const double strength = std::abs(glm::dot(across, to / r)) / (std::numbers::pi * n * n * r * r);
            sum += added(light, m, at, to / r, v, strength);
        }
    return sum;
}

/// docs/scene_file.md, "The lighting equation", for one light.
dvec3 expected(const Scene& scene, const Rays& rays, const Place& at) {
    const Material& m = scene.objects[0].material;
    const Light& light = scene.lights[0];
    const dvec3 v = glm::normalize(rays.eye - at.p),
                base = dvec3(m.emission) + dvec3(m.ambient) * dvec3(scene.global_ambient);
    const dvec3 place = rays.world(light.position, light.space);
    if (light.kind == LightKind::Directional) return base + added(light, m, at, glm::normalize(place), v, 1);
    if (light.kind == LightKind::Area) return base + added_by_area(light, m, at, v);
    const double r = glm::length(place - at.p);
    const dvec3 l = (place - at.p) / r;
    double strength =
        1 / (light.falloff.constant + light.falloff.linear * r + light.falloff.quadratic * r * r);
    if (light.kind == LightKind::Spot) {
        const dvec3 axis = glm::normalize(rays.world({light.spot.direction, 0}, light.space));
        const double c = glm::dot(-l, axis);
        strength *=
            c >= std::cos(glm::radians(double{light.spot.cutoff_deg})) ? std::pow(c, light.spot.exponent) : 0;
    }
    return base + added(light, m, at, l, v, strength);
}

/// The largest difference between the picture and `expected` at rays that meet the shape, and the number of
/// those pixels.
template <class Meet> std::pair<double, int> largest_error(const Scene& scene, const Meet& meet) {
    const Rays rays(scene.camera);
    Renderer renderer;
    const Picture& picture = renderer.render(scene, size, true);
    double worst = 0;
    int compared = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::optional<Place> at = meet(rays.eye, rays.through(x, y));
            if (!at) continue;
            const dvec3 off = dvec3(picture.linear_at(x, y)) - expected(scene, rays, *at);
            worst = std::max({worst, std::abs(off.x), std::abs(off.y), std::abs(off.z)});
            ++compared;
        }
    return {worst, compared};
}

Scene lit_by(const Light& light, Primitive kind, int detail) {
    Scene scene;
    scene.camera.eye = {1, 2, 3.5f};
    scene.lights = {light};
    scene.objects = {object_of(primitive(kind, detail))};
    scene.objects[0].material.diffuse = {0.7f, 0.5f, 0.2f};
    scene.objects[0].material.specular = {0.5f, 0.6f, 0.7f};
    scene.objects[0].material.shininess = 12;
    return scene;
}

/// The strength of the assorted lights is continuous over these shapes except at the cone's edge, which is
/// kept off them.
std::vector<Light> lights_of_every_kind() {
    std::vector<Light> lights = assorted_lights();
    lights[2].spot.cutoff_deg = 80;
    return lights;
}

}  // namespace

TEST_CASE("a plane under each kind of light equals the equation at each pixel's ray", "[closed-form]") {
    for (const Light& light : lights_of_every_kind()) {
        const auto [worst, compared] = largest_error(
            lit_by(light, Primitive::Plane, 1), [](dvec3 eye, dvec3 ray) -> std::optional<Place> {
                const dvec3 p = eye - eye.y / ray.y * ray;
                if (ray.y >= 0 || std::max(std::abs(p.x), std::abs(p.z)) > 0.98) return std::nullopt;
                return Place{p, {0, 1, 0}};
            });
        INFO(light.name << ": " << worst);
        CHECK(compared > 800);
        CHECK(worst < 1e-6);
    }
}

TEST_CASE("a fine sphere under each kind of light equals the equation at each pixel's ray", "[closed-form]") {
    for (const Light& light : lights_of_every_kind()) {
        const auto [worst, compared] = largest_error(
            lit_by(light, Primitive::Sphere, 720), [](dvec3 eye, dvec3 ray) -> std::optional<Place> {
                const double b = glm::dot(eye, ray), c = glm::dot(eye, eye) - 1;
                if (b * b <= c) return std::nullopt;
                const dvec3 p = eye - (b + std::sqrt(b * b - c)) * ray;
                if (glm::dot(p, ray) > -0.3) return std::nullopt;  // the rim shows the mesh's chords
                return Place{p, p};
            });
        INFO(light.name << ": " << worst);
        CHECK(compared > 1000);
        // The rasterizer's grid of 1/256 pixel may pick the neighbour of a triangle that is smaller than a
        // pixel; the position is then off by up to half a grid step, 8e-5.
        CHECK(worst < 3e-4);
    }
}

TEST_CASE("a highlight of low shininess extends to small cosines: (v.r)^1 at 0.02 is 0.02", "[closed-form]") {
    // The plane faces the distant viewer and has v.r = n.l at each pixel.
    constexpr float cosine = 0.02f;
    Light sun;
    sun.kind = LightKind::Directional;
    sun.position = {std::sqrt(1 - cosine * cosine), 0, cosine, 0};
    Scene scene = lit_by(sun, Primitive::Plane, 1);
    scene.camera.eye = {0, 0, 5};
    scene.global_ambient = glm::vec3(0);
    scene.shading.local_viewer = false;
    scene.objects[0].transform.rotate_deg.x = 90;
    scene.objects[0].material = {};
    scene.objects[0].material.ambient = scene.objects[0].material.diffuse = glm::vec3(0);
    scene.objects[0].material.specular = glm::vec3(1);
    for (const float shininess : {0.5f, 1.0f, 2.0f}) {
        INFO("shininess " << shininess);
        scene.objects[0].material.shininess = shininess;
        Renderer renderer(1);
        const Picture& picture = renderer.render(scene, size, true);
        CHECK(picture.linear_at(size.width / 2, size.height / 2).x ==
              Approx(std::pow(double{cosine}, double{shininess})).epsilon(1e-4));
    }
}

TEST_CASE("a cone of 90 degrees includes its edge, where only the cosine is 0", "[closed-form]") {
    Light spot;
    spot.kind = LightKind::Spot;
    spot.position = {0, 1, 0, 1};
    spot.spot = {{1, 0, 0}, 90, 0};  // horizontal, so straight down is at 90 degrees
    Scene scene = lit_by(spot, Primitive::Plane, 1);
    scene.camera.eye = {0, 5, 0};
    scene.camera.up = {0, 0, -1};
    scene.objects[0].material.specular = glm::vec3(0);
    Renderer renderer(1);
    const glm::vec3 below = renderer.render(scene, {1, 1}, true).linear_at(0, 0);
    const dvec3 base = dvec3(scene.objects[0].material.ambient) *
                       (dvec3(scene.global_ambient) + dvec3(scene.lights[0].ambient));
    CHECK(below.x == Approx(base.x + 0.7));  // k_d times n·l = 1
    CHECK(below.y == Approx(base.y + 0.5));
    CHECK(below.z == Approx(base.z + 0.2));
}
