#pragma once
// A scene as a value: copyable, equality-comparable, no callbacks, no globals. Undo is a list of scenes; a
// test is a scene and a picture. Names and defaults are those of the scene file (docs/scene_file.md).

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "models/mesh/mesh.h"
#include "models/mesh/normals.h"
#include "models/mesh/primitives/primitives.h"
#include "models/mesh/resolution/resolution.h"
#include "models/problem.h"
#include "models/scene/shading.h"

namespace glint {

// The camera: the position of the eye and the projection of the view volume (lecture: "Viewing", "Perspective
// Derivation"). Right-handed; in its own coordinates the camera looks down -z, x right, y up.

struct Perspective {
    float fov_y_deg = 45;  // full vertical angle, above 0 and below 180
    float near = 0.1f, far = 100;
    bool operator==(const Perspective&) const = default;
};
struct Orthographic {
    float height = 4;  // of the view volume, in scene units
    float near = 0.1f, far = 100;
    bool operator==(const Orthographic&) const = default;
};
/// Asymmetric perspective: the window on the near plane. Stretched to fit the picture, as in OpenGL.
struct Frustum {
    float left = -0.05f, right = 0.05f, bottom = -0.05f, top = 0.05f;
    float near = 0.1f, far = 100;
    bool operator==(const Frustum&) const = default;
};
using Projection = std::variant<Perspective, Orthographic, Frustum>;

struct Camera {
    glm::vec3 eye{0, 0, 5}, target{0}, up{0, 1, 0};  // world coordinates
    Projection projection;
    bool operator==(const Camera&) const = default;
};

inline constexpr int max_picture_side = 16384;

/// Width and height of a picture in pixels, 1 to max_picture_side each.
struct PictureSize {
    int width = 1280, height = 720;
    bool keeps_width = false;  // below 16:9 the horizontal field stays the same: see fitted()
    bool operator==(const PictureSize&) const = default;

    [[nodiscard]] std::size_t pixels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    /// Pixels are numbered row by row from the upper left corner. Precondition: (x, y) is inside.
    [[nodiscard]] std::size_t index(int x, int y) const {
        assert(x >= 0 && y >= 0 && x < width && y < height);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Camera coordinates from world coordinates: rows (u, -u.eye), (v, -v.eye), (w, -w.eye), (0 0 0 1), with w =
/// (eye - target)/|eye - target|, u = up x w / |up x w|, v = w x u. (The slide "Correction: W2V vs. V2W"
/// labels this matrix M_V2W; it maps the eye to the origin.) In double, so that an eye and an object that are
/// both far away keep a precise difference.
/// Precondition: eye != target and up not parallel to the viewing direction (checked when a scene is read).
[[nodiscard]] glm::dmat4 view_from_world(const Camera& camera);
/// World coordinates from camera coordinates: the inverse of view_from_world(), with the axes u, v, w as
/// columns and the same precondition.
[[nodiscard]] glm::dmat4 world_from_view(const Camera& camera);

/// The aspect ratio, width / height, for which scenes are composed.
inline constexpr double composed_aspect = 16.0 / 9;

/// Whether the vertical field of view is larger than the projection's.
[[nodiscard]] constexpr bool is_widened(PictureSize size) {
    return size.keeps_width && 9LL * size.width < 16LL * size.height;
}

/// The projection for a picture of this size. `projection` has a vertical field of view. If the size keeps
/// its width and is narrower than 16:9, the horizontal field of view is the same as at 16:9, so the vertical
/// one is larger. A frustum stays unchanged and is stretched to fit the picture.
[[nodiscard]] Projection fitted(const Projection& projection, PictureSize size);

/// OpenGL's clip coordinates from camera coordinates, for fitted(projection, size): rows (E 0 A 0) (0 F B 0)
/// (0 0 C D) (0 0 -1 0); points with -w <= x, y, z <= w are visible. Source: lecture, "Perspective
/// Derivation"; OpenGL 2.1, section 2.11.
[[nodiscard]] glm::dmat4 clip_from_view(const Projection& projection, PictureSize size);

/// The clipping planes' distances from the eye along the line of sight, scene units.
[[nodiscard]] inline float near_of(const Projection& projection) {
    return std::visit([](const auto& p) { return p.near; }, projection);
}
[[nodiscard]] inline float far_of(const Projection& projection) {
    return std::visit([](const auto& p) { return p.far; }, projection);
}
[[nodiscard]] inline bool is_orthographic(const Projection& projection) {
    return std::holds_alternative<Orthographic>(projection);
}

// A light as the scene file describes it (docs/scene_file.md, "Lights"; lecture: "Light Sources"). Plain
// data; renderer/lighting computes its effect.

enum class LightKind { Directional, Point, Spot, Area };
/// World lights stay with the scene, and camera lights move with the viewer (lecture: "geometry: positions
/// and directions").
enum class LightSpace { World, Camera };

/// 1 / (constant + linear r + quadratic r^2), r the distance in scene units. All >= 0, not all zero.
struct Falloff {
    float constant = 1, linear = 0, quadratic = 0;
    bool operator==(const Falloff&) const = default;
};

/// The cone of a spot: cos(angle from the axis)^exponent inside the cutoff, 0 outside. Between the inner
/// angle and the cutoff it also falls off smoothly, as in KHR_lights_punctual.
struct SpotCone {
    glm::vec3 direction{0, -1, 0};  // in the light's space, any length but 0
    float cutoff_deg = 30;          // axis to edge, 0 to 90; 180: no cone
    float exponent = 1;             // >= 0
    float inner_deg = 180;          // 0 to 90, or 180; at or above the cutoff: no soft edge
    bool operator==(const SpotCone&) const = default;
};

/// A parallelogram centred on the position, with these half-edges (in the light's space).
struct AreaShape {
    glm::vec3 edge_u{0.5f, 0, 0}, edge_v{0, 0, 0.5f};
    int samples = 16;  // a square number, 1 to 64: n x n points at the centres of n x n equal cells
    bool operator==(const AreaShape&) const = default;
};

struct Light {
    std::string name = "Light";
    LightKind kind = LightKind::Point;
    LightSpace space = LightSpace::World;
    glm::vec4 position{0, 2, 2, 1};  // w = 0: the direction towards the light; w > 0: a point, divided by w
    glm::vec3 ambient{0}, diffuse{1}, specular{1};  // linear RGB, >= 0, 1 is full intensity
    float intensity = 1;                            // multiplies all three, >= 0
    bool enabled = true;
    Falloff falloff;  // point and spot only
    SpotCone spot;    // kept but ignored for other kinds
    AreaShape area;   // kept but ignored for other kinds
    bool operator==(const Light&) const = default;
};

// The reflection properties of a surface (docs/scene_file.md; lecture: "Lighting in OpenGL").

struct Material {
    glm::vec3 ambient{0.2f}, diffuse{0.8f}, specular{1};  // k_a, k_d, k_s: linear RGB, reflected fraction
    glm::vec3 emission{0};                                // linear RGB
    float shininess = 32;                                 // exponent n_shiny, 0 to 10,000
    float roughness = 0.5f;                               // 0 to 1; oren-nayar and cook-torrance
    glm::vec3 f0{0.04f};                                  // reflectance at normal incidence; cook-torrance
    OwnReflection reflection = OwnReflection::Scene;
    bool operator==(const Material&) const = default;
};

/// The reflection model of a material in a scene with the model `of_scene`. In an unlit scene, nothing is
/// lit.
[[nodiscard]] constexpr Reflection reflection_of(const Material& material, Reflection of_scene) {
    const bool is_own = material.reflection != OwnReflection::Scene && of_scene != Reflection::None;
    return is_own ? static_cast<Reflection>(material.reflection) : of_scene;
}

/// One of the classic materials of the OpenGL sample programs (assets/materials.json).
struct MaterialPreset {
    std::string_view name, family;  // family: gem, metal, plastic, rubber
    Material material;
};

/// All presets, in the order of assets/materials.json, which is compiled in.
[[nodiscard]] std::span<const MaterialPreset> material_presets();

// The transform of an object: M = T Rz Ry Rx S (docs/scene_file.md, "Objects").

struct Transform {
    glm::vec3 translate{0};
    glm::vec3 rotate_deg{0};  // about x, then y, then z
    glm::vec3 scale{1};       // no component is 0; a negative one mirrors
    bool operator==(const Transform&) const = default;
};

/// World coordinates from object coordinates, in double (see view_from_world).
[[nodiscard]] glm::dmat4 world_from_object(const Transform& transform);

// The three steps in an order other than that of a scene file. Lecture: "Transformations" (the last one
// written is applied first).

enum class TransformStep { Translate, Rotate, Scale };

/// The steps in the order in which they are written; the last one is applied first.
using TransformOrder = std::array<TransformStep, 3>;
inline constexpr TransformOrder file_order{TransformStep::Translate, TransformStep::Rotate,
                                           TransformStep::Scale};

/// Returns the transform in file order that has the same matrix as `written` in `order`, with the rotation
/// and the scale of `written`. Returns nullopt if a scale is written before a rotation with which it does not
/// commute: that shears or scales along other axes, which a scene file cannot express with these numbers.
[[nodiscard]] std::optional<Transform> in_file_order(const Transform& written, const TransformOrder& order);

/// The limit on the total number of triangles in a scene; the renderer numbers them with 30 bits.
inline constexpr std::size_t max_scene_triangles = std::size_t{1} << 30;

/// The limit on the number of meshes in one file.
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
/// The detail that applies if a scene does not specify one.
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

/// The limits on the numbers of lights and objects in a scene file.
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

/// Whether the two objects are the same in a scene file, ignoring loaded meshes. Used for saving, undo steps
/// and read-back checks.
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

// Estimates the memory of a scene and its picture. The estimate is compared with the limit before drawing.

/// The limit on the number of samples in a picture: its pixels times the samples per pixel.
inline constexpr std::uint64_t max_picture_samples = std::uint64_t{1} << 30;

/// The bytes used by a mesh's lists.
[[nodiscard]] std::uint64_t mesh_bytes(const Mesh& mesh);

/// Estimated bytes. Objects without a loaded mesh count as empty.
struct SceneCost {
    std::uint64_t meshes = 0;   // each mesh counted once
    std::uint64_t objects = 0;  // transformed vertices, normals, triangles in tiles and for rays
    std::uint64_t picture = 0;
};
[[nodiscard]] SceneCost scene_cost(const Scene& scene, PictureSize size, int samples);
/// The problem with a cost above memory_limit().
[[nodiscard]] std::optional<Problem> too_much_memory(const SceneCost& cost);

/// The problem with a scene that has too many triangles or samples, or that needs more memory than
/// memory_limit(). Without `size`, checks only the scene.
[[nodiscard]] std::optional<Problem> too_large(const Scene& scene, PictureSize size = {0, 0},
                                               int samples = 1);

}  // namespace glint
