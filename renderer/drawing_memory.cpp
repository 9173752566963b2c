#include "renderer/drawing_memory.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <set>

#include "models/mesh/topology.h"
#include "renderer/shade/lighting.h"
#include "renderer/surface/surface.h"
#include "renderer/visibility/binning.h"

namespace glint {
namespace {

// Bytes of an object, whatever its mesh: its geometry, materials and jobs.
constexpr std::uint64_t bytes_an_object = 4096;
// Bytes of a normal that is averaged: its sum in doubles meanwhile.
constexpr std::uint64_t bytes_of_sum = 48;
// Bytes of a point that is lit for several pixels: position and normal, what it is, its colour.
constexpr std::uint64_t bytes_of_point = (sizeof(PointBlock) + sizeof(std::uint32_t)) / block_size +
                                         sizeof(ShadingPoint) + sizeof(ColorRecord) + sizeof(std::uint32_t);

/// Width and height, in pixels, of where an object may show.
struct Extent {
    double width = 0, height = 0;
    [[nodiscard]] double area() const { return width * height; }
};

/// The extent of the corners of the mesh's bounds on the screen; the whole picture where one is not before
/// the eye.
Extent extent_of(const Object& object, const glm::dmat4& clip_from_world, PictureSize size) {
    const Extent whole{static_cast<double>(size.width), static_cast<double>(size.height)};
    const glm::dmat4 clip_from_object = clip_from_world * world_from_object(object.transform);
    glm::dvec2 low(HUGE_VAL), high(-HUGE_VAL);
    for (const glm::dvec3& corner : corners_of(object.mesh->bounds)) {
        const glm::dvec4 clip = clip_from_object * glm::dvec4(corner, 1);
        if (!(clip.w > 0)) return whole;
        low = glm::min(low, glm::dvec2(clip) / clip.w);
        high = glm::max(high, glm::dvec2(clip) / clip.w);
    }
    const glm::dvec2 across = glm::clamp(high, -1.0, 1.0) - glm::clamp(low, -1.0, 1.0);
    if (!(across.x >= 0 && across.y >= 0)) return whole;  // numbers too large
    return {across.x / 2 * whole.width, across.y / 2 * whole.height};
}

/// How many normals shading takes of an object, and how many corners say which is theirs.
struct NormalCounts {
    std::uint64_t normals = 0, corners = 0;
    bool averaged = false;
};
NormalCounts normal_counts(const Object& object) {
    const Mesh& mesh = *object.mesh;
    const std::uint64_t corners = mesh.corner_position.size(), positions = mesh.positions.size();
    if (object.normals.source == NormalSource::Facet) return {mesh.face_count(), corners, false};
    const bool given =
        mesh.given_normals != GivenNormals::None && object.normals.source != NormalSource::Vertex;
    if (given) {  // corners that have none take an averaged one
        const bool complete = mesh.given_normals == GivenNormals::Analytic;
        return {mesh.normals.size() + (complete ? 0 : positions), corners, !complete};
    }
    const bool creased = object.normals.crease_deg < 180;
    return {creased ? corners : positions, creased ? corners : 0, true};
}

/// What the objects need, and each of their meshes once.
class ObjectsMemory {
  public:
    ObjectsMemory(const Scene& scene, std::uint64_t tiles, const SurfaceChoice& choice) {
        const bool edges = scene.npr.silhouettes || scene.npr.creases;
        for (const Object& object : scene.objects) add(object, tiles, choice, edges);
        need[MemoryUse::Objects] += max_meanwhile_;
    }
    MemoryNeed need;

  private:
    void add(const Object& object, std::uint64_t tiles, const SurfaceChoice& choice, bool edges) {
        const Mesh& mesh = *object.mesh;
        const std::uint64_t triangles = mesh.triangles.size();
        const NormalCounts normals = normal_counts(object);
        need[MemoryUse::Objects] +=
            bytes_an_object + mesh.positions.size() * (sizeof(TransformedVertex) + sizeof(ScreenVertex)) +
            normals.normals * sizeof(CameraNormal) + lit_items(mesh, normals, choice);
        need[MemoryUse::Tiles] += bytes_to_bin(triangles, tiles);
        if (meshes_.insert(&mesh).second)
            need[MemoryUse::Objects] +=
                3 * triangles * sizeof(std::uint32_t) + (edges ? topology_memory(mesh) : 0);
        if (!options_.insert(normals_key(object)).second) return;
        need[MemoryUse::Objects] +=
            normals.normals * sizeof(glm::vec3) + normals.corners * sizeof(std::uint32_t);
        if (normals.averaged)
            max_meanwhile_ =
                std::max(max_meanwhile_, normals.normals * bytes_of_sum +
                                             (object.normals.crease_deg < 180 ? topology_memory(mesh) : 0));
    }

    /// The bytes of corners or faces that may be lit, each with its normal as it is and reversed; few are
    /// seen from both sides.
    static std::uint64_t lit_items(const Mesh& mesh, const NormalCounts& normals,
                                   const SurfaceChoice& choice) {
        if (choice.kind == SurfaceKind::Pixels) return 0;
        const std::uint64_t faces = choice.provoking ? mesh.triangles.size() : mesh.face_count();
        const std::uint64_t slots = normals.corners > 0 ? mesh.corner_position.size() : mesh.positions.size();
        const std::uint64_t items = choice.kind == SurfaceKind::Faces ? faces : slots;
        return items * (2 * (sizeof(std::uint8_t) + sizeof(std::uint32_t)) + bytes_of_point);
    }

    std::uint64_t max_meanwhile_ = 0;
    std::set<const Mesh*> meshes_;
    std::set<NormalsKey> options_;
};

/// The bytes that every pixel takes, whatever shows there.
std::uint64_t bytes_of_pixels(const Scene& scene, PictureSize size, bool linear, int samples) {
    const std::uint64_t width = static_cast<std::uint64_t>(size.width),
                        height = static_cast<std::uint64_t>(size.height);
    const std::uint64_t blocks = (width + block_size - 1) / block_size * height;
    std::uint64_t a_pixel =
        4 * sizeof(std::uint8_t) + sizeof(std::uint32_t) * static_cast<std::uint64_t>(samples);
    if (linear) a_pixel += 3 * sizeof(float);
    if (scene.npr.silhouettes || scene.npr.creases) a_pixel += sizeof(float);
    return width * height * a_pixel + blocks * 2 * sizeof(std::uint16_t) + height * sizeof(SampledRow);
}

/// What depends on where the objects show: guessed from their bounds on the screen.
class ShownMemory {
  public:
    ShownMemory(const Scene& scene, PictureSize size, const SurfaceChoice& choice, int samples) {
        const glm::dmat4 clip_from_world =
            clip_from_view(scene.camera.projection, size) * view_from_world(scene.camera);
        for (const Object& object : scene.objects)
            add(extent_of(object, clip_from_world, size), static_cast<double>(object.mesh->triangles.size()),
                samples);
        const double blocks = std::ceil(size.width / double(block_size)) * size.height;
        // Where objects hide one another, a row of 16 pixels is divided at most at their outlines.
        const double groups = std::min(groups_, blocks + outline_rows_) + divided_;
        need += memory_need(MemoryUse::Pixels,
                            bytes_of_groups(choice, static_cast<std::uint64_t>(groups), samples));
        need += memory_need(MemoryUse::Tiles, static_cast<std::uint64_t>(entries_) * sizeof(TileEntry));
    }
    MemoryNeed need;

  private:
    void add(const Extent& extent, double triangles, int samples) {
        const double groups = (extent.width / double(block_size) + 2) * (extent.height + 1);
        groups_ += groups;
        outline_rows_ += 2 * (extent.height + 1);
        if (triangles == 0) return;
        if (samples > 1)
            divided_ += groups * more_groups(triangles / 2 / std::max(extent.area(), 1.0), samples);
        // Half of them are seen, and a triangle fills half its box.
        const double side =
            std::min(std::sqrt(4 * extent.area() / triangles) / tile_size + 1, double(CellGrid::widest));
        entries_ += triangles *
                    std::min(side * side, (extent.width / tile_size + 2) * (extent.height / tile_size + 2));
    }

    /// Estimates how many more groups of 16 pixels several samples make of one: one more if an edge passes
    /// through it, a few more if a vertex lies in it, and one per sample if triangles are as small as pixels.
    /// `density`: visible triangles per pixel. Their edges are then about 4.6 sqrt(density) long per pixel.
    static double more_groups(double density, int samples) {
        const double edges = 4.6 * std::sqrt(density) * double(block_size),
                     vertices = density / 2 * double(block_size);
        const double more =
            std::min(edges, 1.0) + 3 * std::min(vertices, 1.0) + samples * std::min(density, 1.0);
        return std::min(more, samples - 1.0);
    }

    double groups_ = 0, outline_rows_ = 0, divided_ = 0, entries_ = 0;
};

}  // namespace

DrawingMemory drawing_memory(const Scene& scene, PictureSize size, bool linear, int samples) {
    const auto tiles = [](int side) {
        return static_cast<std::uint64_t>((side + tile_size - 1) / tile_size);
    };
    const SurfaceChoice choice = surface_choice(scene.shading);
    DrawingMemory memory;
    memory.certain = ObjectsMemory(scene, tiles(size.width) * tiles(size.height), choice).need;
    memory.certain[MemoryUse::Pixels] += bytes_of_pixels(scene, size, linear, samples);
    memory.guessed = ShownMemory(scene, size, choice, samples).need;
    return memory;
}

}  // namespace glint
