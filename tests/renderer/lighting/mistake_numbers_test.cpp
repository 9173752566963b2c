// The effects of single mistakes on a white plate, in numbers worked out by hand.
#include <array>
#include <cmath>
#include <initializer_list>

#include "renderer/lighting/light_job.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize plate_size{21, 21};

Light sun_from(glm::vec3 direction) {
    Light sun;
    sun.kind = LightKind::Directional;
    sun.position = {direction, 0};
    return sun;
}
Light bulb_at(glm::vec3 place) {
    Light bulb;
    bulb.position = {place, 1};
    return bulb;
}
Light lamp_at(glm::vec3 place, glm::vec3 aim) {
    Light lamp = bulb_at(place);
    lamp.kind = LightKind::Spot;
    lamp.spot = {aim, 30, 0};
    return lamp;
}

/// A white plate in z = 0 that faces +z, only diffuse, seen perpendicularly from (0, 0, 5); its centre is in
/// the centre pixel.
Scene plate(std::initializer_list<Light> lights, std::initializer_list<bool Mistakes::*> mistakes) {
    Scene scene;
    scene.camera = Camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, {}};
    scene.global_ambient = glm::vec3(0);
    scene.display.background = glm::vec3(0);
    scene.lights = lights;
    scene.objects = {object_of(primitive(Primitive::Plane, 3))};
    scene.objects[0].transform.rotate_deg.x = 90;
    Material& m = scene.objects[0].material;
    m.diffuse = m.specular = glm::vec3(1);
    m.ambient = glm::vec3(0);
    m.shininess = 2;
    scene.shading.terms.specular = false;
    scene.shading.reflection = Reflection::Phong;
    for (const auto mistake : mistakes) scene.shading.mistakes.*mistake = true;
    return scene;
}

Explanation middle_of_plate(const Scene& scene) {
    Renderer renderer(1);
    (void)renderer.render(scene, plate_size, true);
    return renderer.explain(10, 10);
}
float brightness(const Scene& scene) { return middle_of_plate(scene).sum.x; }

void check_vector(glm::vec3 is, glm::vec3 expected) {
    CAPTURE(is.x, is.y, is.z);
    for (int i = 0; i < 3; ++i) CHECK(is[i] == Approx(expected[i]).margin(1e-5));
}

std::array<int, 3> bytes_of(glm::vec3 color, const DisplayJob& job) {
    ColorBlock block{};
    block.r[0] = color.x, block.g[0] = color.y, block.b[0] = color.z;
    std::array<std::uint32_t, block_size> rgba{};
    lighting_kernels().encode(job, &block, rgba.data(), 1);
    const auto byte = [&](int shift) { return static_cast<int>(rgba[0] >> shift & 0xFF); };
    return {byte(0), byte(8), byte(16)};
}

}  // namespace

TEST_CASE("mistakes in the sum of lights: 1/4 + 1/2 becomes 1/2 (the last) or 3/8 (mean)", "[mistakes]") {
    Light first = sun_from({0, 0, 1}), off = first, last = first;
    first.intensity = 0.25f;
    last.intensity = 0.5f;
    off.enabled = false;
    CHECK(brightness(plate({first, last, off}, {})) == Approx(0.75));
    CHECK(brightness(plate({first, last, off}, {&Mistakes::last_light_only})) == Approx(0.5));
    CHECK(brightness(plate({first, last, off}, {&Mistakes::average_of_lights})) == Approx(0.375));
}

TEST_CASE("mistakes in the diffuse term: division by pi, and |n.l|", "[mistakes]") {
    const Light slanted = sun_from({0.6f, 0, 0.8f}), behind = sun_from({0.6f, 0, -0.8f});
    CHECK(brightness(plate({slanted}, {&Mistakes::missing_pi})) == Approx(0.8 / 3.14159265));
    CHECK(brightness(plate({behind}, {})) == 0);
    CHECK(brightness(plate({behind}, {&Mistakes::absolute_cosine})) == Approx(0.8));
    CHECK(brightness(plate({behind}, {&Mistakes::light_direction_reversed})) == Approx(0.8));
    CHECK(brightness(plate({slanted}, {&Mistakes::light_direction_reversed})) == 0);
}

TEST_CASE("mistakes in falloff: at distance 2, with 1 + r^2/4, 1/2 becomes 2 or 1", "[mistakes]") {
    Light bulb = bulb_at({0, 0, 2});
    bulb.falloff = {1, 0, 0.25f};
    CHECK(brightness(plate({bulb}, {})) == Approx(0.5));
    CHECK(brightness(plate({bulb}, {&Mistakes::falloff_inverted})) == Approx(2));
    CHECK(brightness(plate({bulb}, {&Mistakes::falloff_forgotten})) == Approx(1));
}

TEST_CASE("mistakes in the position of a light", "[mistakes]") {
    Scene scene = plate({sun_from({3, 0, 4})}, {});
    scene.objects[0].transform.translate = {0, 0, 1};
    CHECK(brightness(scene) == Approx(0.8));
    scene.shading.mistakes.direction_is_position = true;  // from (0, 0, 1) to (3, 0, 4)
    CHECK(brightness(scene) == Approx(std::sqrt(0.5)));

    // The camera is at (0, 0, 5): (0, 0, 2) in the world is (0, 0, -3) for it, or (0, 0, 7) by the inverse
    // matrix.
    Light bulb = bulb_at({0, 0, 2});
    CHECK(middle_of_plate(plate({bulb}, {})).at.lights[0].distance == Approx(2));
    CHECK(middle_of_plate(plate({bulb}, {&Mistakes::light_by_inverse_view})).at.lights[0].distance ==
          Approx(12));
    bulb.space = LightSpace::Camera;
    CHECK(middle_of_plate(plate({bulb}, {&Mistakes::light_by_inverse_view})).at.lights[0].distance ==
          Approx(7));
}

TEST_CASE("mistakes in the direction of a lamp", "[mistakes]") {
    const Light towards = lamp_at({0, 0, 2}, {0, 0, -1}), away = lamp_at({0, 0, 2}, {0, 0, 1});
    CHECK(brightness(plate({towards}, {})) == Approx(1));
    CHECK(brightness(plate({towards}, {&Mistakes::cone_cosines_swapped})) == 0);
    CHECK(brightness(plate({away}, {})) == 0);
    CHECK(brightness(plate({away}, {&Mistakes::cone_cosines_swapped})) == Approx(1));
    CHECK(brightness(plate({away}, {&Mistakes::aim_stays_at_origin})) == Approx(1));
    Light of_camera = away;  // at (0, 0, 3) in the world, with the origin straight ahead
    of_camera.space = LightSpace::Camera;
    of_camera.position = {0, 0, -2, 1};
    CHECK(brightness(plate({of_camera}, {})) == 0);
    CHECK(brightness(plate({of_camera}, {&Mistakes::aim_stays_at_origin})) == Approx(1));
}

TEST_CASE("an unnormalized l of length 2, 60 degrees off axis, is inside a 30-degree cone", "[mistakes]") {
    Scene scene = plate({lamp_at({0, 0, 2}, {std::sqrt(3.0f) / 2, 0, -0.5f})}, {});
    CHECK(brightness(scene) == 0);
    scene.shading.mistakes.unnormalized_light = true;
    CHECK(brightness(scene) == 0);
    scene.shading.mistakes.form = 1;  // cos 60 times 2 is more than cos 30; n.l is 2
    CHECK(brightness(scene) == Approx(2));
    scene.lights = {sun_from({0, 0, 3})};
    CHECK(brightness(scene) == Approx(3));
    scene.shading.mistakes.form = 2;  // not for directional lights
    CHECK(brightness(scene) == Approx(1));
}

TEST_CASE("mistakes in r: l = (3, 0, 4)/5 has r.v = 4/5, GLSL's sign -4/5, subtraction 8/25", "[mistakes]") {
    const auto r_dot_v = [](std::initializer_list<bool Mistakes::*> mistakes) {
        return middle_of_plate(plate({sun_from({0.6f, 0, 0.8f})}, mistakes)).at.lights[0].r_dot_v;
    };
    CHECK(r_dot_v({}) == Approx(0.8));
    CHECK(r_dot_v({&Mistakes::reflect_sign}) == Approx(-0.8));
    CHECK(r_dot_v({&Mistakes::reflect_of_difference}) == Approx(0.32));
    CHECK(r_dot_v({&Mistakes::view_reversed}) == Approx(-0.8));
}

TEST_CASE("mistakes in v: length 5 gives a highlight of 25, v leans in orthographic views", "[mistakes]") {
    Scene scene = plate({sun_from({0, 0, 1})}, {&Mistakes::unnormalized_view});
    scene.shading.terms = {false, false, false, true};
    CHECK(brightness(scene) == Approx(25));
    scene.shading.reflection = Reflection::Retro;
    CHECK(brightness(scene) == Approx(25));
    scene.shading.reflection = Reflection::BlinnPhong;  // h is normalized
    CHECK(brightness(scene) == Approx(1));

    Scene flat = plate({}, {});
    flat.camera.projection = Orthographic{2.1f, 0.1f, 100};
    Renderer renderer(1);
    (void)renderer.render(flat, plate_size, false);
    check_vector(renderer.explain(15, 10).at.view.camera, {0, 0, 1});
    flat.shading.mistakes.perspective_view_in_ortho = true;
    (void)renderer.render(flat, plate_size, false);
    const glm::vec3 to_eye = glm::vec3(-0.5f, 0, 5) / std::sqrt(25.25f);  // from (0.5, 0, 0) to (0, 0, 5)
    check_vector(renderer.explain(15, 10).at.view.camera, to_eye);
}

TEST_CASE("mistakes in the material, and in its explanation", "[mistakes]") {
    Scene scene = plate({sun_from({0, 0, 1})}, {});
    Material& m = scene.objects[0].material;
    m.diffuse = {0.5f, 0, 1};
    m.specular = {0.25f, 0.75f, 0};
    m.shininess = 4;
    const auto material = [&](bool Mistakes::*mistake) {
        scene.shading.mistakes = {};
        scene.shading.mistakes.*mistake = true;
        return middle_of_plate(scene).material;
    };
    check_vector(material(&Mistakes::coefficients_swapped).diffuse, {0.25f, 0.75f, 0});
    check_vector(middle_of_plate(scene).sum, {0.25f, 0.75f, 0});
    check_vector(material(&Mistakes::lit_in_srgb).diffuse, {0.735357f, 0, 1});
    check_vector(middle_of_plate(scene).sum, {0.735357f, 0, 1});
    CHECK(material(&Mistakes::shininess_inverted).shininess == 0.25f);
    CHECK(material(&Mistakes::shininess_as_fraction).shininess == 0.03125f);
}

TEST_CASE("mistakes in normals: the direction of the plate's normal", "[mistakes]") {
    const auto normal = [](std::initializer_list<bool Mistakes::*> mistakes, const auto& change) {
        Scene scene = plate({}, mistakes);
        change(scene);
        return middle_of_plate(scene).at.normal.camera;
    };
    const auto as_is = [](Scene&) {};
    const auto from_aside = [](Scene& s) { s.camera.eye = {3, 0, 4}; };
    const auto turned_away = [](Scene& s) { s.objects[0].transform.rotate_deg.x = -90; };
    const auto mirrored = [](Scene& s) { s.objects[0].transform.scale.x = -1; };
    check_vector(normal({}, as_is), {0, 0, 1});
    check_vector(normal({&Mistakes::normals_left_in_object}, as_is), {0, 1, 0});
    check_vector(normal({}, from_aside), {-0.6f, 0, 0.8f});
    check_vector(normal({&Mistakes::normals_left_in_world}, from_aside), {0, 0, 1});
    check_vector(normal({&Mistakes::normals_as_points}, as_is), {0, 0, -1});  // (0, 0, 1) + (0, 0, -5)
    check_vector(normal({}, mirrored), {0, 0, 1});
    check_vector(normal({&Mistakes::mirror_turns_inside_out}, mirrored), {0, 0, -1});
    check_vector(normal({}, turned_away), {0, 0, -1});
    check_vector(normal({&Mistakes::flipped_by_view}, turned_away), {0, 0, 1});
    check_vector(normal({&Mistakes::flipped_by_view}, as_is), {0, 0, 1});
    const auto two_sided = [&](Scene& s) {
        turned_away(s);
        s.shading.two_sided = true;
    };
    check_vector(normal({}, two_sided), {0, 0, 1});
    check_vector(normal({&Mistakes::flipped_twice}, two_sided), {0, 0, -1});
}

TEST_CASE("a reversed cross product flips facet and averaged normals, not analytic ones", "[mistakes]") {
    Scene scene = plate({}, {&Mistakes::cross_reversed});
    Object& o = scene.objects[0];
    o.normals.source = NormalSource::Analytic;
    check_vector(middle_of_plate(scene).at.normal.camera, {0, 0, 1});
    for (const NormalSource source : {NormalSource::Vertex, NormalSource::Facet}) {
        o.normals.source = source;
        check_vector(middle_of_plate(scene).at.normal.camera, {0, 0, -1});
    }
    o.normals.source = NormalSource::Analytic;
    scene.shading.mode = ShadingMode::Facet;
    check_vector(middle_of_plate(scene).at.normal.camera, {0, 0, -1});
}

TEST_CASE("every third facet is reversed in every mode, with all its corners", "[mistakes]") {
    Scene scene = plate({sun_from({0, 0, 1})}, {&Mistakes::some_faces_flipped});
    Renderer renderer(1);
    for (const ShadingMode mode :
         {ShadingMode::Flat, ShadingMode::Facet, ShadingMode::Gouraud, ShadingMode::Phong}) {
        scene.shading.mode = mode;
        const Picture& picture = renderer.render(scene, plate_size, true);
        int seen = 0, wrong = 0;
        for (int y = 0; y < plate_size.height; ++y)
            for (int x = 0; x < plate_size.width; ++x) {
                const Explanation e = renderer.explain(x, y);
                if (!e.hit) continue;
                ++seen;
                const float expected = e.face % 3 == 0 ? 0.0f : 1.0f;
                if (std::abs(picture.linear_at(x, y).x - expected) > 1e-5f) ++wrong;
            }
        CAPTURE(static_cast<int>(mode));
        CHECK(seen > 50);
        CHECK(wrong == 0);
    }
}

TEST_CASE("a face culled by the light disappears from every viewpoint", "[mistakes]") {
    for (const float z : {1.0f, -1.0f}) {
        Scene scene = plate({sun_from({0, 0, z})}, {&Mistakes::culled_by_light});
        CHECK(middle_of_plate(scene).hit == (z > 0));
        scene.camera.eye = {0, 0, -5};
        CHECK(middle_of_plate(scene).hit == (z > 0));
        // The plane's nearest corners are behind the eye: clipped faces are culled too.
        scene.camera = Camera{{0, 0.5f, 0.1f}, {0, 0, -0.2f}, {0, 1, 0}, {}};
        scene.objects[0].transform = {{0, 0, 0}, {0, 0, 0}, {50, 1, 50}};
        scene.lights[0].position = {0, z, 0, 0};
        CHECK(middle_of_plate(scene).hit == (z > 0));
    }
}

TEST_CASE("a wrapping byte maps 1.5 to 127 and -0.1 to 231, encoding 0.5 twice gives 188", "[mistakes]") {
    CHECK(bytes_of({0.25f, 0.5f, 1.5f}, {1, false}) == std::array{64, 128, 255});
    CHECK(bytes_of({0.5f, 1.5f, -0.1f}, {1, false, false, true}) == std::array{128, 127, 231});
    CHECK(bytes_of({1, 1e30f, std::nanf("")}, {1, false, false, true}) == std::array{255, 0, 0});
    CHECK(bytes_of({0.5f, 0, 7}, {1, false, true}) == std::array{188, 0, 255});
    CHECK(bytes_of({0.2140411f, 0, 1}, {1, true, true}) == std::array{188, 0, 255});  // once: 0.5
}

TEST_CASE("0 to the power 0 away from the mirror direction is NaN, and black as a byte", "[mistakes]") {
    // From (0.8, 0, 0.6): r = (-0.8, 0, 0.6). Seen from (3, 0, 2) r.v < 0; from (0, 0, 5) it is 0.6.
    Scene scene = plate({sun_from({0.8f, 0, 0.6f})}, {&Mistakes::power_zero_is_nan});
    scene.shading.terms.specular = true;
    scene.objects[0].material.shininess = 0;
    for (const ShadingMode mode : {ShadingMode::Gouraud, ShadingMode::Phong}) {
        scene.shading.mode = mode;
        scene.camera.eye = {0, 0, 5};
        CHECK(brightness(scene) == Approx(1.6));
        scene.camera.eye = {3, 0, 2};
        const Explanation e = middle_of_plate(scene);
        CHECK(std::isnan(e.sum.x));
        CHECK(e.byte == std::array{0, 0, 0});
        scene.lights[0].position.z = -0.6f;  // behind the plate: no highlight is computed
        CHECK(brightness(scene) == 0);
        scene.lights[0].position.z = 0.6f;
    }
}
