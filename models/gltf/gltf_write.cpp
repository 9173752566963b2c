// A scene as a .glb file.
#include <fmt/core.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

#include "models/gltf/gltf.h"
#include "models/gltf/gltf_buffer.h"
#include "models/gltf/gltf_items.h"
#include "models/memory_limit.h"
#include "models/scene_file/scene_file.h"

namespace glint {
namespace {

/// What glTF cannot say, one line a kind.
struct Unsaid {
    std::size_t falloffs = 0, cones = 0, areas = 0, ambients = 0, speculars = 0, materials = 0, empty = 0;
};

/// Turns (0, 0, 1) into the unit vector.
glm::dquat turn_from_z(const glm::dvec3& to) {
    if (to.z < -1 + 1e-12) return {0, 1, 0, 0};  // half a turn about x
    return glm::normalize(glm::dquat(1 + to.z, -to.y, to.x, 0));
}

class Writer {
  public:
    explicit Writer(const Scene& scene) : scene_(scene) {}

    GltfWritten write(const std::string& name) {
        for (const Object& object : scene_.objects)
            if (object.visible) add(object);
        const int camera = add_camera();
        for (const Light& light : scene_.lights)
            if (light.enabled) add(light, camera);
        json_["asset"] = {{"version", "2.0"}, {"generator", gltf_generator}};
        json_["scene"] = 0;
        json_["scenes"] = GltfJson::array({{{"name", name}, {"nodes", roots_}}});
        json_["nodes"] = nodes_;
        if (!meshes_.empty()) {
            json_["meshes"] = meshes_;
            json_["materials"] = materials_;
            json_["accessors"] = buffer_.accessors();
            json_["bufferViews"] = buffer_.views();
            json_["buffers"] = GltfJson::array({{{"byteLength", buffer_.bytes().size()}}});
        }
        if (!lights_.empty()) {
            json_["extensionsUsed"] = {"KHR_lights_punctual"};
            json_["extensions"]["KHR_lights_punctual"]["lights"] = lights_;
        }
        say_unsaid();
        return {glb_container(json_.dump(), buffer_.bytes()), std::move(warnings_)};
    }

  private:
    int add_node(GltfJson node, GltfJson& parent) {
        nodes_.push_back(std::move(node));
        parent.push_back(nodes_.size() - 1);
        return static_cast<int>(nodes_.size()) - 1;
    }

    void add(const Object& object) {
        if (object.mesh->triangles.empty()) return void(++unsaid_.empty);
        using Key = std::tuple<const Mesh*, NormalSource, NormalWeighting, float, bool>;
        const NormalOptions& n = object.normals;
        const Key key{object.mesh.get(), n.source, n.weighting, n.crease_deg, n.flip};
        if (!primitives_.contains(key)) primitives_[key] = buffer_.add(object);
        GltfJson primitive = primitives_[key];
        primitive["material"] = add(object.material);
        meshes_.push_back({{"name", object.name}, {"primitives", GltfJson::array({primitive})}});
        const glm::dvec3 turn = glm::radians(glm::dvec3(object.transform.rotate_deg));
        const glm::dquat q = glm::angleAxis(turn.z, glm::dvec3(0, 0, 1)) *
                             glm::angleAxis(turn.y, glm::dvec3(0, 1, 0)) *
                             glm::angleAxis(turn.x, glm::dvec3(1, 0, 0));
        add_node({{"name", object.name},
                  {"mesh", meshes_.size() - 1},
                  {"translation", numbers_json(object.transform.translate)},
                  {"rotation", {q.x, q.y, q.z, q.w}},
                  {"scale", numbers_json(object.transform.scale)}},
                 roots_);
    }

    int add(const Material& m) {
        const bool is_physical = scene_.shading.reflection == Reflection::CookTorrance;
        const std::optional<GltfMetal> metal = is_physical ? metal_of(m) : std::nullopt;
        if (!metal || m.specular != glm::vec3(1)) ++unsaid_.materials;
        const glm::vec3 base = glm::min(metal ? metal->base : m.diffuse, glm::vec3(1));
        // Blinn's highlight of that shininess, where the model has no roughness.
        const float roughness = is_physical ? m.roughness : std::pow(2 / (m.shininess + 2), 0.25f);
        GltfJson out{
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {number_json(base.x), number_json(base.y), number_json(base.z), 1}},
              {"metallicFactor", number_json(metal ? std::clamp(metal->metal, 0.0f, 1.0f) : 0)},
              {"roughnessFactor", number_json(roughness)}}},
            {"doubleSided", scene_.shading.cull != Cull::Back}};
        if (m.emission != glm::vec3(0))
            out["emissiveFactor"] = numbers_json(glm::min(m.emission, glm::vec3(1)));
        materials_.push_back(out);
        return static_cast<int>(materials_.size()) - 1;
    }

    int add_camera() {
        const Camera& camera = scene_.camera;
        GltfJson out;
        if (const auto* o = std::get_if<Orthographic>(&camera.projection)) {
            const float half = o->height / 2;
            out = {{"type", "orthographic"},
                   {"orthographic",
                    {{"xmag", number_json(half * 16 / 9)},
                     {"ymag", number_json(half)},
                     {"znear", number_json(o->near)},
                     {"zfar", number_json(o->far)}}}};
        } else {
            const auto* f = std::get_if<Frustum>(&camera.projection);
            const double fov =
                f != nullptr
                    ? 2 * std::atan(std::abs(static_cast<double>(f->top - f->bottom)) /
                                    (2 * static_cast<double>(f->near)))
                    : glm::radians(static_cast<double>(std::get<Perspective>(camera.projection).fov_y_deg));
            if (f != nullptr)
                warnings_.push_back("the frustum is written as a view whose middle is straight ahead");
            out = {{"type", "perspective"},
                   {"perspective",
                    {{"yfov", fov},
                     {"znear", number_json(near_of(camera.projection))},
                     {"zfar", number_json(far_of(camera.projection))}}}};
        }
        json_["cameras"] = GltfJson::array({out});
        const glm::dmat4 m = world_from_view(camera);
        GltfJson matrix = GltfJson::array();
        for (int i = 0; i < 16; ++i) matrix.push_back(m[i / 4][i % 4]);
        return add_node({{"name", "Camera"}, {"camera", 0}, {"matrix", matrix}}, roots_);
    }

    void add(const Light& light, int camera) {
        if (light.kind == LightKind::Area) return void(++unsaid_.areas);
        const glm::vec3 place(light.position);
        const bool is_sun = light.kind == LightKind::Directional;
        const glm::dvec3 back = glm::normalize(glm::dvec3(is_sun ? place : -light.spot.direction));
        GltfJson out{{"name", light.name},
                     {"type", is_sun                          ? "directional"
                              : light.kind == LightKind::Spot ? "spot"
                                                              : "point"},
                     {"color", numbers_json(glm::min(light.diffuse, glm::vec3(1)))},
                     {"intensity", intensity_of(light)}};
        if (light.kind == LightKind::Spot) {
            const GltfCone cone = cone_of(light.spot);
            out["spot"] = {{"innerConeAngle", cone.inner}, {"outerConeAngle", cone.outer}};
            unsaid_.cones += cone.is_alike ? 0 : 1;
        }
        unsaid_.ambients += light.ambient != glm::vec3(0) ? 1 : 0;
        unsaid_.speculars += light.specular != light.diffuse ? 1 : 0;
        lights_.push_back(out);
        const glm::dquat q = turn_from_z(back);
        GltfJson node{{"name", light.name},
                      {"rotation", {q.x, q.y, q.z, q.w}},
                      {"extensions", {{"KHR_lights_punctual", {{"light", lights_.size() - 1}}}}}};
        if (!is_sun) node["translation"] = numbers_json(place);
        GltfJson children = GltfJson::array();
        if (light.space == LightSpace::World) return void(add_node(node, roots_));
        add_node(node, children);
        for (const GltfJson& child : children)
            nodes_[static_cast<std::size_t>(camera)]["children"].push_back(child);
    }
    /// The intensity with which glTF's light, which falls off with the square, is as bright at the camera's
    /// target as this light.
    double intensity_of(const Light& light) {
        const double most = std::max({light.diffuse.x, light.diffuse.y, light.diffuse.z, 1.0f});
        const double i = static_cast<double>(light.intensity) * most * std::numbers::pi;
        if (light.kind == LightKind::Directional) return i;
        const auto& f = light.falloff;
        if (f.constant == 0 && f.linear == 0) return i / static_cast<double>(f.quadratic);
        ++unsaid_.falloffs;
        const glm::dvec4 place(light.position);
        const glm::dvec3 in_world(light.space == LightSpace::World ? place
                                                                   : world_from_view(scene_.camera) * place);
        const double r = std::max(glm::distance(in_world, glm::dvec3(scene_.camera.target)), 1e-3);
        return i * r * r /
               (static_cast<double>(f.constant) +
                r * (static_cast<double>(f.linear) + r * static_cast<double>(f.quadratic)));
    }

    void say_unsaid() {
        Warnings& w = warnings_;
        if (scene_.shading.reflection != Reflection::CookTorrance)
            w.push_back(
                "the reflection model is written as metal and roughness (cook-torrance), the nearest that "
                "glTF has");
        else
            warn(w, unsaid_.materials, "material has colours that no metal has: its diffuse colour is kept",
                 "materials have colours that no metal has: their diffuse colours are kept");
        if (scene_.display.transfer != Transfer::Srgb)
            w.push_back("glTF's pictures are encoded (sRGB): they are brighter than this scene's");
        if (scene_.global_ambient != glm::vec3(0))
            w.push_back("the ambient light is left out, which glTF does not have");
        warn(w, unsaid_.falloffs,
             "light falls off otherwise than with the square of the distance: it is as bright at the "
             "camera's target",
             "lights fall off otherwise than with the square of the distance: they are as bright at the "
             "camera's target");
        warn(w, unsaid_.cones,
             "spot has an exponent that no cone of glTF has, and becomes even up to its edge",
             "spots have exponents that no cone of glTF has, and become even up to their edges");
        warn(w, unsaid_.areas, "area light is left out", "area lights are left out");
        warn(w, unsaid_.ambients, "light has an ambient colour, which is left out",
             "lights have ambient colours, which are left out");
        warn(w, unsaid_.speculars, "light has highlights of another colour, which is left out",
             "lights have highlights of other colours, which are left out");
        warn(w, unsaid_.empty, "object without a triangle is left out",
             "objects without a triangle are left out");
    }

    const Scene& scene_;
    GltfBuffer buffer_;
    GltfJson json_, nodes_ = GltfJson::array(), meshes_ = GltfJson::array(), materials_ = GltfJson::array(),
                    lights_ = GltfJson::array(), roots_ = GltfJson::array();
    std::map<std::tuple<const Mesh*, NormalSource, NormalWeighting, float, bool>, GltfJson> primitives_;
    Unsaid unsaid_;
    Warnings warnings_;
};

}  // namespace

Result<GltfWritten> glb_of(const Scene& scene, const std::string& name) {
    std::uint64_t bytes = 0;
    for (const Object& object : scene.objects) bytes += 100 * object.mesh->triangles.size();
    constexpr std::uint64_t most = 4294967295;  // what the header can say
    if (bytes > most) return Problem{"", "", "the meshes are too large for one .glb file", "less than 4 GiB"};
    try {
        const MemoryShare share(memory_need(MemoryUse::Output, 2 * bytes));
        return Writer(scene).write(name);
    } catch (const Refused& refused) {
        return memory_problem(refused);
    } catch (const std::bad_alloc&) {
        return Problem{"", "", "the file does not fit in memory", "fewer triangles"};
    } catch (const nlohmann::json::exception&) {
        return Problem{"", "", "a name in the scene is not UTF-8", "names in UTF-8"};
    }
}

}  // namespace glint
