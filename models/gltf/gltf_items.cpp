// Converts one glTF material, camera, light or transform to ours.

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <vector>

#include "models/fields/scene_fields.h"
#include "models/gltf/gltf_document.h"
#include "models/json/json.h"
#include "models/mesh/normals.h"
#include "models/scene/scene.h"

namespace glint {
namespace {

constexpr double sheared_from = 1e-4;  // the cosine of the angle between two axes
constexpr double half_way = 0.25;      // glTF's brightness halfway between the cosines of its two cones
constexpr float sharp_below = 0.001f;  // radians between the two cone angles
constexpr float least_near = 1e-3f;    // for a camera whose near plane is at the eye

template <class P> void read_planes(const Node& node, P& p) {
    read(node, "znear", p.near, at_least_zero);
    p.far = std::max(p.near, least_near) * 1e5f;  // infinite unless "zfar" is given
    read(node, "zfar", p.far, above_zero);
    if (p.near == 0) p.near = std::min(least_near, p.far / 2);
    if (!(p.far > p.near)) node.fail("zfar is not above znear", "a zfar above znear");
}

/// Reads a cone. Sets `is_bad` if its angles were clamped.
void read_cone(const Node& node, SpotCone& cone, bool& is_bad) {
    constexpr auto widest = static_cast<float>(std::numbers::pi / 2);
    float inner = 0, outer = static_cast<float>(std::numbers::pi / 4);
    with_object(node, "spot", [&](const Node& spot) {
        read(spot, "innerConeAngle", inner, at_least_zero);
        read(spot, "outerConeAngle", outer, at_least_zero);
    });
    is_bad = inner > outer || outer > widest + 1e-6f;
    outer = std::min(outer, widest);
    cone.exponent = 0;
    cone.cutoff_deg = std::min(glm::degrees(outer), 90.0f);
    cone.inner_deg = outer - inner < sharp_below ? SpotCone{}.inner_deg : glm::degrees(inner);
}

/// Extensions that change the appearance of a material and are not read.
constexpr std::array<std::string_view, 10> effects_left_out{
    "KHR_materials_anisotropy",    "KHR_materials_clearcoat",    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",    "KHR_materials_iridescence",  "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",         "KHR_materials_transmission", "KHR_materials_volume",
    "KHR_materials_volume_scatter"};

/// Reflectance of the non-metallic part of a material, at normal incidence and at grazing angles.
struct Reflectance {
    glm::vec3 f0{usual_f0};
    float f90 = 1;
};

Reflectance reflectance_of(const Node& extensions, bool& has_textures) {
    float ior = 1.5f;
    glm::vec3 colour(1);
    Reflectance r;
    with_object(extensions, "KHR_materials_ior",
                [&](const Node& at) { read(at, "ior", ior, at_least_zero); });
    with_object(extensions, "KHR_materials_specular", [&](const Node& at) {
        read(at, "specularFactor", r.f90, zero_to_one);
        read(at, "specularColorFactor", colour, at_least_zero);
        has_textures = has_textures || at.has("specularTexture") || at.has("specularColorTexture");
    });
    const float root = (ior - 1) / (ior + 1);
    r.f0 = r.f90 * glm::min(root * root * colour, glm::vec3(1));
    return r;
}

Material material_from(const glm::vec3& base, float metal, float roughness, const Reflectance& not_metal) {
    Material m;
    m.ambient = base;
    // Light that the surface reflects does not reach the diffuse layer below it (fresnel_mix in glTF's
    // appendix B, here at normal incidence).
    m.diffuse = (1 - metal) * base * (1.0f - not_metal.f0);
    // Glint's f90 is 1, so the highlight is scaled instead.
    const float f90 = glm::mix(not_metal.f90, 1.0f, metal);
    m.f0 = f90 > 0 ? glm::mix(not_metal.f0, base, metal) / f90 : glm::vec3(0);
    m.specular = glm::vec3(f90);
    m.roughness = roughness;
    const float a = std::max(roughness * roughness, 0.03f);
    m.shininess = std::clamp(2 / (a * a) - 2, 1.0f, 2000.0f);  // a Blinn highlight of the same width
    return m;
}

}  // namespace

bool is_flat(const glm::dmat4& m) {
    for (int i = 0; i < 3; ++i)
        if (static_cast<float>(glm::length(glm::dvec3(m[i]))) == 0) return true;
    return false;
}

std::optional<Transform> transform_of(const glm::dmat4& m, bool& sheared) {
    if (is_flat(m)) return {};
    glm::dvec3 axis[3] = {glm::dvec3(m[0]), glm::dvec3(m[1]), glm::dvec3(m[2])};
    glm::dvec3 scale(glm::length(axis[0]), glm::length(axis[1]), glm::length(axis[2]));
    for (int i = 0; i < 3; ++i) {
        if (!any_number.contains(static_cast<float>(scale[i])) ||
            !any_number.contains(static_cast<float>(m[3][i])))
            return {};
        axis[i] /= scale[i];
    }
    if (glm::dot(glm::cross(axis[0], axis[1]), axis[2]) < 0) {
        scale.x = -scale.x;
        axis[0] = -axis[0];
    }
    for (int i = 0; i < 3; ++i)
        sheared = sheared || std::abs(glm::dot(axis[i], axis[(i + 1) % 3])) > sheared_from;
    // Rz Ry Rx: its third row is (-sin y, cos y sin x, cos y cos x), its first column cos y (cos z, sin z,
    // ...).
    const double sine = std::clamp(-axis[0].z, -1.0, 1.0);
    glm::dvec3 turn(std::atan2(axis[1].z, axis[2].z), std::asin(sine), std::atan2(axis[0].y, axis[0].x));
    if (std::abs(sine) > 1 - 1e-12) turn = {std::atan2(-axis[2].y, axis[1].y), turn.y, 0};
    Transform t;
    t.translate = glm::vec3(m[3]);
    t.rotate_deg = glm::vec3(glm::degrees(turn));
    t.scale = glm::vec3(scale);
    return t;
}

GltfCone cone_of(const SpotCone& cone) {
    const auto angle = [](float deg) {
        return std::min(glm::radians(static_cast<double>(deg)), std::numbers::pi / 2);
    };
    const double outer = angle(cone.cutoff_deg);
    GltfCone out{std::max(outer - 1e-4, 0.0), outer};
    if (cone.inner_deg < cone.cutoff_deg) {
        out.inner = angle(cone.inner_deg);
    } else if (cone.exponent > 0) {
        const double middle = std::pow(half_way, 1 / static_cast<double>(cone.exponent));
        const double inner = std::acos(std::clamp(2 * middle - std::cos(outer), -1.0, 1.0));
        if (outer - inner >= sharp_below) out.inner = inner;
    }
    return out;
}

GltfMaterial material_of(const Node& node) {
    require_object(node);
    glm::vec3 base(1), emission(0);
    float metal = 1, roughness = 1, strength = 1;
    bool textured = node.has("normalTexture") || node.has("occlusionTexture") || node.has("emissiveTexture");
    with_object(node, "pbrMetallicRoughness", [&](const Node& pbr) {
        pbr.with("baseColorFactor", [&](const Node& at) {
            const std::vector<double> c = numbers(at, 4, 4, at_least_zero);
            base = glm::vec3(c[0], c[1], c[2]);
        });
        read(pbr, "metallicFactor", metal, zero_to_one);
        read(pbr, "roughnessFactor", roughness, zero_to_one);
        textured = textured || pbr.has("baseColorTexture") || pbr.has("metallicRoughnessTexture");
    });
    read(node, "emissiveFactor", emission, at_least_zero);
    Reflectance not_metal;
    std::vector<std::string_view> effects;
    with_object(node, "extensions", [&](const Node& extensions) {
        not_metal = reflectance_of(extensions, textured);
        for (const std::string_view name : effects_left_out)
            if (extensions.has(name)) effects.push_back(name);
        with_object(extensions, "KHR_materials_emissive_strength",
                    [&](const Node& at) { read(at, "emissiveStrength", strength, at_least_zero); });
    });
    bool is_see_through = false;
    node.with("alphaMode", [&](const Node& at) {
        const std::string& mode = text(at);
        is_see_through = mode == "BLEND" || mode == "MASK";
        if (!is_see_through && mode != "OPAQUE")
            at.fail(in_quotes(mode) + " is not known", "\"OPAQUE\", \"MASK\" or \"BLEND\"");
    });
    bool both_sides = false;
    read(node, "doubleSided", both_sides);
    Material m = material_from(base, metal, roughness, not_metal);
    // The factor multiplies the texture, which is mostly black.
    const bool lacks_emission = node.has("emissiveTexture") && emission != glm::vec3(0);
    m.emission = lacks_emission ? glm::vec3(0) : strength * emission;
    if (has_extension(node, "KHR_materials_unlit")) {
        m.ambient = m.diffuse = m.specular = m.f0 = glm::vec3(0);
        m.emission = base;
    }
    return {m, textured, is_see_through, both_sides, lacks_emission, std::move(effects)};
}

GltfCamera camera_from(const Node& node, const Node& at, const glm::dmat4& world) {
    Camera camera;
    require_object(at);
    std::string type;
    read(at, "type", type);
    if (type != "perspective" && type != "orthographic")
        at.fail(fmt::format("its type is {}", in_quotes(type)), "\"perspective\" or \"orthographic\"");
    if (!at.has(type))
        at.fail(fmt::format("the key {} is missing", in_quotes(type)), "the numbers of its lens");
    if (type == "orthographic") {
        Orthographic o;
        with_object(at, "orthographic", [&](const Node& p) {
            read(p, "ymag", o.height, above_zero);
            o.height *= 2;
            read_planes(p, o);
        });
        camera.projection = o;
    } else {
        Perspective v;
        with_object(at, "perspective", [&](const Node& p) {
            float fov = glm::radians(v.fov_y_deg);
            read(p, "yfov", fov, {0, std::numbers::pi, "more than 0, less than pi", true, true});
            v.fov_y_deg = std::min(glm::degrees(fov), std::nextafter(180.0f, 0.0f));
            read_planes(p, v);
        });
        camera.projection = v;
    }
    camera.eye = glm::vec3(world[3]);
    const glm::dvec3 up = unit_or_zero(glm::dvec3(world[1])), back = unit_or_zero(glm::dvec3(world[2]));
    camera.up = glm::vec3(up);
    camera.target = target_of(camera.eye, -back, 1);
    std::optional<Problem> wrong = violation_of(camera);
    if (violation_of_ranges(camera)) wrong = Problem{"", "", "its position is beyond 1e7", ""};
    if (wrong)
        node.fail("no camera can be placed there: " + wrong->what,
                  "axes of non-zero length, at a position within 1e7");
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    const glm::dmat3 world_from_view(right, glm::cross(back, right), back);
    // View coordinates and the node's coordinates both start at the eye, so the eye's distance from the
    // origin cancels out.
    return {camera, -back, glm::dmat4(glm::transpose(world_from_view) * glm::dmat3(world))};
}

glm::vec3 target_of(const glm::vec3& eye, const glm::dvec3& ahead, double distance) {
    const glm::dvec3 from(eye), size(glm::abs(from));
    const double clear = 1e-4 * std::max({size.x, size.y, size.z});
    return glm::vec3(from + std::max(distance, clear) * ahead);
}

Light light_from(const Node& node, const std::string& name, const glm::dmat4& placed, LightSpace space,
                 bool& has_bad_cone) {
    Light light;
    read_name(node, light.name);
    if (!name.empty()) light.name = name;
    std::string type;
    read(node, "type", type);
    glm::vec3 colour(1);
    float intensity = 1;
    read(node, "color", colour, at_least_zero);
    // In candela or lux; darken_lights() scales down bright lights.
    read(node, "intensity", intensity, {0, 1e30, "0 to 1e30"});
    light.diffuse = light.specular = colour;
    // In Glint, Lambert's term is not divided by pi.
    light.intensity = static_cast<float>(static_cast<double>(intensity) / std::numbers::pi);
    light.space = space;
    const glm::vec3 back(unit_or_zero(glm::dvec3(placed[2])));  // it shines along -z
    light.position = {glm::vec3(placed[3]), 1};
    if (back == glm::vec3(0) && type != "point")
        node.fail("its node's scale leaves it without a direction",
                  "a node whose axes have non-zero lengths");
    if (type == "spot") light.spot.direction = -back;
    light.falloff = {0, 0, 1};
    if (type == "directional") {
        light.kind = LightKind::Directional;
        light.position = {back, 0};
        light.falloff = {};
    } else if (type == "spot") {
        light.kind = LightKind::Spot;
        read_cone(node, light.spot, has_bad_cone);
    } else if (type != "point") {
        node.fail(fmt::format("its type is {}", in_quotes(type)), "\"directional\", \"point\" or \"spot\"");
    }
    return light;
}

std::size_t count_of(const Node& root, std::string_view list) {
    const Json& all = root.value();
    return all.contains(list) && all[list].is_array() ? all[list].size() : 0;
}

std::uint64_t node_number(const Node& at) {
    const double x = at.value().is_number() ? at.value().get<double>() : -1;
    if (!(x >= 0 && x <= 4294967295.0) || x != std::floor(x))
        at.fail("it is not the index of a node", "a whole number");
    return static_cast<std::uint64_t>(x);
}

void read_name(const Node& named, std::string& to) { read(named, "name", to, max_name_characters); }

glm::dmat4 local_of(const Node& node) {
    glm::dmat4 m(1);
    if (node.has("matrix")) {
        node.with("matrix", [&](const Node& at) {
            const std::vector<double> all = numbers(at, 16, 16);
            for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = all[static_cast<std::size_t>(i)];
            if (glm::row(m, 3) != glm::dvec4(0, 0, 0, 1))
                at.fail(fmt::format("its bottom row is {} {} {} {}", m[0][3], m[1][3], m[2][3], m[3][3]),
                        "0 0 0 1");
        });
        for (const char* other : {"translation", "rotation", "scale"})
            if (node.has(other)) node.fail(fmt::format("it has a matrix and a {}", other), "a matrix alone");
        return m;
    }
    node.with("scale", [&](const Node& at) {
        const std::vector<double> s = numbers(at, 3, 3);
        for (int i = 0; i < 3; ++i) m[i] *= s[static_cast<std::size_t>(i)];
    });
    node.with("rotation", [&](const Node& at) {
        const std::vector<double> q = numbers(at, 4, 4);
        const glm::dquat turn(q[3], q[0], q[1], q[2]);
        if (!(glm::dot(turn, turn) > 0)) at.fail("the quaternion is zero", "a quaternion of length 1");
        m = glm::mat4_cast(glm::normalize(turn)) * m;
    });
    node.with("translation", [&](const Node& at) {
        const std::vector<double> t = numbers(at, 3, 3);
        m[3] = glm::dvec4(t[0], t[1], t[2], 1);
    });
    return m;
}

void check_nodes(const Node& root) {
    const auto nothing = [](const Node&) {};
    root.with("nodes", [&](const Node& nodes) {
        nodes.each(max_json_values, "nodes", [&](const Node& node) {
            require_object(node);
            (void)local_of(node);
            if (node.has("mesh")) follow(root, node, "mesh", "meshes", nothing);
            if (node.has("camera")) follow(root, node, "camera", "cameras", nothing);
            with_light(root, node, nothing);
            node.with("children", [&](const Node& children) {
                children.each(max_json_values, "numbers of nodes", [&](const Node& at) {
                    const std::uint64_t i = node_number(at);
                    if (i >= nodes.value().size())
                        at.fail(fmt::format("node {} does not exist", i),
                                fmt::format("0 to {}", nodes.value().size() - 1));
                });
            });
        });
    });
}

}  // namespace glint
