// Writes a scene as a .glb file.

#include <fmt/core.h>

#include <algorithm>
#include <bit>
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
#include "models/mesh/normals.h"
#include "models/numbers.h"
#include "models/problem.h"

namespace glint {
namespace {

/// Features of a scene that glTF cannot express.
struct GltfUnsaid {
    bool frustum = false, mirroring = false, angle = false;  // camera
    std::size_t invisible = 0, empty = 0, colours = 0;       // objects
    std::size_t materials = 0, models = 0, bright = 0;       // models: other than cook-torrance
    std::size_t off = 0, areas = 0, falloffs = 0, cones = 0, ambients = 0, speculars = 0;  // lights
};

void say_camera(const GltfUnsaid& unsaid, Warnings& w) {
    if (unsaid.frustum) w.emplace_back("the frustum is written as a view centred straight ahead");
    if (unsaid.mirroring)
        w.emplace_back(
            "the frustum mirrors the picture (left > right, or bottom > top): the mirroring is left out");
    if (unsaid.angle)
        w.emplace_back(
            "the angle of view is beyond what glTF can express: the nearest possible one is written");
}

void say_whole(const GltfUnsaid& unsaid, const Scene& scene, Warnings& w) {
    if (unsaid.models > 0)
        w.emplace_back(
            "the reflection model is written as metal and roughness (cook-torrance), the nearest that "
            "glTF has");
    if (scene.display.transfer != Transfer::Srgb)
        w.emplace_back("glTF's pictures are encoded (sRGB): they are brighter than this scene's");
    if (scene.global_ambient != glm::vec3(0))
        w.emplace_back("the ambient light is left out, because glTF has none");
    if (scene.transport != Transport{})
        w.emplace_back("/transport is left out, because glTF has no such settings");
}

/// Settings other than the model that affect how faces are drawn and lit, and that glTF cannot express.
void say_shading(const Scene& scene, Warnings& w) {
    const Shading &now = scene.shading, read;
    std::string names;
    const auto add = [&names](bool differs, const char* name) {
        if (differs) names += std::string(names.empty() ? "" : ", ") + name;
    };
    add(now.mode != read.mode, "mode");
    add(now.interpolation != read.interpolation, "interpolation");
    add(now.local_viewer != read.local_viewer, "local_viewer");
    add(now.cull != read.cull, "cull");
    add(now.terms != read.terms, "terms");
    add(now.power_table != read.power_table, "power_table");
    add(now.mistakes != read.mistakes, "mistakes");
    if (!names.empty())
        w.push_back("glTF cannot express these settings in /shading, which are left out: " + names);
    if (scene.npr.cool_to_warm || scene.npr.silhouettes || scene.npr.creases)
        w.emplace_back("cool-to-warm shading and strokes are left out, because glTF has neither");
}

void say_lights(const GltfUnsaid& unsaid, Warnings& w) {
    warn(w, unsaid.off, "light that is off is left out", "lights that are off are left out");
    warn(w, unsaid.areas, "area light is left out", "area lights are left out");
    warn(w, unsaid.falloffs,
         "light does not fall off with the square of the distance: it is as bright as here only at the "
         "camera's target",
         "lights do not fall off with the square of the distance: they are as bright as here only at the "
         "camera's target");
    warn(w, unsaid.cones, "spot has an exponent, which glTF does not have: a soft edge is written instead",
         "spots have exponents, which glTF does not have: soft edges are written instead");
    warn(w, unsaid.ambients, "light has an ambient colour, which is left out",
         "lights have ambient colours, which are left out");
    warn(w, unsaid.speculars, "light has a different colour for highlights, which is left out",
         "lights have different colours for highlights, which are left out");
}

/// Returns one warning, with its count, for each kind, and one for each lost feature of the scene itself.
Warnings said(const GltfUnsaid& unsaid, const Scene& scene) {
    Warnings w;
    say_camera(unsaid, w);
    say_whole(unsaid, scene, w);
    say_shading(scene, w);
    warn(w, unsaid.materials, "material has colours that no metal has: its diffuse colour is kept",
         "materials have colours that no metal has: their diffuse colours are kept");
    warn(w, unsaid.bright, "material reflects more light than it receives: its colour is clamped to 1",
         "materials reflect more light than they receive: their colours are clamped to 1");
    say_lights(unsaid, w);
    warn(w, unsaid.invisible, "invisible object is left out", "invisible objects are left out");
    warn(w, unsaid.colours, "mesh has vertex colours, which are left out",
         "meshes have vertex colours, which are left out");
    warn(w, unsaid.empty, "object without a triangle is left out", "objects without a triangle are left out");
    return w;
}

// OpenGL's constants.
constexpr int vertex_data = 34962, index_data = 34963;

void append(std::string& bytes, std::uint32_t bits) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xFF);
}

Json numbers_json(const glm::vec3& v) {
    return Json::array({number_json(v.x), number_json(v.y), number_json(v.z)});
}

/// Identifies the stored data of an object's mesh: objects with equal keys share it.
using GltfMeshKey = std::pair<NormalsKey, bool>;  // the bool is NormalOptions::flip
GltfMeshKey mesh_key(const Object& object) { return {normals_key(object), object.normals.flip}; }

/// Collects the data of meshes, with the buffer views and accessors that locate it.
class GltfBuffer {
  public:
    /// Adds the object's mesh with the normals used to draw it (`flip` reverses them). Returns the accessors
    /// as the members "attributes" and "indices" of a primitive. Precondition: the object's mesh is loaded.
    [[nodiscard]] Json add(const Object& object) {
        const Mesh& mesh = *object.mesh;
        const CornerNormals normals = corner_normals(mesh, object.normals);
        // A vertex is a position with a normal.
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
        std::vector<glm::vec3> places, directions;
        std::vector<std::uint32_t> indices;
        indices.reserve(3 * mesh.triangles.size());
        for (const Triangle& triangle : mesh.triangles)
            for (const std::uint32_t corner : triangle.corner) {
                const std::uint32_t position = mesh.corner_position[corner];
                const std::uint32_t normal = normals.corner.empty() ? position : normals.corner[corner];
                const auto [at, is_new] = known.emplace(std::pair(position, normal), places.size());
                if (is_new) {
                    places.push_back(mesh.positions[position]);
                    directions.push_back((object.normals.flip ? -1.0f : 1.0f) * normals.normals[normal]);
                }
                indices.push_back(at->second);
            }
        const int place = add_vectors(places, true), direction = add_vectors(directions, false);
        return {{"attributes", {{"POSITION", place}, {"NORMAL", direction}}},
                {"indices", add_indices(indices)}};
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] const Json& views() const { return views_; }
    [[nodiscard]] const Json& accessors() const { return accessors_; }

  private:
    int add_view(std::size_t begin, int target) {
        views_.push_back({{"buffer", 0},
                          {"byteOffset", begin},
                          {"byteLength", bytes_.size() - begin},
                          {"target", target}});
        return static_cast<int>(views_.size()) - 1;
    }

    int add_vectors(const std::vector<glm::vec3>& vectors, bool with_bounds) {
        const std::size_t begin = bytes_.size();
        glm::vec3 low(vectors.front()), high(low);
        for (const glm::vec3& v : vectors) {
            for (int i = 0; i < 3; ++i) append(bytes_, std::bit_cast<std::uint32_t>(v[i]));
            low = glm::min(low, v);
            high = glm::max(high, v);
        }
        Json accessor{{"bufferView", add_view(begin, vertex_data)},
                      {"componentType", gltf_floats},
                      {"count", vectors.size()},
                      {"type", "VEC3"}};
        if (with_bounds) {
            accessor["min"] = numbers_json(low);
            accessor["max"] = numbers_json(high);
        }
        accessors_.push_back(accessor);
        return static_cast<int>(accessors_.size()) - 1;
    }

    int add_indices(const std::vector<std::uint32_t>& indices) {
        const std::size_t begin = bytes_.size();
        for (const std::uint32_t i : indices) append(bytes_, i);
        accessors_.push_back({{"bufferView", add_view(begin, index_data)},
                              {"componentType", gltf_unsigned_int},
                              {"count", indices.size()},
                              {"type", "SCALAR"}});
        return static_cast<int>(accessors_.size()) - 1;
    }

    std::string bytes_;
    Json views_ = Json::array(), accessors_ = Json::array();
};

/// The inverse of reading a material: the base colour and the metalness that give the material's diffuse
/// colour and f0; nullopt if no such pair exists.
struct GltfMetal {
    glm::vec3 base;
    float metal;  // 0 to 1
};
std::optional<GltfMetal> metal_of(const Material& m) {
    constexpr float close = 2e-3f;
    const auto fits = [&](const GltfMetal& tried) {
        const glm::vec3 diffuse = (1 - tried.metal) * not_reflected * tried.base;
        const glm::vec3 f0 = glm::vec3(usual_f0 * (1 - tried.metal)) + tried.metal * tried.base;
        const glm::vec3 off = glm::max(glm::abs(diffuse - m.diffuse), glm::abs(f0 - m.f0));
        return std::max({off.x, off.y, off.z}) < close;
    };
    // diffuse/0.96 + f0 = base + 0.04 (1 - metal). With base = diffuse/0.96/(1 - metal), the sum of the
    // channels gives a quadratic equation in 1 - metal.
    const glm::vec3 below = m.diffuse / not_reflected;
    const double d = below.x + below.y + below.z, f = m.f0.x + m.f0.y + m.f0.z;
    const double half = (d + f) / 0.24;  // 0.12 k^2 - (d + f) k + d = 0, k = 1 - metal
    const double root = half * half - d / 0.12;
    for (const double k :
         {half - std::sqrt(std::max(root, 0.0)), 1.0, 0.0, half + std::sqrt(std::max(root, 0.0))}) {
        if (!(k >= -1e-6 && k <= 1 + 1e-6)) continue;
        const auto share = static_cast<float>(std::clamp(k, 0.0, 1.0));
        const GltfMetal tried{share < 1e-4f ? m.f0 : below / share, share < 1e-4f ? 1 : 1 - share};
        if (fits(tried)) return tried;
    }
    return {};
}

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

/// The divisor of a light's colour and the multiplier of its intensity: colours in glTF are at most 1.
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

/// An element of "cameras".
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

/// The members that place a node at the camera.
Json camera_matrix(const Camera& camera) {
    const glm::dmat4 m = world_from_view(camera);
    Json matrix = Json::array();
    for (int i = 0; i < 12; ++i) matrix.push_back(m[i / 4][i % 4]);
    for (int i = 0; i < 3; ++i) matrix.push_back(number_json(camera.eye[i]));
    matrix.push_back(1);
    return matrix;
}

/// An element of "lights". Precondition: it is not an area light. Throws ProblemFound with `pointer` (the
/// light's pointer) if its intensity exceeds the reader's limit.
Json light_json(const Light& light, const Camera& camera, const std::string& pointer, GltfUnsaid& unsaid) {
    // Without a cone, a spot shines in all directions, as a point light does.
    const bool is_spot = light.kind == LightKind::Spot && light.spot.cutoff_deg < 180;
    const double intensity = intensity_of(light, camera, unsaid);
    if (!at_least_zero.contains(intensity))
        throw ProblemFound({"", pointer, fmt::format("in glTF's units its intensity is {:.3g}", intensity),
                            "at most 1e7, for a dimmer light or one nearer to the camera's target"});
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

/// The node of light number `index`, in the light's space.
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

constexpr const char* strength_extension = "KHR_materials_emissive_strength";

class Writer {
  public:
    explicit Writer(const Scene& scene) : scene_(scene) {}

    GltfWritten write(const std::string& name) {
        for (const Object& object : scene_.objects) add(object);
        if (meshes_.empty())
            throw ProblemFound({"", "/objects", "no object is shown", "a visible one that has a triangle"});
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

    /// Objects with the same mesh and material share one glTF mesh, so a program that opens the file creates
    /// it only once. A named and an unnamed object do not share a mesh: a reader would name the unnamed
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
        const bool is_physical = reflection_of(m, scene_.shading.reflection) == Reflection::CookTorrance;
        unsaid_.models += is_physical ? 0 : 1;
        const std::optional<GltfMetal> metal = is_physical ? metal_of(m) : std::nullopt;
        if (is_physical && (!metal || m.specular != glm::vec3(1))) ++unsaid_.materials;
        const glm::vec3 whole = metal ? metal->base : m.diffuse,
                        base = glm::min(metal ? whole : whole / not_reflected, glm::vec3(1));
        // The base colour of a metal is computed, so rounding may raise it slightly above 1. Up to 1e-5 above
        // 1 is tolerated.
        unsaid_.bright += glm::any(glm::greaterThan(whole, glm::vec3(1 + 1e-5f))) ? 1 : 0;
        // If the model has no roughness, uses that of a Blinn highlight with the material's shininess.
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
    std::map<std::string, std::size_t> known_materials_;  // keyed by their JSON
    std::map<std::tuple<GltfMeshKey, std::size_t, bool>, std::size_t> known_meshes_;
    GltfUnsaid unsaid_;
    bool has_strength_ = false;
};

}  // namespace

std::string glb_container(std::string_view json, std::string_view bin) {
    const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
    const std::size_t length = 12 + 8 + padded(json.size()) + (bin.empty() ? 0 : 8 + padded(bin.size()));
    std::string out;
    out.reserve(length);
    const auto number = [&out](std::size_t n) { append(out, static_cast<std::uint32_t>(n)); };
    const auto chunk = [&](std::string_view type, std::string_view content, char filler) {
        number(padded(content.size()));
        out += type;
        out += content;
        out.append(padded(content.size()) - content.size(), filler);
    };
    out += "glTF";
    number(2);
    number(length);
    chunk("JSON", json, ' ');
    if (!bin.empty()) chunk({"BIN\0", 4}, bin, '\0');
    return out;
}

Result<GltfWritten> unchecked_glb_of(const Scene& scene, const std::string& name) {
    std::set<GltfMeshKey> meshes;
    std::uint64_t bytes = 0, text = 0;
    for (const Object& object : scene.objects) {
        if (meshes.insert(mesh_key(object)).second) bytes += 100 * object.mesh->triangles.size();
        text += 1000 + 2 * object.name.size();  // for its node and mesh
    }
    constexpr std::uint64_t most = 4294967295;  // the largest value of the header's field
    if (bytes + text > most)
        return Problem{"", "", "the meshes are too large for one .glb file", "less than 4 GiB"};
    return result_of("", [&] { return Writer(scene).write(name); });
}

}  // namespace glint
