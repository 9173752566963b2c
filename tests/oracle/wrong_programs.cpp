#include "tests/oracle/wrong_programs.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "tests/oracle/gl_parts.h"

namespace glint::oracle {
namespace {

using Change = std::function<bool(Scene&)>;

/// Changes every light; the mistake does not apply to the scene if no light changes.
Change lights(const std::function<bool(Light&, const Scene&)>& change) {
    return [change](Scene& scene) {
        bool any = false;
        for (Light& light : scene.lights) any |= change(light, scene);
        return any;
    };
}

/// Transforms a light in its own space so that it moves by `by`.
void move(Light& light, const glm::dmat4& by) {
    const glm::dmat3 turn(by);
    light.position = glm::vec4(by * glm::dvec4(light.position));
    light.spot.direction = glm::vec3(turn * glm::dvec3(light.spot.direction));
    light.area.edge_u = glm::vec3(turn * glm::dvec3(light.area.edge_u));
    light.area.edge_v = glm::vec3(turn * glm::dvec3(light.area.edge_v));
}

bool other_space(Light& light, const Scene&) {
    light.space = light.space == LightSpace::World ? LightSpace::Camera : LightSpace::World;
    return true;
}

bool moved_twice(Light& light, const Scene& scene) {
    if (light.space == LightSpace::World) move(light, look_at(scene.camera));
    light.space = LightSpace::World;
    return true;
}

bool by_inverse_view(Light& light, const Scene& scene) {
    if (light.space == LightSpace::Camera) return false;
    const glm::dmat4 back = glm::inverse(look_at(scene.camera));
    move(light, back);
    light.space = LightSpace::Camera;
    return true;
}

bool direction_is_position(Light& light, const Scene&) {
    if (light.kind != LightKind::Directional) return false;
    light.kind = LightKind::Point;
    light.position.w = 1;
    light.falloff = {};
    return true;
}

bool half_cutoff(Light& light, const Scene&) {
    if (light.kind != LightKind::Spot || light.spot.cutoff_deg > 90) return false;
    light.spot.cutoff_deg /= 2;
    return true;
}

bool aims_at_origin(Light& light, const Scene& scene) {
    if (light.kind != LightKind::Spot) return false;
    const glm::vec3 place = glm::vec3(light.position) / light.position.w;
    const glm::vec3 origin =
        light.space == LightSpace::World ? glm::vec3(0) : glm::vec3(look_at(scene.camera)[3]);
    light.spot.direction = origin - place;
    return true;
}

bool no_falloff(Light& light, const Scene&) {
    if (light.kind == LightKind::Directional || light.kind == LightKind::Area) return false;
    light.falloff = {};
    return true;
}

bool last_light_only(Scene& scene) {
    const auto enabled = [](const Light& l) { return l.enabled; };
    const auto last = std::find_if(scene.lights.rbegin(), scene.lights.rend(), enabled);
    if (last == scene.lights.rend()) return false;
    const Light light = *last;
    scene.lights = {light};
    return true;
}

bool average(Scene& scene) {
    const auto count =
        std::count_if(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.enabled; });
    for (Light& light : scene.lights)
        light.intensity /= static_cast<float>(std::max<std::ptrdiff_t>(1, count));
    return count > 1;
}

float srgb(float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f; }

bool encoded_materials(Scene& scene) {
    for (Object& o : scene.objects)
        for (glm::vec3* color :
             {&o.material.ambient, &o.material.diffuse, &o.material.specular, &o.material.emission})
            for (int c = 0; c < 3; ++c) {
                if ((*color)[c] > 1) return false;
                (*color)[c] = srgb((*color)[c]);
            }
    return true;
}

bool swapped_coefficients(Scene& scene) {
    for (Object& o : scene.objects) std::swap(o.material.diffuse, o.material.specular);
    return true;
}

bool one_sided(Scene& scene) { return std::exchange(scene.shading.two_sided, false); }

/// Without a local viewer, lighting does not use the eye's position.
bool only_orthographic(Scene& scene) {
    return is_orthographic(scene.camera.projection) && scene.shading.local_viewer;
}

const std::string falloff = "1.0 / (light.falloff.x + light.falloff.y * r + light.falloff.z * r * r)";

const std::vector<WrongProgram> table{
    {"unnormalized_half", {{"dot(n, h) / size", "dot(n, h) / 2.0"}}, {}, {}},
    {"specular_behind_surface", {{"n_l > 0.0 ? highlight(n, l, v) : vec3(0)", "highlight(n, l, v)"}}, {}, {}},
    {"half_angle_with_phong_shininess", {{"dot(reflect(-l, n), v)", "dot(n, normalize(l + v))"}}, {}, {}},
    {"ambient_per_light_added_twice", {{"(light.ambient * k_a", "(2.0 * light.ambient * k_a"}}, {}, {}},
    {"clamp_each_light",
     {{"return strength * (light.ambient * k_a + diffuse * light.diffuse * k_d + shine)",
       "return min(strength * (light.ambient * k_a + diffuse * light.diffuse * k_d + shine), vec3(1))"}},
     {},
     {}},
    {"shininess_as_fraction", {{", shininess)", ", shininess / 128.0)"}}, {}, {}},
    {"light_in_wrong_space", {}, lights(other_space), {}},
    {"light_moved_twice", {}, lights(moved_twice), {}},
    {"falloff_of_directional",
     {{"normalize(light.position), 1.0,",
       "normalize(light.position), 1.0 / (light.falloff.x + light.falloff.y * length(light.position) + "
       "light.falloff.z * dot(light.position, light.position)),"}},
     {},
     {}},
    {"cutoff_as_full_angle", {}, lights(half_cutoff), {}},
    {"normals_flipped", {{"gl_NormalMatrix * gl_Normal", "-gl_NormalMatrix * gl_Normal"}}, {}, {}},
    {"no_normals_given", {{"gl_NormalMatrix * gl_Normal", "gl_NormalMatrix * vec3(0, 0, 1)"}}, {}, {}},
    {"interpolated_normals_not_normalized", {{"vec3 n = normalize(normal);", "vec3 n = normal;"}}, {}, {}},
    {"normals_by_model_matrix",
     {{"gl_NormalMatrix * gl_Normal", "mat3(gl_ModelViewMatrix) * gl_Normal"}},
     {},
     {}},
    {"light_by_inverse_view", {}, lights(by_inverse_view), {}},
    {"normals_left_in_object", {{"gl_NormalMatrix * gl_Normal", "gl_Normal"}}, {}, {}},
    {"direction_is_position", {}, lights(direction_is_position), {}},
    {"missing_pi", {{"diffuse * light.diffuse", "diffuse / pi * light.diffuse"}}, {}, {}},
    {"encoded_twice", {}, {}, [](float x) { return srgb(std::clamp(x, 0.0f, 1.0f)); }},
    {"lit_in_srgb", {}, encoded_materials, {}},
    {"flipped_by_view",
     {{"vec3 sum = begun(p, n);", "if (dot(n, v) < 0.0) n = -n;\nvec3 sum = begun(p, n);"}},
     {},
     {}},
    {"flipped_twice", {}, one_sided, {}},
    {"aim_stays_at_origin", {}, lights(aims_at_origin), {}},
    {"cone_cosines_swapped",
     {{"c >= light.cos_cutoff ? raised(c, light.exponent) : 0.0", "c >= light.cos_cutoff ? 0.0 : 1.0"}},
     {},
     {}},
    {"unnormalized_view", {{"local_viewer ? normalize(-p)", "local_viewer ? -p"}}, {}, {}},
    {"view_reversed", {{"vec3 sum = begun(p, n);", "v = -v;\nvec3 sum = begun(p, n);"}}, {}, {}},
    {"perspective_view_in_ortho",
     {{"local_viewer ? normalize(-p)", "true ? normalize(-p)"}},
     only_orthographic,
     {}},
    {"bytes_wrap",
     {},
     {},
     [](float x) {
         const float byte = std::floor(255 * x + 0.5f);
         return (byte - 256 * std::floor(byte / 256)) / 255;
     }},
    {"absolute_cosine", {{"float n_l = dot(n, l);", "float n_l = abs(dot(n, l));"}}, {}, {}},
    {"light_direction_reversed",
     {{"normalize(light.position), 1.0,", "-normalize(light.position), 1.0,"}},
     {},
     {}},
    {"reflect_sign", {{"reflect(-l, n)", "reflect(l, n)"}}, {}, {}},
    {"reflect_of_difference", {{"reflect(-l, n)", "2.0 * dot(n, l) * (n - l)"}}, {}, {}},
    {"last_light_only", {}, last_light_only, {}},
    {"average_of_lights", {}, average, {}},
    {"falloff_inverted",
     {{falloff, "light.falloff.x + light.falloff.y * r + light.falloff.z * r * r"}},
     {},
     {}},
    {"falloff_forgotten", {}, lights(no_falloff), {}},
    {"coefficients_swapped", {}, swapped_coefficients, {}},
    {"shininess_inverted", {{", shininess)", ", shininess == 0.0 ? 0.0 : 1.0 / shininess)"}}, {}, {}},
    {"normals_as_points",
     {{"gl_NormalMatrix * gl_Normal", "(gl_ModelViewMatrix * vec4(gl_Normal, 1)).xyz"}},
     {},
     {}},
};

}  // namespace

std::span<const WrongProgram> wrong_programs() { return table; }

}  // namespace glint::oracle
