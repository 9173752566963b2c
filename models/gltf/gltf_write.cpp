// Writes a scene as a .glb file.
#include <fmt/core.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "models/gltf/gltf.h"
#include "models/gltf/gltf_buffer.h"
#include "models/gltf/gltf_items.h"
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

}  // namespace glint
