#pragma once
// Stage 3. Computes the input of lighting for each visible sample: its position and unit normal in camera
// coordinates, in blocks of 16 (phong, facet), the lit corners that it blends (gouraud), or the lit point
// that it shows (flat). Inputs: geometry, visibility, `normals`, `mode`, `interpolation`, `two_sided`,
// `flat_point` (and `rules`, which may override it).

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "renderer/geometry/object_normals.h"
#include "renderer/lighting/light_job.h"
#include "renderer/picture.h"
#include "renderer/simd/pixel_vector.h"
#include "renderer/surface/surface_kernels.h"
#include "renderer/visibility/visibility.h"

namespace glint {

// Weighs the corners of a face at a pixel, for the three kinds of interpolation. Lecture: "Gouraud Shading",
// "Gouraud Shading Artifacts", "Shading Artifacts: Orientation".

/// A position on the screen in pixels, y down, with (0, 0) at the picture's upper left corner.
struct PixelPosition {
    float x = 0, y = 0;
};

/// One visible sample: its face and the weights of its drawn triangle's corners.
struct SampleFace {
    PixelPosition at;
    std::uint32_t object = 0, triangle = 0;  // triangle: global number
    bool turned = false;                     // its normals are reversed: two_sided, seen from behind
    glm::vec3 weights{0};                    // perspective-correct
    glm::vec3 p{0};  // intersection of the pixel's ray with the face, camera coordinates
};

/// Weights of some corners of a mesh; all others have weight 0. There are at most eight: a scanline crosses
/// two edges, and if the near plane cuts the polygon, each end of an edge may be between two corners.
struct CornerWeights {
    static constexpr int max_count = 8;
    int count = 0;
    std::array<std::uint32_t, max_count> corner{};  // indices into Mesh::corner_position
    std::array<float, max_count> weight{};

    /// Adds a weight; a corner already listed keeps one entry.
    void add(std::uint32_t which, float w);
};

/// Fills in `weights` and `p` of the triangle seen at `face.at`.
void locate_on_face(SampleFace& face, const Geometry& geometry);

/// `perspective`: of the drawn triangle's corners, correct in space. `screen`: linear on the screen over the
/// drawn triangle. `scanline`: along the polygon's edges on the screen, then along the scanline between them.
/// For the last two, a face cut by the near plane is clipped first; its new corners get perspective-correct
/// values.
[[nodiscard]] CornerWeights corner_weights(Interpolation interpolation, const Geometry& geometry,
                                           const SampleFace& face);

/// Where the equation is evaluated, and the source of a pixel's colour.
enum class SurfaceKind {
    Pixels,   // one lit point per pixel
    Corners,  // lit points are vertices; a pixel blends three
    Faces     // lit points are polygons (or triangles, with a provoking corner); a pixel shows one
};

/// The members of `shading` that this stage reads.
struct SurfaceChoice {
    SurfaceKind kind = SurfaceKind::Pixels;
    bool facet_normals = false;  // Pixels: the facet's normal instead of the interpolated one
    Interpolation interpolation = Interpolation::Perspective;
    /// Faces: each triangle at its last corner instead of each polygon at its centroid.
    bool provoking = false;
    bool two_sided = false;  // reverses the normals of a face seen from behind
    NormalMistakes mistakes;
    bool operator==(const SurfaceChoice&) const = default;
};
[[nodiscard]] SurfaceChoice surface_choice(const Shading& shading);
/// Returns the maximum number of corners that a pixel blends with Corners.
[[nodiscard]] inline int max_blended(const SurfaceChoice& choice) {
    return choice.interpolation == Interpolation::Scanline ? CornerWeights::max_count : 3;
}

/// With several samples per pixel: the triangle of each lane of a group. A pixel then has a group for each
/// face seen in it.
struct GroupSamples {
    std::uint32_t triangle[block_size];  // global number
    float weight[block_size];            // fraction of the pixel's samples
    PixelPosition at[block_size];        // mean of the samples that show it
    std::uint16_t back = 0;              // bit i: clockwise on the screen
};

/// One entry per row of pixels, and one past the last.
struct RowGroups {
    std::size_t first_group = 0;  // the first group of this row
    std::uint64_t pixels = 0;     // number of pixels in the previous row that show a surface
};

/// The groups of one row of pixels, with several samples.
struct SampledRow {
    std::vector<PixelGroup> groups;
    std::vector<GroupSamples> samples;  // one per group
    std::uint64_t pixels = 0;           // number of pixels that show a surface
};

struct FaceRefs {
    std::uint32_t point[block_size];
};

/// A shading point on a vertex or face (Gouraud, flat): its object and a number within that object.
struct ShadingPoint {
    std::uint32_t object = 0;
    // Corners: ObjectNormals::slot_of(corner); Faces: polygon, or triangle when provoking.
    std::uint32_t item = 0;
    bool turned = false;  // its normal is reversed (two_sided, seen from behind)
    bool operator==(const ShadingPoint&) const = default;
};

/// The lit points that pixels share (Gouraud, flat), among all points of a scene that could be lit: object by
/// object, each item twice, with its own and with its reversed normal.
struct LitPoints {
    std::vector<std::size_t> first;            // #objects + 1, into seen and point
    std::vector<std::uint8_t> seen;            // 1: some pixel shows it
    std::vector<std::uint32_t> point;          // the lit point's number, or no_index
    std::vector<ShadingPoint> shading_points;  // one per lit point, 16 per block; unused ones have no_index

    [[nodiscard]] std::size_t number(const ShadingPoint& s) const {
        return first[s.object] + 2 * std::size_t{s.item} + (s.turned ? 1 : 0);
    }
};

// The data of each kind of surface in addition to the lit points.

struct PerPixel {
    std::vector<InterpolateJob> jobs;  // one per object
};
struct PerVertex {
    LitPoints lit;
    // The points that each pixel blends; entry k of lane i of a group is at Surface::corner_ref(group, k) +
    // i.
    PixelVector<std::uint32_t> ref_point;  // numbers of lit points
    PixelVector<float> ref_weight;         // 0: nothing to blend
    std::vector<InterpolateJob> jobs;      // one per object
};
struct PerFace {
    LitPoints lit;
    PixelVector<FaceRefs> refs;  // one per group
};

/// Counts the consecutive indices from `first` to `end` (exclusive) with the same `value` as the first; at
/// least 1.
template <class Value>
[[nodiscard]] std::size_t count_alike(std::size_t first, std::size_t end, const Value& value) {
    std::size_t next = first + 1;
    while (next < end && value(next) == value(first)) ++next;
    return next - first;
}

struct Surface {
    SurfaceChoice choice;
    BlockChoice wanted_blocks, blocks;  // wanted for the next frame; shown by the kept groups
    std::vector<ObjectNormals> normals;
    std::vector<PixelGroup> groups;                   // groups of the same 16 pixels are adjacent
    std::vector<GroupSamples> group_samples;          // one per group; empty with one sample per pixel
    std::vector<RowGroups> row_groups;                // #rows + 1, with one sample per pixel
    std::vector<SampledRow> sampled_rows;             // #rows, with several
    PixelVector<PointBlock> points;                   // lit points; Pixels: points[i] belongs to groups[i]
    std::vector<std::uint32_t> point_object;          // #points: the object whose material each block has
    std::variant<PerPixel, PerVertex, PerFace> kept;  // according to choice.kind
    std::uint64_t pixel_count = 0;                    // pixels that show a surface
    std::uint64_t point_count = 0;                    // lit points

    /// Returns the data of a surface of this kind: the existing data if they are of this kind, else empty
    /// data.
    template <class Kind> Kind& as() {
        if (!std::holds_alternative<Kind>(kept)) kept.emplace<Kind>();
        return std::get<Kind>(kept);
    }
    /// Precondition: Corners or Faces.
    [[nodiscard]] const LitPoints& lit_points() const {
        const auto* vertices = std::get_if<PerVertex>(&kept);
        return vertices != nullptr ? vertices->lit : std::get<PerFace>(kept).lit;
    }
    /// Counts the consecutive blocks of points from `first` to `end` (exclusive) that belong to the same
    /// object.
    [[nodiscard]] std::size_t blocks_of_one_object(std::size_t first, std::size_t end) const {
        return count_alike(first, end, [this](std::size_t block) { return point_object[block]; });
    }
    /// Counts the consecutive groups of pixels from `first` to `end` (exclusive) that belong to the same
    /// object.
    [[nodiscard]] std::size_t groups_of_one_object(std::size_t first, std::size_t end) const {
        return count_alike(first, end, [this](std::size_t group) { return groups[group].object; });
    }
    /// Index into PerVertex::ref_point and ref_weight of entry k of a group's lane 0; its other lanes follow.
    /// Precondition: Corners.
    [[nodiscard]] std::size_t corner_ref(std::size_t group, int k) const {
        return (group * static_cast<std::size_t>(max_blended(choice)) + static_cast<std::size_t>(k)) *
               block_size;
    }
};

/// Runs the stage again if any of its inputs differ; returns whether it did.
bool update_surface(Surface& kept, const Scene& scene, const Geometry& geometry, const Visibility& visibility,
                    bool visibility_redone);

/// The inputs of a single sample's colour, from a kept surface or from a different shading of the same
/// pixels.
struct SurfaceInputs {
    const SurfaceChoice& choice;
    const std::vector<ObjectNormals>& normals;
    SurfaceInputs(const SurfaceChoice& c, const std::vector<ObjectNormals>& n) : choice(c), normals(n) {}
    SurfaceInputs(const Surface& s) : choice(s.choice), normals(s.normals) {}  // NOLINT: implicit
};

/// Returns the face at lane `lane` of group `group`, without `weights` and `p`, which locate_on_face() fills
/// in.
[[nodiscard]] SampleFace face_of_lane(const Surface& surface, const Geometry& geometry,
                                      const Visibility& visibility, std::size_t group, unsigned lane);
/// Returns the face at the centre of pixel (x, y). Precondition: one sample per pixel, and it shows a
/// surface.
[[nodiscard]] SampleFace sample_face(const SurfaceChoice& choice, const Geometry& geometry,
                                     const Visibility& visibility, int x, int y);

/// A position and its unit normal, camera coordinates.
struct PositionNormal {
    glm::vec3 p{0}, n{0};

    void put(PointBlock& block, std::size_t lane) const {
        block.x[lane] = p.x;
        block.y[lane] = p.y;
        block.z[lane] = p.z;
        block.nx[lane] = n.x;
        block.ny[lane] = n.y;
        block.nz[lane] = n.z;
    }
};
/// Position and normal of the pixel's own point, which is lit for Pixels and only informative for the other
/// kinds.
[[nodiscard]] PositionNormal pixel_point(const SurfaceInputs& surface, const Geometry& geometry,
                                         const SampleFace& face);
/// Position and normal of a shading point on a vertex or face (Gouraud, flat).
[[nodiscard]] PositionNormal lit_point(const SurfaceInputs& surface, const Geometry& geometry,
                                       const ShadingPoint& source);

/// The shading points that a sample blends for Corners (weights in the same order), or shows for Faces (one).
struct BlendedPoints {
    int count = 0;
    std::array<ShadingPoint, CornerWeights::max_count> point;
    std::array<float, CornerWeights::max_count> weight{};
};
[[nodiscard]] BlendedPoints blended_points(const SurfaceInputs& surface, const Geometry& geometry,
                                           const SampleFace& face);

// The steps that fill a surface.

/// With several samples per pixel: fills groups, group_samples and pixel_count from all planes of the
/// visibility, in reading order (surface.cpp).
void find_sampled_groups(Surface& surface, const Geometry& geometry, const Visibility& visibility);

/// Fills `jobs` with the kernels' input for interpolation over each object's faces, one per object.
void prepare_interpolation(std::vector<InterpolateJob>& jobs, const Surface& surface,
                           const Geometry& geometry, const Visibility& visibility);

/// Groups per call of a kernel.
inline constexpr std::size_t max_together = 64;

/// Phong and facet shading: fills points, point_object and point_count with the position and normal of every
/// visible pixel (lit_points.cpp). Precondition: the groups have been found.
void interpolate_pixels(Surface& surface, const Geometry& geometry, const Visibility& visibility);

/// Gouraud and flat shading light only visible corners and faces, each once: fills points, point_object, and
/// the references of every group (lit_points.cpp). Precondition: the groups have been found.
void collect_lit_points(Surface& surface, const Geometry& geometry, const Visibility& visibility);

}  // namespace glint
