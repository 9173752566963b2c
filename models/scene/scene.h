#pragma once
// A scene as a value: copyable, equality-comparable, no callbacks, no globals. Undo is a list of scenes; a
// test is a scene and a picture. Names and defaults are those of the scene file (docs/scene_file.md).

#include <algorithm>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "models/mesh/mesh.h"
#include "models/mesh/normals.h"
#include "models/mesh/primitives/primitives.h"
#include "models/mesh/resolution/resolution.h"
#include "models/scene/camera.h"
#include "models/scene/light.h"
#include "models/scene/material.h"
#include "models/scene/shading.h"
#include "models/scene/transform.h"
#include "models/scene/transport.h"

namespace glint {

/// The limit of triangles in all objects of a scene; the renderer numbers them with 30 bits.
inline constexpr std::size_t max_scene_triangles = std::size_t{1} << 30;

/// The limit of meshes in one file.
inline constexpr int max_parts = 100'000;

struct MeshFile {
    std::string path;                 // as written in the scene file: relative to it, or absolute
    int part = 0;                     // index of the mesh in the file
    int decimate = 0, subdivide = 0;  // as in MeshResolution
    bool operator==(const MeshFile&) const = default;
};
struct PrimitiveMesh {
    Primitive primitive = Primitive::Sphere;
    int detail = 48;
    int decimate = 0, subdivide = 0;  // as in MeshResolution
    bool operator==(const PrimitiveMesh&) const = default;
};
/// The detail if a scene does not specify one.
[[nodiscard]] constexpr PrimitiveMesh default_mesh(Primitive primitive) {
    return {primitive, info_of(primitive).default_detail};
}
using MeshSource = std::variant<PrimitiveMesh, MeshFile>;

/// The decimation and subdivision of a source, and the same source without them.
[[nodiscard]] inline MeshResolution resolution_of(const MeshSource& source) {
    return std::visit([](const auto& s) { return MeshResolution{s.decimate, s.subdivide}; }, source);
}
[[nodiscard]] inline MeshSource as_given(MeshSource source) {
    std::visit([](auto& s) { s.decimate = s.subdivide = 0; }, source);
    return source;
}

struct Object {
    std::string name = "Object";
    bool visible = true;
    bool double_sided = false;  // its back faces are drawn, regardless of Shading::cull
    MeshSource source;
    Transform transform;
    NormalOptions normals;
    Material material;
    MeshPtr mesh;  // the loaded mesh of `source`; null before loading
    /// Compares meshes by pointer: an equal mesh that was loaded again makes a different object, so it is
    /// drawn again.
    bool operator==(const Object&) const = default;
};

/// Identifies the corner normals of an object: objects with equal keys have the same normals, except for
/// `flip`.
using NormalsKey = std::tuple<const Mesh*, NormalSource, NormalWeighting, float>;
[[nodiscard]] inline NormalsKey normals_key(const Object& object) {
    const NormalOptions& n = object.normals;
    return {object.mesh.get(), n.source, n.weighting, n.crease_deg};
}

/// Non-photorealistic: cool-to-warm shading and strokes.
struct Npr {
    bool cool_to_warm = false;
    glm::vec3 cool{0, 0, 0.55f}, warm{0.3f, 0.3f, 0};
    float alpha = 0.25f, beta = 0.5f;
    bool silhouettes = false, creases = false;
    float crease_deg = 40;
    glm::vec3 stroke{0};
    float stroke_width_px = 2;
    bool operator==(const Npr&) const = default;
};

enum class Transfer { None, Srgb };

struct Display {
    glm::vec3 background{0.1f, 0.1f, 0.12f};
    Transfer transfer = Transfer::None;
    float exposure = 1;
    bool operator==(const Display&) const = default;
};

/// The limits of lights and objects in a scene file.
inline constexpr std::size_t max_lights = 4096, max_objects = 10'000;
/// The maximum number of characters in the name of a light or an object. Explanations, programs and parts of
/// a glTF file repeat names many times.
inline constexpr std::size_t max_name_characters = 1000;

struct Scene {
    std::string about;
    Camera camera;
    glm::vec3 global_ambient{0.1f};
    std::vector<Light> lights;
    std::vector<Object> objects;
    Shading shading;
    Transport transport;
    Npr npr;
    Display display;
    bool operator==(const Scene&) const = default;
};

/// Whether both have the same scene file, ignoring loaded meshes. Used by saving, undo steps and reading
/// back.
[[nodiscard]] inline bool same_description(const Object& a, const Object& b) {
    return a.name == b.name && a.visible == b.visible && a.double_sided == b.double_sided &&
           a.source == b.source && a.transform == b.transform && a.normals == b.normals &&
           a.material == b.material;
}
[[nodiscard]] inline bool same_but_camera(const Scene& a, const Scene& b) {
    const auto same = [](const Object& x, const Object& y) { return same_description(x, y); };
    return a.about == b.about && a.global_ambient == b.global_ambient && a.lights == b.lights &&
           std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(), same) &&
           a.shading == b.shading && a.transport == b.transport && a.npr == b.npr && a.display == b.display;
}
[[nodiscard]] inline bool same_description(const Scene& a, const Scene& b) {
    return a.camera == b.camera && same_but_camera(a, b);
}

}  // namespace glint
