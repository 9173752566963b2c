// Numbers as large as a scene may hold them: what they give is what the formulas say, and never no number.
#include <cmath>
#include <numbers>

#include "renderer/renderer.h"
#include "renderer/shade/light_sources.h"
#include "renderer/visibility/binning.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize extreme_size{21, 21};

/// A white plate in z = 0 that faces +z, seen square on, under one light; the middle pixel shows the
/// origin.
Scene plate_under(const Light& light) {
    Scene scene;
    scene.camera.projection = Orthographic{2, 0.1f, 100};
    scene.global_ambient = glm::vec3(0);
    scene.lights = {light};
    scene.objects = {object_of(primitive(Primitive::Plane, 2))};
    scene.objects[0].transform.rotate_deg.x = 90;
    scene.objects[0].material.diffuse = scene.objects[0].material.specular = glm::vec3(1);
    scene.shading.reflection = Reflection::Lambert;
    return scene;
}

Light light_at(LightKind kind, glm::vec3 place) {
    Light light;
    light.kind = kind;
    light.position = glm::vec4(place, 1);
    return light;
}

Explanation middle_pixel(const Scene& scene) {
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, extreme_size, true);
    Explanation e = renderer.explain(10, 10);
    CHECK(same_bits(e.sum, picture.linear_at(10, 10)));
    return e;
}

constexpr float powers_of_ten[] = {1e-18f, 1e-12f, 1e-6f, 1e6f, 1e12f, 1e15f, 1e17f, 1e18f};

/// Draws, holds every third pixel against its explanation, and counts the numbers that are none.
int drawn_without_a_number(const Scene& scene) {
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, extreme_size, true);
    for (int y = 0; y < extreme_size.height; y += 3)
        for (int x = 0; x < extreme_size.width; x += 3)
            CHECK(same_bits(renderer.explain(x, y).sum, picture.linear_at(x, y)));
    int without = 0;
    for (const float c : picture.linear) without += std::isnan(c);
    return without;
}

/// A cone, seen from a little above.
Scene cone_before(const Projection& projection) {
    Scene scene;
    scene.camera.eye = {0.3f, 1, 3};
    scene.camera.projection = projection;
    scene.lights = assorted_lights();
    scene.objects = {object_of(primitive(Primitive::Cone, 7))};
    scene.objects[0].transform.rotate_deg = {32, 47, 150};
    return scene;
}

constexpr Interpolation interpolations[] = {Interpolation::Perspective, Interpolation::Screen,
                                            Interpolation::Scanline};

/// Everything so many times as large: as seen, nothing differs.
Scene enlarged(Scene scene, float k) {
    scene.camera.eye *= k;
    scene.camera.target *= k;
    std::visit([k](auto& p) { p.near *= k, p.far *= k; }, scene.camera.projection);
    if (auto* p = std::get_if<Orthographic>(&scene.camera.projection)) p->height *= k;
    for (Light& l : scene.lights) {
        l.falloff.linear /= k, l.falloff.quadratic /= k * k;
        if (l.kind != LightKind::Directional) l.position = glm::vec4(k * glm::vec3(l.position), 1);
        l.area.edge_u *= k, l.area.edge_v *= k;
    }
    for (Object& o : scene.objects) o.transform.translate *= k, o.transform.scale *= k;
    return scene;
}

/// The largest difference of two pictures' bytes.
int apart(const Picture& a, const Picture& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(a.rgba[i] - b.rgba[i]));
    return most;
}

}  // namespace

TEST_CASE("a scene that is enlarged by a power of two, camera and all, gives the same picture", "[extreme]") {
    const PictureSize wide{96, 72};
    for (const Projection& projection : {Projection(Perspective{}), Projection(Orthographic{})}) {
        Scene scene = busy_scene();
        scene.camera.projection = projection;
        Renderer plain(1), large(1);
        const Picture& picture = plain.render(scene, wide, true);
        for (const int power : {-60, -40, -20, 20, 40, 48}) {
            CAPTURE(power);
            const Picture& other = large.render(enlarged(scene, std::ldexp(1.0f, power)), wide, true);
            CHECK(apart(picture, other) <= (std::abs(power) > 20 ? 1 : 0));
        }
        scene.lights.resize(1);  // the sun alone, whose light does not depend on places
        const Picture sunlit = plain.render(scene, wide, true);
        for (const int power : {-64, 64, 90}) {
            CAPTURE(power);
            CHECK(apart(sunlit, large.render(enlarged(scene, std::ldexp(1.0f, power)), wide, true)) <= 1);
        }
    }
}

TEST_CASE("an object stretched along any axis gives a picture of numbers, each of which can be explained",
          "[extreme]") {
    const Projection projections[] = {Perspective{}, Orthographic{}, Frustum{-0.1f, 0.05f, -0.05f, 0.1f}};
    for (const Projection& projection : projections)
        for (const Interpolation interpolation : interpolations)
            for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong})
                for (const float stretch : powers_of_ten)
                    for (int axis = 0; axis < 3; ++axis) {
                        Scene scene = cone_before(projection);
                        scene.shading.interpolation = interpolation;
                        scene.shading.mode = mode;
                        scene.objects[0].transform.scale[axis] = stretch;
                        scene.npr.silhouettes = axis == 1;
                        CAPTURE(projection.index(), static_cast<int>(interpolation), static_cast<int>(mode),
                                stretch, axis);
                        CHECK(drawn_without_a_number(scene) == 0);
                    }
}

TEST_CASE("a camera far away, or with extreme planes, angle or height, gives a picture of numbers",
          "[extreme]") {
    for (const float k : powers_of_ten) {
        CAPTURE(k);
        Scene far = cone_before(Perspective{45, 0.1f, 1e30f});
        far.camera.eye *= k;
        Scene near = cone_before(Perspective{45, 1e-45f, 3 + k});
        Scene narrow = cone_before(Perspective{std::min(1e-30f * k, 179.0f), 1e-45f, 100});
        Scene low = cone_before(Orthographic{k, 0.1f, 100});
        Scene slanted = cone_before(Frustum{-0.1f, 0.1f * k, -0.1f, 0.1f, 0.1f, 100});
        for (Scene* scene : {&far, &near, &narrow, &low, &slanted})
            for (const ShadingMode mode : {ShadingMode::Gouraud, ShadingMode::Phong})
                for (const bool bent : {false, true}) {
                    scene->shading.mode = mode;
                    scene->shading.mistakes.lit_after_projection = bent;
                    CHECK(drawn_without_a_number(*scene) == 0);
                }
    }
}

TEST_CASE("what a pixel blends are weights that sum to 1, also where the near plane leaves nothing of a face",
          "[extreme]") {
    int pixels = 0;
    for (const Projection& projection : {Projection(Perspective{}), Projection(Orthographic{})})
        for (const Interpolation interpolation : interpolations)
            for (const float stretch : {1.0f, 1e15f, 1e16f, 1e17f, 1e18f}) {
                Scene scene = cone_before(projection);
                scene.shading.mode = ShadingMode::Gouraud;
                scene.shading.interpolation = interpolation;
                scene.objects[0].transform.scale.z = stretch;
                Renderer renderer(1);
                (void)renderer.render(scene, extreme_size, true);
                for (int y = 0; y < extreme_size.height; ++y)
                    for (int x = 0; x < extreme_size.width; ++x) {
                        const Explanation e = renderer.explain(x, y);
                        if (!e.hit) continue;
                        float sum = 0;
                        for (const ExplainedCorner& corner : e.corners) sum += corner.weight;
                        CAPTURE(stretch, x, y, static_cast<int>(interpolation));
                        CHECK(sum == Approx(1).margin(0.01));
                        ++pixels;
                    }
            }
    CHECK(pixels > 1000);
}

TEST_CASE("every piece that clipping leaves lies on the rasteriser's grid, however large the object",
          "[extreme]") {
    std::size_t pieces = 0;
    for (const float stretch : {1e3f, 1e9f, 1e16f, 1e17f, 1e18f, 1e30f}) {
        Scene scene;
        scene.camera.eye = {0, 1, 3};
        scene.objects = {object_of(primitive(Primitive::Plane, 1))};
        scene.objects[0].transform = {{0, 0, 0}, {0, 33, 0}, {stretch, 1, stretch}};
        Geometry g;
        REQUIRE(update_geometry(g, scene, extreme_size));
        TileLists lists;
        bin_into_tiles(lists, g, Cull::None, false);
        pieces += lists.clipped.size();
        const std::int32_t most = 66 * 128 * extreme_size.width;  // 64 half widths from the middle, and some
        for (const ClippedTriangle& piece : lists.clipped)
            for (const ScreenVertex& v : piece.corner) {
                CAPTURE(stretch, v.x, v.y, v.inv_w);
                CHECK((std::abs(std::int64_t{v.x}) <= most && std::abs(std::int64_t{v.y}) <= most));
                CHECK((v.inv_w > 0 && v.inv_w <= 1 / 0.04f));  // 1 / w: behind the near plane at 0.1
            }
    }
    CHECK(pieces > 0);
}

TEST_CASE("a tone of two overflowing colours, and a stroke over what shines without bound, are numbers",
          "[extreme]") {
    Scene toned = plate_under(light_at(LightKind::Point, {0, 1, 1}));
    toned.npr.cool_to_warm = true;
    toned.npr.alpha = -1e30f, toned.npr.beta = 1e30f;
    toned.objects[0].material.diffuse = glm::vec3(1e30f);
    CHECK(drawn_without_a_number(toned) == 0);
    Scene stroked = plate_under(light_at(LightKind::Point, {0, 0, 1e-3f}));
    stroked.lights[0].falloff = {0, 0, 1e-30f};
    stroked.lights[0].diffuse = glm::vec3(1e30f);
    stroked.npr.creases = true;
    stroked.npr.crease_deg = 0;
    stroked.npr.stroke_width_px = 9;
    CHECK(drawn_without_a_number(stroked) == 0);
}

TEST_CASE("a point light lights however far it is, and its falloff with it", "[extreme]") {
    for (const float d : {1e10f, 1e17f, 1e19f, 1e25f, 1e30f}) {
        CAPTURE(d);
        Light light = light_at(LightKind::Point, {0, 0.6f * d, 0.8f * d});  // 3, 4, 5: n.l = 0.8
        const Explanation bare = middle_pixel(plate_under(light));
        CHECK(bare.sum.x == Approx(0.8));
        CHECK(bare.at.lights[0].distance == Approx(d));
        light.falloff = {1, 3 / d, 0};
        CHECK(middle_pixel(plate_under(light)).sum.x == Approx(0.2));  // 0.8 / (1 + 3)
    }
    for (const float d : {1e19f, 2e19f, 4e19f}) {  // beyond no float is small enough for c₂
        CAPTURE(d);
        Light light = light_at(LightKind::Point, {0, 0.6f * d, 0.8f * d});
        light.falloff = {1, 0, static_cast<float>(3.0 / d / d)};
        const double rounded = double{light.falloff.quadratic} * d * d;  // 3, but for the float's few digits
        CHECK(middle_pixel(plate_under(light)).sum.x == Approx(0.8 / (1 + rounded)).epsilon(1e-4));
    }
}

TEST_CASE("a light's cone is where it is however far the light, and no exponent makes it brighter",
          "[extreme]") {
    Light light = light_at(LightKind::Spot, {1e22f, 2e22f, 3e22f});
    light.spot = {{-1, -2, -3}, 20, 0};
    CHECK(middle_pixel(plate_under(light)).sum.x == Approx(3 / std::sqrt(14.0)));
    light.spot.direction = {1, -2, -3};
    CHECK(middle_pixel(plate_under(light)).sum.x == 0);
    light.spot = {{-1, -2, -3}, 20, 1e30f};  // cos 0 is 1, rounded perhaps a little more
    CHECK(middle_pixel(plate_under(light)).at.lights[0].spot <= 1);
}

TEST_CASE("a far and large area light gives A cos theta' / (pi r^2)", "[extreme]") {
    Light light = light_at(LightKind::Area, {0, 0, 1e22f});
    light.area = {{1e20f, 0, 0}, {0, 1e20f, 0}, 64};  // A = 4e40; all of it within a degree of its middle
    CHECK(middle_pixel(plate_under(light)).sum.x == Approx(4e40 / (std::numbers::pi * 1e44)).epsilon(1e-3));
}

TEST_CASE("no numbers that a scene may hold give a picture without a number", "[extreme]") {
    Light huge_area = light_at(LightKind::Area, {0, 0, 2});
    huge_area.area = {{1e30f, 0, 0}, {0, 1e30f, 0}, 4};
    Light huge_middle = huge_area;
    huge_middle.area.samples = 9;  // one sample is near
    Light bright = light_at(LightKind::Point, {3, 0, 1});
    bright.specular = bright.diffuse = {1e30f, 0, 1e30f};
    bright.intensity = 1e15f;
    Light below = bright;
    below.position.z = -1;  // n.l < 0: nothing of all that
    Light falling = bright;
    falling.falloff = {0, 0, 1e30f};
    Light far = bright;
    far.position = {1e30f, 1e30f, 1e30f, 1};
    for (const Light& light : {huge_area, huge_middle, bright, below, falling, far})
        for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong})
            for (const Reflection model :
                 {Reflection::Phong, Reflection::BlinnPhong, Reflection::CookTorrance}) {
                Scene scene = plate_under(light);
                scene.shading.mode = mode;
                scene.shading.reflection = model;
                scene.objects[0].material.diffuse = {1e30f, 1, 0};
                scene.objects[0].material.specular = {0, 1e30f, 1};
                Renderer renderer(1);
                int without = 0;
                for (const float c : renderer.render(scene, extreme_size, true).linear)
                    without += std::isnan(c);
                CAPTURE(static_cast<int>(mode), static_cast<int>(model));
                CHECK(without == 0);
            }
}

TEST_CASE("a light of no colour adds 0, however large its falloff times Cook-Torrance's highlight",
          "[extreme]") {
    Light light = light_at(LightKind::Point, {0, 0, 10});
    light.intensity = 0;
    light.falloff = {1e-25f, 0, 0};  // 1e25 times what arrives
    Scene scene = plate_under(light);
    scene.shading.reflection = Reflection::CookTorrance;
    scene.objects[0].material.f0 = glm::vec3(1e20f);
    scene.objects[0].material.ambient = scene.objects[0].material.emission = glm::vec3(0);
    CHECK(middle_pixel(scene).sum == glm::vec3(0));
    scene.lights[0].intensity = 1;
    CHECK(middle_pixel(scene).sum.x > 1e30f);
}
