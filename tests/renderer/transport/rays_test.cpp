// Checks rays against brute force over all triangles in doubles, and shapes whose shadows are known.
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "renderer/renderer.h"
#include "renderer/transport/form_factor.h"
#include "renderer/transport/ray_scene.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;
using glm::dvec3;

namespace {

constexpr PictureSize ray_size{96, 72};

/// A triangle in world coordinates, in doubles.
struct PlainTriangle {
    dvec3 a, b, c;
    std::uint32_t object = 0, number = 0;
};

std::vector<PlainTriangle> triangles_of(const Scene& scene) {
    std::vector<PlainTriangle> all;
    for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
        const glm::dmat4 world = world_from_object(scene.objects[o].transform);
        const Mesh& mesh = *scene.objects[o].mesh;
        const auto corner = [&](std::uint32_t c) {
            const dvec3 p(mesh.positions[mesh.corner_position[c]]);
            return dvec3(glm::vec3(world * glm::dvec4(p, 1)));  // rounded like the renderer's
        };
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto& c = mesh.triangles[t].corner;
            all.push_back({corner(c[0]), corner(c[1]), corner(c[2]), o, t});
        }
    }
    return all;
}

/// How far along the ray the triangle is; infinity if the ray misses it. Möller and Trumbore (1997).
double distance_to(const PlainTriangle& t, dvec3 from, dvec3 along) {
    const dvec3 u = t.b - t.a, v = t.c - t.a, p = glm::cross(along, v), to = from - t.a;
    const double det = glm::dot(u, p), x = glm::dot(to, p) / det,
                 y = glm::dot(along, glm::cross(to, u)) / det;
    if (!(x >= 0 && y >= 0 && x + y <= 1)) return HUGE_VAL;
    const double at = glm::dot(v, glm::cross(to, u)) / det;
    return at > 0 ? at : HUGE_VAL;
}

Light bulb_at(glm::vec3 p) {
    Light light;
    light.position = {p, 1};
    return light;
}

/// A square of half-edge `half` at that height above white ground, seen from straight above without
/// perspective.
Scene plate_over_ground(float half, float height) {
    Scene scene;
    scene.camera.eye = {0, 20, 0};
    scene.camera.target = {0, 0, 0};
    scene.camera.up = {0, 0, -1};
    scene.camera.projection = Orthographic{8, 0.1f, 40};
    scene.global_ambient = {};
    Object plate = object_of(primitive(Primitive::Plane, 1), "Plate"),
           ground = object_of(primitive(Primitive::Plane, 1), "Ground");
    plate.transform = {{0, height, 0}, {}, {half, 1, half}};
    ground.transform.scale = {10, 1, 10};
    scene.objects = {plate, ground};
    for (Object& object : scene.objects) object.material.diffuse = glm::vec3(1);
    scene.shading.reflection = Reflection::Lambert;
    scene.transport.model = TransportModel::Shadows;
    return scene;
}

/// The x of the first and last shadowed pixel of the ground in row y, in world coordinates.
std::pair<double, double> shadow_in_row(const Scene& scene, int y) {
    const PictureSize large{801, 401};
    Renderer renderer;
    const Picture& picture = renderer.render(scene, large, true);
    const double unit = double{std::get<Orthographic>(scene.camera.projection).height} / large.height;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int x = 0; x < large.width; ++x) {
        if (renderer.object_at(x, y) != 1 || picture.linear_at(x, y) != glm::vec3(0)) continue;
        const double at = (x + 0.5 - large.width / 2.0) * unit;
        low = std::min(low, at - unit / 2);
        high = std::max(high, at + unit / 2);
    }
    return {low, high};
}

/// A convex shape under three lights outside it, with facet normals: no facet that faces a light is in
/// shadow.
Scene convex_scene(Primitive kind, int detail, float scale, glm::vec3 moved) {
    Scene scene;
    Object object = object_of(primitive(kind, detail));
    object.transform = {moved, {20, 35, 10}, glm::vec3(scale)};
    scene.objects = {object};
    scene.camera.eye = moved + scale * glm::vec3(1.5f, 2, 3);
    scene.camera.target = moved;
    scene.camera.projection = Perspective{40, 0.01f * scale, 100 * scale};
    scene.lights = {bulb_at(moved + scale * glm::vec3(-2, 3, 1)),
                    bulb_at(moved + scale * glm::vec3(2, 0.1f, 2))};
    Light sun;
    sun.kind = LightKind::Directional;
    sun.position = {0.3f, 1, 0.4f, 0};
    scene.lights.push_back(sun);
    scene.shading.mode = ShadingMode::Facet;
    return scene;
}

std::vector<std::uint8_t> bytes_under(Scene scene, TransportModel model) {
    scene.transport.model = model;
    Renderer renderer;
    return renderer.render(scene, ray_size).rgba;
}

}  // namespace

TEST_CASE("10,000 random rays meet the triangles that brute force finds", "[transport]") {
    Scene scene = busy_scene();
    scene.objects.push_back(object_of(primitive(Primitive::Knot, 24), "Knot"));
    scene.objects.back().transform = {{0.2f, 0.5f, -0.6f}, {40, 0, 70}, {0.5f, 0.7f, 0.6f}};
    RayScene rays;
    REQUIRE(rays.update(scene));
    CHECK_FALSE(rays.update(scene));
    const std::vector<PlainTriangle> all = triangles_of(scene);
    std::mt19937 random(7);
    int hits = 0, other_triangles = 0;
    for (int i = 0; i < 10'000; ++i) {
        const WorldRay ray{uniform_vec3(random, -2, 2), uniform_vec3(random, -1, 1), HUGE_VALF};
        const PlainTriangle* nearest = nullptr;
        double least = HUGE_VAL;
        for (const PlainTriangle& t : all) {
            const double at = distance_to(t, dvec3(ray.from), dvec3(ray.direction));
            if (at < least) least = at, nearest = &t;
        }
        const auto hit = rays.first_hit(ray);
        REQUIRE(hit.has_value() == (nearest != nullptr));
        CHECK(rays.is_blocked(ray) == hit.has_value());
        if (!hit) continue;
        ++hits;
        if (hit->object != nearest->object || hit->triangle != nearest->number) ++other_triangles;
        const RayStart start = rays.at_hit(ray, *hit);
        const dvec3 expected = dvec3(ray.from) + least * dvec3(ray.direction);
        CHECK(glm::distance(dvec3(start.p), expected) < 1e-6);
        WorldRay shorter = ray;
        shorter.reach = static_cast<float>(least * 0.999);
        CHECK_FALSE(rays.is_blocked(shorter));
    }
    CHECK(hits > 2000);
    CHECK(other_triangles == 0);
}

TEST_CASE("a packet of rays is blocked exactly where its single rays are", "[transport]") {
    Scene scene = busy_scene();
    scene.objects.push_back(object_of(primitive(Primitive::Knot, 24), "Knot"));
    RayScene rays;
    rays.update(scene);
    std::mt19937 random(8);
    int different = 0, blocked = 0;
    for (int i = 0; i < 5'000; ++i) {
        // From a small surface to a light, with some rays left out; every fourth packet is scattered.
        const float spread = i % 4 == 0 ? 2.0f : 0.05f;
        const glm::vec3 center = uniform_vec3(random, -2, 2), light = uniform_vec3(random, -3, 3);
        RayPacket packet{};
        unsigned expected = 0;
        for (unsigned k = 0; k < RayPacket::size; ++k) {
            const glm::vec3 from = center + uniform_vec3(random, -spread, spread);
            const WorldRay ray{from, light - from, 1};
            if (random() % 8 == 0) continue;
            packet.add(k, ray);
            expected |= rays.is_blocked(ray) ? 1u << k : 0u;
        }
        const unsigned found = rays.blocked(packet);
        different += found != expected ? 1 : 0;
        blocked += std::popcount(found);
    }
    CHECK(blocked > 5'000);
    CHECK(different == 0);
}

TEST_CASE("a hard shadow ends within a pixel of its projection", "[transport]") {
    const double pixel = 8.0 / 401;
    Scene scene = plate_over_ground(0.5f, 1);
    scene.lights = {bulb_at({0, 3, 0})};  // projects the plate to 3/2 of its size
    auto [low, high] = shadow_in_row(scene, 200);
    CHECK(low == Approx(-0.75).margin(pixel));
    CHECK(high == Approx(0.75).margin(pixel));
    scene.lights = {bulb_at({1, 3, 0})};  // x of the shadow: x + (x - 1) / 2
    std::tie(low, high) = shadow_in_row(scene, 200);
    CHECK(low == Approx(-1.25).margin(pixel));
    Light sun;
    sun.kind = LightKind::Directional;
    sun.position = {2, 1, 0, 0};  // moves the shadow by -2
    scene.lights = {sun};
    std::tie(low, high) = shadow_in_row(scene, 200);
    CHECK(low == Approx(-2.5).margin(pixel));
    CHECK(high == Approx(-1.5).margin(pixel));
}

TEST_CASE("a convex shape casts no shadow on facets that face the light, at any scale", "[transport]") {
    for (const auto& [kind, detail] : {std::pair{Primitive::Sphere, 200},
                                       {Primitive::Icosphere, 5},
                                       {Primitive::Cylinder, 999},
                                       {Primitive::Cone, 400},
                                       {Primitive::Cube, 7}})
        for (const float scale : {1e-3f, 1.0f, 1e3f})
            for (const glm::vec3& moved : {glm::vec3(0), scale * glm::vec3(40, -70, 25)}) {
                INFO(info_of(kind).choice.word << " at scale " << scale << ", x " << moved.x);
                const Scene scene = convex_scene(kind, detail, scale, moved);
                const auto local = bytes_under(scene, TransportModel::Local);
                const auto shadows = bytes_under(scene, TransportModel::Shadows);
                int differing = 0;
                for (std::size_t i = 0; i < local.size(); i += 4) differing += local[i] != shadows[i] ? 1 : 0;
                CHECK(differing == 0);
            }
}

/// A closed mesh, and a point inside it.
struct Closed {
    const char* name;
    MeshPtr mesh;
    glm::vec3 stretched{1}, inside{0};
};

/// A knot of a million triangles, an organic mesh of 70,000, and a thin plate with two round ends of slivers.
std::vector<Closed> closed_meshes() {
    std::vector<Closed> all{{"knot", primitive(Primitive::Knot, 2000)},
                            {"bumpy sphere", primitive(Primitive::BumpySphere, 264)},
                            {"plate", primitive(Primitive::Cylinder, 999), {1, 0.01f, 0.4f}}};
    const Mesh& knot = *all[0].mesh;
    const Triangle& t = knot.triangles[1000];
    const auto corner = [&](int k) { return knot.positions[knot.corner_position[t.corner[std::size_t(k)]]]; };
    const glm::vec3 n = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    all[0].inside = corner(0) - 0.25f * n;  // its tube has the radius 0.25
    return all;
}

TEST_CASE("no light leaks out of closed meshes of up to a million triangles", "[transport][release]") {
    for (const Closed& closed : closed_meshes())
        for (const float scale : {1e-3f, 1.0f, 1e3f}) {
            INFO(closed.name << " at scale " << scale);
            Scene scene = plate_over_ground(1, 0);
            scene.objects[0] = object_of(closed.mesh, "Shell");
            scene.objects[0].transform = {{0.3f, 0.9f, 0}, {0, 20, 0}, closed.stretched};
            const glm::mat4 world = world_from_object(scene.objects[0].transform);
            scene.lights = {bulb_at(glm::vec3(world * glm::vec4(closed.inside, 1)))};
            for (Object& object : scene.objects) {
                object.transform.translate *= scale;
                object.transform.scale *= scale;
            }
            scene.lights[0].position *= glm::vec4(glm::vec3(scale), 1);
            scene.camera.eye *= scale;
            scene.camera.projection = Orthographic{8 * scale, 0.1f * scale, 40 * scale};
            scene.display.background = {};
            const auto lit = [&scene] {
                const auto bytes = bytes_under(scene, TransportModel::Shadows);
                int count = 0;
                for (std::size_t i = 0; i < bytes.size(); i += 4) count += bytes[i] != 0 ? 1 : 0;
                return count;
            };
            CHECK(lit() == 0);
            scene.objects[0].visible = false;
            CHECK(lit() > 1000);
        }
}

TEST_CASE("closed meshes of up to a million triangles have no shadow acne at any scale",
          "[transport][release]") {
    // A ray from the outside meets the front of a triangle first; acne would be the back of a neighbour.
    // Light that grazes by less than a thousandth is left out: it is a quarter of a level of a byte at most.
    for (const Closed& closed : closed_meshes())
        for (const float scale : {1e-3f, 1.0f, 1e3f}) {
            Scene scene;
            scene.objects = {object_of(closed.mesh)};
            scene.objects[0].transform = {
                scale * glm::vec3(5, -3, 2), {20, 35, 10}, scale * closed.stretched};
            RayScene rays;
            rays.update(scene);
            const std::vector<PlainTriangle> all = triangles_of(scene);
            const auto normal = [](const PlainTriangle& t) {
                return glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
            };
            std::mt19937 random(3);
            int blocked = 0, acne = 0;
            for (int i = 0; i < 50'000; ++i) {
                const PlainTriangle& t = all[random() % all.size()];
                const double u = double(uniform(random, 0, 1)), v = (1 - u) * double(uniform(random, 0, 1));
                const dvec3 p = t.a + u * (t.b - t.a) + v * (t.c - t.a);
                glm::vec3 to = scale * uniform_vec3(random, -3, 3);
                if (glm::dot(normal(t), dvec3(to)) < 0) to = -to;
                if (glm::dot(normal(t), glm::normalize(dvec3(to))) < 1e-3) continue;
                const auto hit =
                    rays.first_hit(ray_to(rays.on_triangle({0, t.number}, p), glm::vec3(p) + to));
                if (!hit) continue;
                ++blocked;
                acne += glm::dot(normal(all[hit->triangle]), dvec3(to)) < 0 ? 0 : 1;
            }
            INFO(closed.name << " at scale " << scale << ", " << blocked << " blocked");
            CHECK((blocked > 1000) ==
                  (closed.mesh->triangles.size() > 500'000));  // the others are nearly convex
            CHECK(acne == 0);
        }
}

TEST_CASE("shadow rays from a knot are blocked exactly where brute force blocks them",
          "[transport][release]") {
    for (const float scale : {1e-3f, 1.0f, 1e3f}) {
        Scene scene = convex_scene(Primitive::Knot, 40, scale, scale * glm::vec3(3, -1, 2));
        scene.transport.model = TransportModel::Shadows;
        Renderer renderer;
        (void)renderer.render(scene, ray_size);
        const std::vector<PlainTriangle> all = triangles_of(scene);
        int wrong = 0, rays = 0, blocked = 0;
        for (int y = 0; y < ray_size.height; y += 3)
            for (int x = 0; x < ray_size.width; x += 3) {
                const auto seen = renderer.seen_at(x, y);
                if (!seen) continue;
                const TracedLight ray = renderer.shadow_rays(x, y).front();
                if (!ray.in_front) continue;
                ++rays;
                const dvec3 from(ray.from), along = dvec3(ray.to) - from;
                const bool expected = std::any_of(all.begin(), all.end(), [&](const PlainTriangle& t) {
                    return t.number != seen->triangle && distance_to(t, from, along) < 1;
                });
                wrong += ray.reached() == expected ? 1 : 0;
                blocked += expected ? 1 : 0;
            }
        INFO("scale " << scale << ", " << rays << " rays, " << blocked << " blocked");
        CHECK(rays > 100);
        CHECK(blocked > 10);
        CHECK(wrong == 0);
    }
}

TEST_CASE("form factors of plates agree with their closed forms", "[transport][release]") {
    Scene scene = plate_over_ground(0.5f, 1);
    Object& upper = scene.objects[0];
    scene.objects[1].transform.scale = {0.5f, 1, 0.5f};
    upper.transform.rotate_deg = {180, 0, 0};  // faces down
    const double pi = std::numbers::pi;
    // Two opposite unit squares at distance 1 (Howell, "A Catalog of Radiation Heat Transfer Configuration
    // Factors", C-11 with X = Y = 1).
    const double parallel =
        2 / pi * (std::log(2 / std::sqrt(3.0)) + 2 * std::sqrt(2.0) * std::atan(1 / std::sqrt(2.0)) - pi / 2);
    FormFactor f = form_factor(scene, 1, 0, 4'000'000, 1, 0);
    CHECK(f.estimate == Approx(parallel).epsilon(0.005));
    CHECK(std::abs(f.estimate - parallel) < 4 * f.standard_error);
    CHECK(f.area == Approx(1));
    CHECK(form_factor(scene, 1, 0, 100'000, 1, 1).arrived == form_factor(scene, 1, 0, 100'000, 1, 3).arrived);
    // Two unit squares with a common edge at 90 degrees (C-14 with H = W = 1).
    upper.transform = {{0, 0.5f, -0.5f}, {90, 0, 0}, {0.5f, 1, 0.5f}};
    const double perpendicular =
        1 / pi * (pi / 2 - std::sqrt(2.0) * std::atan(1 / std::sqrt(2.0)) + std::log(0.75) / 4);
    f = form_factor(scene, 1, 0, 4'000'000, 1, 0);
    CHECK(f.estimate == Approx(perpendicular).epsilon(0.005));
    // From its back, nothing arrives.
    upper.transform = {{0, -1, 0}, {}, {0.5f, 1, 0.5f}};
    CHECK(form_factor(scene, 1, 0, 1000, 1, 0).arrived == 0);
}
