// Writes a scene as a .glb file.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

#include "models/gltf/gltf.h"
#include "models/gltf/gltf_document.h"
#include "models/numbers.h"
#include "models/problem.h"

namespace glint {
namespace {

constexpr const char* strength_extension = "KHR_materials_emissive_strength";

class Writer {
  public:
    explicit Writer(const Scene& scene) : scene_(scene) {}

    GltfWritten write(const std::string& name) {
        for (const Object& object : scene_.objects) add(object);
        if (meshes_.empty())
            throw ProblemFound({"", "/objects", "no object is shown", "one with a triangle that is visible"});
        const int camera = add_camera();
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) add_light(i, camera);
        json_["asset"] = {{"version", "2.0"}, {"generator", gltf_generator}};
        json_["scene"] = 0;
        json_["scenes"] = Json::array({{{"name", name}, {"nodes", roots_}}});
        json_["nodes"] = std::move(nodes_);
        json_["meshes"] = std::move(meshes_);
        json_["materials"] = std::move(materials_);
        json_["accessors"] = buffer_.accessors();
        json_["bufferViews"] = buffer_.views();
        json_["buffers"] = Json::array({{{"byteLength", buffer_.bytes().size()}}});
        if (!lights_.empty()) {
            json_["extensionsUsed"].push_back("KHR_lights_punctual");
            json_["extensions"]["KHR_lights_punctual"]["lights"] = lights_;
        }
        if (has_strength_) json_["extensionsUsed"].push_back(strength_extension);
        return {glb_container(json_.dump(-1, ' ', false, Json::error_handler_t::replace), buffer_.bytes()),
                said(unsaid_, scene_)};
    }

  private:
    int add_node(Json node, Json& parent) {
        nodes_.push_back(std::move(node));
        parent.push_back(nodes_.size() - 1);
        return static_cast<int>(nodes_.size()) - 1;
    }

    void add(const Object& object) {
        if (!object.visible) return void(++unsaid_.invisible);
        if (object.mesh->triangles.empty()) return void(++unsaid_.empty);
        const glm::dvec3 turn = glm::radians(glm::dvec3(object.transform.rotate_deg));
        const glm::dquat q = glm::angleAxis(turn.z, glm::dvec3(0, 0, 1)) *
                             glm::angleAxis(turn.y, glm::dvec3(0, 1, 0)) *
                             glm::angleAxis(turn.x, glm::dvec3(1, 0, 0));
        add_node({{"name", object.name},
                  {"mesh", add_mesh(object)},
                  {"translation", numbers_json(object.transform.translate)},
                  {"rotation", {q.x, q.y, q.z, q.w}},
                  {"scale", numbers_json(object.transform.scale)}},
                 roots_);
    }

    /// Objects with the same mesh and material share one glTF mesh, so that a program that opens the file
    /// creates it once. A named and an unnamed object do not share a mesh: a reader would name the unnamed
    /// object after it.
    std::size_t add_mesh(const Object& object) {
        const GltfMeshKey key = mesh_key(object);
        const std::size_t material =
            add(object.material, object.double_sided || scene_.shading.cull != Cull::Back);
        unsaid_.colours += object.mesh->colors.empty() ? 0 : 1;
        const auto [known, is_new] =
            known_meshes_.try_emplace({key, material, object.name.empty()}, meshes_.size());
        if (!is_new) return known->second;
        if (!primitives_.contains(key)) primitives_[key] = buffer_.add(object);
        Json primitive = primitives_[key];
        primitive["material"] = material;
        meshes_.push_back({{"name", object.name}, {"primitives", Json::array({primitive})}});
        return known->second;
    }

    std::size_t add(const Material& m, bool is_double_sided) {
        const bool is_physical = scene_.shading.reflection == Reflection::CookTorrance;
        const std::optional<GltfMetal> metal = is_physical ? metal_of(m) : std::nullopt;
        if (!metal || m.specular != glm::vec3(1)) ++unsaid_.materials;
        const glm::vec3 whole = metal ? metal->base : m.diffuse, base = glm::min(whole, glm::vec3(1));
        // The base colour of a metal is computed, so rounding may raise it slightly above 1. Up to 1e-5 above
        // 1 is tolerated.
        unsaid_.bright += glm::any(glm::greaterThan(whole, glm::vec3(1 + 1e-5f))) ? 1 : 0;
        // A Blinn highlight of that shininess, if the model has no roughness.
        const float roughness = is_physical ? m.roughness : std::pow(2 / (m.shininess + 2), 0.25f);
        Json out{{"pbrMetallicRoughness",
                  {{"baseColorFactor", {number_json(base.x), number_json(base.y), number_json(base.z), 1}},
                   {"metallicFactor", number_json(metal ? std::clamp(metal->metal, 0.0f, 1.0f) : 0)},
                   {"roughnessFactor", number_json(roughness)}}},
                 {"doubleSided", is_double_sided}};
        const float strength = std::max({m.emission.x, m.emission.y, m.emission.z, 1.0f});
        if (m.emission != glm::vec3(0)) out["emissiveFactor"] = numbers_json(m.emission / strength);
        if (strength > 1) {
            out["extensions"][strength_extension]["emissiveStrength"] = number_json(strength);
            has_strength_ = true;
        }
        const auto [known, is_new] = known_materials_.try_emplace(out.dump(), materials_.size());
        if (is_new) materials_.push_back(std::move(out));
        return known->second;
    }

    int add_camera() {
        json_["cameras"] = Json::array({camera_json(scene_.camera.projection, unsaid_)});
        return add_node({{"name", "Camera"}, {"camera", 0}, {"matrix", camera_matrix(scene_.camera)}},
                        roots_);
    }

    void add_light(std::size_t i, int camera) {
        const Light& light = scene_.lights[i];
        if (!light.enabled) return void(++unsaid_.off);
        if (light.kind == LightKind::Area) return void(++unsaid_.areas);
        lights_.push_back(light_json(light, scene_.camera, fmt::format("/lights/{}", i), unsaid_));
        Json node = light_node(light, lights_.size() - 1);
        if (light.space == LightSpace::World) return void(add_node(std::move(node), roots_));
        Json child = Json::array();
        add_node(std::move(node), child);
        nodes_[static_cast<std::size_t>(camera)]["children"].push_back(child[0]);
    }

    const Scene& scene_;
    GltfBuffer buffer_;
    Json json_, nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array(),
                lights_ = Json::array(), roots_ = Json::array();
    std::map<GltfMeshKey, Json> primitives_;
    std::map<std::string, std::size_t> known_materials_;  // by their JSON
    std::map<std::tuple<GltfMeshKey, std::size_t, bool>, std::size_t> known_meshes_;
    GltfUnsaid unsaid_;
    bool has_strength_ = false;
};

}  // namespace

Result<GltfWritten> unchecked_glb_of(const Scene& scene, const std::string& name) {
    std::set<GltfMeshKey> meshes;
    std::uint64_t bytes = 0, text = 0;
    for (const Object& object : scene.objects) {
        if (meshes.insert(mesh_key(object)).second) bytes += 100 * object.mesh->triangles.size();
        text += 1000 + 2 * object.name.size();  // for its node and mesh
    }
    constexpr std::uint64_t most = 4294967295;  // the limit of the header's field
    if (bytes + text > most)
        return Problem{"", "", "the meshes are too large for one .glb file", "less than 4 GiB"};
    return result_of("", [&] { return Writer(scene).write(name); });
}

namespace {

/// The rotation that turns (0, 0, 1) into the unit vector `to`.
glm::dquat turn_from_z(const glm::dvec3& to) {
    if (to.z < -1 + 1e-12) return {0, 1, 0, 0};  // half a turn about x
    return glm::normalize(glm::dquat(1 + to.z, -to.y, to.x, 0));
}

Json planes_json(const Projection& projection) {
    return {{"znear", number_json(near_of(projection))}, {"zfar", number_json(far_of(projection))}};
}

/// The vertical angle in radians, clamped so that it stays above 0 and below pi as a float.
double yfov_of(const Projection& projection, GltfUnsaid& unsaid) {
    double angle = 0;
    if (const auto* f = std::get_if<Frustum>(&projection)) {
        const double height = std::abs(static_cast<double>(f->top) - static_cast<double>(f->bottom));
        angle = 2 * std::atan(height / (2 * static_cast<double>(f->near)));
        unsaid.frustum = true;
        unsaid.mirroring = f->left > f->right || f->bottom > f->top;
    } else {
        angle = glm::radians(static_cast<double>(std::get<Perspective>(projection).fov_y_deg));
    }
    constexpr double least = std::numeric_limits<float>::denorm_min();
    const double most = std::nextafter(std::numbers::pi_v<float>, 0.0f);
    unsaid.angle = angle < least || angle > most;
    return std::clamp(angle, least, most);
}

/// The divisor of a light's colour and the factor of its intensity: colours in glTF are at most 1.
float color_scale(const Light& light) {
    return std::max({light.diffuse.x, light.diffuse.y, light.diffuse.z, 1.0f});
}

/// The intensity that makes a glTF light as bright as this light at the camera's target. A glTF light falls
/// off with the square of the distance.
double intensity_of(const Light& light, const Camera& camera, GltfUnsaid& unsaid) {
    const double i =
        static_cast<double>(light.intensity) * static_cast<double>(color_scale(light)) * std::numbers::pi;
    if (light.kind == LightKind::Directional) return i;
    const auto& f = light.falloff;
    if (f.constant == 0 && f.linear == 0) return i / static_cast<double>(f.quadratic);
    ++unsaid.falloffs;
    const glm::dvec4 place(light.position);
    const glm::dvec3 in_world(light.space == LightSpace::World ? place : world_from_view(camera) * place);
    const double r = std::max(glm::distance(in_world, glm::dvec3(camera.target)), 1e-3);
    return i * r * r /
           (static_cast<double>(f.constant) +
            r * (static_cast<double>(f.linear) + r * static_cast<double>(f.quadratic)));
}

}  // namespace

Json camera_json(const Projection& projection, GltfUnsaid& unsaid) {
    Json lens = planes_json(projection);
    const auto* o = std::get_if<Orthographic>(&projection);
    if (o == nullptr) {
        lens["yfov"] = yfov_of(projection, unsaid);
        return {{"type", "perspective"}, {"perspective", lens}};
    }
    const float half = std::max(o->height / 2, std::numeric_limits<float>::denorm_min());
    lens["xmag"] = number_json(half * 16 / 9);
    lens["ymag"] = number_json(half);
    return {{"type", "orthographic"}, {"orthographic", lens}};
}

Json camera_matrix(const Camera& camera) {
    const glm::dmat4 m = world_from_view(camera);
    Json matrix = Json::array();
    for (int i = 0; i < 12; ++i) matrix.push_back(m[i / 4][i % 4]);
    for (int i = 0; i < 3; ++i) matrix.push_back(number_json(camera.eye[i]));
    matrix.push_back(1);
    return matrix;
}

Json light_json(const Light& light, const Camera& camera, const std::string& pointer, GltfUnsaid& unsaid) {
    // Without a cone a spot shines everywhere, as a point light does.
    const bool is_spot = light.kind == LightKind::Spot && light.spot.cutoff_deg < 180;
    const double intensity = intensity_of(light, camera, unsaid);
    if (!at_least_zero.contains(intensity))
        throw ProblemFound({"", pointer, fmt::format("in glTF's units its intensity is {:.3g}", intensity),
                            "at most 1e7: a light that is dimmer, or nearer to the camera's target"});
    Json out{{"name", light.name},
             {"type", light.kind == LightKind::Directional ? "directional"
                      : is_spot                            ? "spot"
                                                           : "point"},
             {"color", numbers_json(light.diffuse / color_scale(light))},
             {"intensity", intensity}};
    if (is_spot) {
        const GltfCone cone = cone_of(light.spot);
        out["spot"] = {{"innerConeAngle", cone.inner}, {"outerConeAngle", cone.outer}};
        unsaid.cones += light.spot.exponent > 0 ? 1 : 0;
    }
    unsaid.ambients += light.ambient != glm::vec3(0) ? 1 : 0;
    unsaid.speculars += light.specular != light.diffuse ? 1 : 0;
    return out;
}

Json light_node(const Light& light, std::size_t index) {
    const bool is_sun = light.kind == LightKind::Directional;
    const glm::dvec3 back =
        glm::normalize(glm::dvec3(is_sun ? glm::vec3(light.position) : -light.spot.direction));
    const glm::dquat q = turn_from_z(back);
    Json node{{"name", light.name},
              {"rotation", {q.x, q.y, q.z, q.w}},
              {"extensions", {{"KHR_lights_punctual", {{"light", index}}}}}};
    if (!is_sun) node["translation"] = numbers_json(glm::vec3(light.position));
    return node;
}

}  // namespace glint
