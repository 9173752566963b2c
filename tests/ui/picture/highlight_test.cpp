// Where the specular term is largest after a highlight is dragged, as measured in the picture.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/catch.h"
#include "tests/support/scenes.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/handles/highlight_drag.h"
#include "ui/picture/handles/light_handles.h"

using namespace glint;

namespace {

const PictureSize highlight_picture{360, 240};

/// Whether lights get fainter with distance and off their axes, which shifts the peak away from r = v.
enum class Fall { No, Off };

using Models = std::array<Reflection, 2>;
constexpr Models powers{Reflection::Phong, Reflection::BlinnPhong};

/// A random scene with one smooth object and one light, which is dragged by its highlight.
class Grab {
  public:
    Grab(std::mt19937& random, Renderer& renderer, const std::vector<Object>& shapes, Fall fall,
         Models models)
        : random_(random), renderer_(renderer) {
        scene.objects = {shapes[random() % shapes.size()]};
        Object& object = scene.objects[0];
        object.transform.rotate_deg = {number(0, 360), number(0, 360), number(0, 360)};
        object.material.shininess = std::exp2(number(2, 8));
        const glm::vec3 way = direction();
        const glm::vec3 flat = std::abs(way.y) > 0.97f ? glm::vec3(1, 0.2f, 0) : way;
        scene.camera.eye = glm::normalize(flat) * number(3, 7);
        if (random() % 3 == 0) scene.camera.projection = Orthographic{number(2, 3.5f)};
        object.material.roughness = number(0.15f, 0.6f);
        scene.shading.reflection = models[random() % 2];
        scene.shading.local_viewer = random() % 4 != 0;
        map = screen_map(scene.camera, highlight_picture);
        dome = sun_dome(scene.camera.target, scene_bounds(scene), map);
        add_light(fall);
        renderer.render(scene, highlight_picture);
    }
    float number(float low, float high) { return low + (high - low) * float(random_() % 65536) / 65535; }
    glm::vec3 direction() {
        const float z = number(-1, 1), a = number(0, 6.2831853f), r = std::sqrt(1 - z * z);
        return {r * std::cos(a), z, r * std::sin(a)};
    }
    [[nodiscard]] SurfaceView view() const { return {scene, renderer_, map, dome}; }

    /// A pixel on the object, but not at its rim, where no light could peak.
    glm::dvec2 pixel_on_it() {
        for (int i = 0; i < 10'000; ++i) {
            const glm::dvec2 pixel = glm::floor(glm::dvec2{number(0, 359), number(0, 239)}) + 0.5;
            const auto point = seen_at(renderer_, highlight_picture, pixel);
            if (!point) continue;
            const glm::vec3 v = is_orthographic(scene.camera.projection) || !scene.shading.local_viewer
                                    ? glm::vec3(0, 0, 1)
                                    : -glm::normalize(point->position);
            if (glm::dot(point->normal, v) > 0.3f && patch_is_whole(pixel)) return pixel;
        }
        FAIL("the object is not visible");
        return {};
    }

    Scene scene;
    ScreenMap map;
    Dome dome;

  private:
    [[nodiscard]] bool patch_is_whole(glm::dvec2 pixel) const {
        const auto patch = surface_patch(renderer_, highlight_picture, pixel, 6);
        return patch && std::count(patch->used.begin(), patch->used.end(), false) == 0;
    }
    void add_light(Fall fall) {
        Light& light = scene.lights.emplace_back();
        const LightKind kinds[] = {LightKind::Directional, LightKind::Point, LightKind::Spot,
                                   LightKind::Area};
        light.kind = kinds[random_() % (fall == Fall::Off ? 4 : 3)];
        light.position = {direction() * number(2, 5), light.kind == LightKind::Directional ? 0 : 1};
        if (fall == Fall::Off && light.kind != LightKind::Directional)
            light.falloff = {1, number(0, 0.5f), number(0, 0.3f)};
        light.spot.direction = -glm::vec3(light.position);
        light.spot.cutoff_deg = number(25, 60);
        light.spot.exponent = fall == Fall::Off ? number(0, 10) : 0;
        light.area.edge_u =
            glm::normalize(glm::cross(glm::vec3(light.position), direction())) * number(0.1f, 0.4f);
        light.area.edge_v =
            glm::normalize(glm::cross(glm::vec3(light.position), light.area.edge_u)) * number(0.1f, 0.4f);
        if (random_() % 2 == 0) light = in_space(light, LightSpace::Camera, scene.camera);
    }
    std::mt19937& random_;
    Renderer& renderer_;
};

Object object_of(Primitive primitive, glm::vec3 scale = glm::vec3(1)) {
    Object object = test::object_of(test::primitive(primitive, info_of(primitive).default_detail));
    object.transform.scale = scale;
    return object;
}

std::vector<Object> round_shapes() {
    return {object_of(Primitive::Sphere), object_of(Primitive::Icosphere),
            object_of(Primitive::Sphere, {1.3f, 0.7f, 1}), object_of(Primitive::Icosphere, {0.6f, 1, 1.4f})};
}

std::vector<Object> hollow_shapes() {
    return {object_of(Primitive::Torus), object_of(Primitive::Knot), object_of(Primitive::Teapot),
            object_of(Primitive::BumpySphere)};
}

/// The specular term alone, one number per pixel, as the engine draws it.
std::vector<float> specular_picture(Renderer& renderer, Scene scene) {
    scene.shading.terms = {false, false, false, true};
    scene.display.background = glm::vec3(0);
    const Picture& picture = renderer.render(scene, highlight_picture, true);
    std::vector<float> green;
    for (std::size_t i = 0; i < picture.linear.size(); i += 3) green.push_back(picture.linear[i + 1]);
    return green;
}

/// The pixel with the largest value within `radius` pixels; among equal values, the nearest.
glm::dvec2 peak_near(const std::vector<float>& values, glm::dvec2 pixel, int radius) {
    glm::dvec2 peak = pixel;
    float largest = -1;
    double nearest = 0;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) {
            const glm::dvec2 at = pixel + glm::dvec2(x, y);
            if (at.x < 0 || at.y < 0 || at.x >= highlight_picture.width || at.y >= highlight_picture.height)
                continue;
            const float value =
                values[std::size_t(at.y) * std::size_t(highlight_picture.width) + std::size_t(at.x)];
            const double away = glm::length(glm::dvec2(x, y));
            if (value < largest * (1 - 1e-5f) || (value <= largest * (1 + 1e-5f) && away >= nearest))
                continue;
            largest = value, nearest = away, peak = at;
        }
    return peak;
}

/// Returns how many of `count` random grabs leave the peak more than a pixel away from the cursor.
int misses(unsigned seed, int count, const std::vector<Object>& shapes, Fall fall, Models models = powers) {
    std::mt19937 random(seed);
    Renderer renderer(1);
    int missed = 0, kinds[4] = {};
    for (int i = 0; i < count; ++i) {
        Grab grab(random, renderer, shapes, fall, models);
        const glm::dvec2 from = grab.pixel_on_it(), to = grab.pixel_on_it();
        const auto drag = grab_highlight(grab.view(), grab.scene.lights[0], from);
        REQUIRE(drag);
        const auto light = dragged_highlight(*drag, grab.view(), to);
        REQUIRE(light);
        grab.scene.lights[0] = *light;
        if (glm::length(peak_near(specular_picture(renderer, grab.scene), to, 3) - to) > 1) ++missed;
        ++kinds[static_cast<int>(light->kind)];
    }
    for (int kind = 0; kind < (fall == Fall::Off ? 4 : 3); ++kind) CHECK(kinds[kind] > count / 5);
    return missed;
}

}  // namespace

TEST_CASE("after a highlight drag the specular peak is within a pixel in 999 of 1,000",
          "[ui][hands][property][long][release]") {
    CHECK(misses(20, 1000, round_shapes(), Fall::Off) <= 1);
}

TEST_CASE("the dragged peak is within a pixel on saddles and bumps, without falloff",
          "[ui][hands][property][long][release]") {
    CHECK(misses(21, 1000, hollow_shapes(), Fall::No) <= 1);
}

// Where the normal hardly changes along some direction, falloff and a cone may leave no solution at the
// light's own distance or with its own aim.
TEMPLATE_TEST_CASE_SIG("the dragged peak is within a pixel on saddles and bumps, with falloff",
                       "[ui][hands][property][long][release]", ((unsigned seed), seed), 22, 101) {
    CHECK(misses(seed, 1000, hollow_shapes(), Fall::Off) <= 1);
}

TEST_CASE("the dragged peak is within a pixel with retro-reflection and with microfacets",
          "[ui][hands][property][long][release]") {
    CHECK(misses(23, 1000, round_shapes(), Fall::No, {Reflection::Retro, Reflection::CookTorrance}) <= 1);
}
