// The lit points shared by several pixels: one per face with flat shading (SurfaceKind::Faces), the corners
// with Gouraud shading (SurfaceKind::Corners). blended_colors() in renderer/simd/isa/lighting_kernels_isa.cpp
// blends their colours. Phong and facet shading light each pixel.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <functional>
#include <numeric>

#include "renderer/geometry/clip.h"
#include "renderer/surface/surface.h"

namespace glint {
namespace {

void number_items(LitPoints& lit, const Surface& s, const Geometry& g) {
    lit.first.assign(1, 0);
    for (std::size_t o = 0; o < g.objects.size(); ++o) {
        const Mesh& mesh = *g.objects[o].mesh;
        std::size_t items = mesh.face_count();
        if (s.choice.provoking) items = mesh.triangles.size();
        if (s.choice.kind == SurfaceKind::Corners) items = s.normals[o].slot_count();
        lit.first.push_back(lit.first.back() + 2 * items);
    }
    lit.seen.assign(lit.first.back(), 0);
    lit.point.assign(lit.first.back(), no_index);
}

/// Calls visit(lane, end, face) for each run of adjacent pixels of a group that show the same side of the
/// same triangle. The run consists of lanes `lane` to `end` - 1; `face` is that of the first pixel.
template <class Visit>
void visit_runs(const Surface& s, const Geometry& g, const Visibility& visibility, std::size_t group,
                const Visit& visit) {
    const std::uint32_t mask = s.groups[group].mask;
    const std::uint32_t* seen = &visibility.seen[s.groups[group].first_pixel];
    for (unsigned lane = 0, end = 0; lane < block_size; lane = end) {
        end = lane + 1;
        if (!(mask >> lane & 1u)) continue;
        if (s.group_samples.empty())
            while (end < block_size && (mask >> end & 1u) && seen[end] == seen[lane]) ++end;
        visit(lane, end, face_of_lane(s, g, visibility, group, lane));
    }
}

/// Calls visit(lane, face) for each pixel of a group, with its position on the face.
template <class Visit>
void visit_lanes(const Surface& s, const Geometry& g, const Visibility& visibility, std::size_t group,
                 const Visit& visit) {
    for (unsigned lane = 0; lane < block_size; ++lane) {
        if (!(s.groups[group].mask >> lane & 1u)) continue;
        SampleFace face = face_of_lane(s, g, visibility, group, lane);
        locate_on_face(face, g);
        visit(lane, face);
    }
}

/// Numbers the visible items of each object consecutively. Each object begins a new block.
void number_seen(LitPoints& lit, Surface& s) {
    lit.shading_points.clear();
    s.point_object.clear();
    s.point_count = 0;
    for (std::uint32_t o = 0; o + 1 < lit.first.size(); ++o) {
        for (std::size_t i = lit.first[o]; i < lit.first[o + 1]; ++i) {
            if (!lit.seen[i]) continue;
            lit.point[i] = static_cast<std::uint32_t>(lit.shading_points.size());
            const std::size_t local = i - lit.first[o];
            lit.shading_points.push_back({o, static_cast<std::uint32_t>(local / 2), local % 2 != 0});
            ++s.point_count;
        }
        while (lit.shading_points.size() % block_size) lit.shading_points.push_back({o, no_index, false});
        s.point_object.resize(lit.shading_points.size() / block_size, o);
    }
}

void place_points(const LitPoints& lit, Surface& s, const Geometry& g) {
    s.points.resize(s.point_object.size());
    tbb::parallel_for(std::size_t{0}, s.points.size(), [&](std::size_t b) {
        PointBlock block{};
        for (std::size_t i = 0; i < block_size; ++i) {
            const ShadingPoint& source = lit.shading_points[b * block_size + i];
            if (source.item != no_index) lit_point(s, g, source).put(block, i);
        }
        s.points[b] = block;
    });
}

/// Finds the lit points used by the visible pixels.
void find_lit_points(LitPoints& lit, Surface& s, const Geometry& g, const Visibility& visibility) {
    number_items(lit, s, g);
    // Perspective interpolation blends the three corners of a triangle at every pixel.
    const bool weighted =
        s.choice.kind == SurfaceKind::Corners && s.choice.interpolation != Interpolation::Perspective;
    const auto mark = [&](const SampleFace& face) {
        const BlendedPoints sample = blended_points(s, g, face);
        for (std::size_t k = 0; k < static_cast<std::size_t>(sample.count); ++k)
            // Several threads may write the same 1.
            std::atomic_ref(lit.seen[lit.number(sample.point[k])]).store(1, std::memory_order_relaxed);
    };
    tbb::parallel_for(std::size_t{0}, s.groups.size(), [&](std::size_t r) {
        if (weighted)
            return visit_lanes(s, g, visibility, r, [&](unsigned, const SampleFace& at) { mark(at); });
        visit_runs(s, g, visibility, r, [&](unsigned, unsigned, const SampleFace& face) { mark(face); });
    });
    number_seen(lit, s);
    place_points(lit, s, g);
}

/// Stores the lit point of the face visible at each pixel of a group.
void refer_to_faces(PerFace& faces, const Surface& s, const Geometry& g, const Visibility& visibility,
                    std::size_t group) {
    FaceRefs refs{};
    visit_runs(s, g, visibility, group, [&](unsigned lane, unsigned end, const SampleFace& face) {
        const ShadingPoint shown = blended_points(s, g, face).point[0];
        std::fill(refs.point + lane, refs.point + end, faces.lit.point[faces.lit.number(shown)]);
    });
    faces.refs[group] = refs;
}

/// Stores the lit points and weights to blend at each pixel of a group, pixel by pixel. The colours are
/// blended later (blended_colors() in renderer/simd/isa/lighting_kernels_isa.cpp).
void store_one_by_one(PerVertex& vertices, const Surface& s, const Geometry& g, const Visibility& visibility,
                      std::size_t group) {
    const std::size_t first = s.corner_ref(group, 0), end = s.corner_ref(group + 1, 0);
    std::fill(&vertices.ref_point[first], vertices.ref_point.data() + end, 0u);
    std::fill(&vertices.ref_weight[first], vertices.ref_weight.data() + end, 0.0f);
    visit_lanes(s, g, visibility, group, [&](unsigned lane, const SampleFace& face) {
        const BlendedPoints sample = blended_points(s, g, face);
        for (int k = 0; k < std::min(sample.count, max_blended(s.choice)); ++k) {
            const auto which = static_cast<std::size_t>(k);
            const std::size_t at = s.corner_ref(group, k) + lane;
            vertices.ref_point[at] = vertices.lit.point[vertices.lit.number(sample.point[which])];
            vertices.ref_weight[at] = sample.weight[which];
        }
        // Unused entries have weight 0 and the first entry's point. Another point might be NaN, and 0 times
        // NaN is NaN.
        for (int k = sample.count; k < max_blended(s.choice); ++k)
            vertices.ref_point[s.corner_ref(group, k) + lane] =
                vertices.ref_point[s.corner_ref(group, 0) + lane];
    });
}

/// Stores the three lit corners to blend at each pixel of a group. The kernel has already stored their
/// weights.
void store_weighed(PerVertex& vertices, const Surface& s, const Geometry& g, const Visibility& visibility,
                   std::size_t group) {
    std::uint32_t* point = &vertices.ref_point[s.corner_ref(group, 0)];
    std::fill_n(point, 3 * block_size, 0u);
    visit_runs(s, g, visibility, group, [&](unsigned lane, unsigned end, const SampleFace& face) {
        const BlendedPoints corners = blended_points(s, g, face);
        for (std::size_t k = 0; k < 3; ++k)
            std::fill(point + k * block_size + lane, point + k * block_size + end,
                      vertices.lit.point[vertices.lit.number(corners.point[k])]);
    });
    const std::uint32_t mask = s.groups[group].mask;
    float* weight = &vertices.ref_weight[s.corner_ref(group, 0)];
    for (std::size_t i = 0; mask != 0xFFFF && i < 3 * block_size; ++i)
        if (!(mask >> i % block_size & 1u)) weight[i] = 0;
}

/// Stores the corners and weights of the groups first .. first + count - 1. All of them show one object, with
/// one sample per pixel and perspective-correct weights.
void store_together(PerVertex& vertices, const Surface& s, const Geometry& g, const Visibility& visibility,
                    std::size_t first, std::size_t count) {
    std::array<std::uint8_t, max_together> on_fast_path;
    surface_kernels().weigh(vertices.jobs[s.groups[first].object], &s.groups[first], count,
                            &vertices.ref_weight[s.corner_ref(first, 0)], on_fast_path.data());
    for (std::size_t i = 0; i < count; ++i)
        (on_fast_path[i] ? store_weighed : store_one_by_one)(vertices, s, g, visibility, first + i);
}

void store_corners(PerVertex& vertices, const Surface& s, const Geometry& g, const Visibility& visibility) {
    vertices.ref_point.resize(s.corner_ref(s.groups.size(), 0));
    vertices.ref_weight.resize(vertices.ref_point.size());
    const bool together = s.group_samples.empty() && s.choice.interpolation == Interpolation::Perspective;
    prepare_interpolation(vertices.jobs, s, g, visibility);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.groups.size(), 256), [&](const auto& range) {
        for (std::size_t r = range.begin(); r != range.end();) {
            const std::size_t end = std::min(range.end(), r + max_together);
            const std::size_t count = together ? s.groups_of_one_object(r, end) : 1;
            if (together)
                store_together(vertices, s, g, visibility, r, count);
            else
                store_one_by_one(vertices, s, g, visibility, r);
            r += count;
        }
    });
}

}  // namespace

void collect_lit_points(Surface& s, const Geometry& g, const Visibility& visibility) {
    if (s.choice.kind == SurfaceKind::Corners) {
        PerVertex& vertices = s.as<PerVertex>();
        find_lit_points(vertices.lit, s, g, visibility);
        return store_corners(vertices, s, g, visibility);
    }
    PerFace& faces = s.as<PerFace>();
    find_lit_points(faces.lit, s, g, visibility);
    faces.refs.resize(s.groups.size());
    tbb::parallel_for(std::size_t{0}, s.groups.size(),
                      [&](std::size_t r) { refer_to_faces(faces, s, g, visibility, r); });
}

// The surface of kind Pixels: position and normal of every visible pixel. The fast path computes 16 pixels at
// once, with the same formulas as for a single pixel (surface.cpp). Other pixels are computed one by one.

namespace {

// The kernels access a mesh's triangles as plain numbers.
static_assert(sizeof(Triangle) == 4 * sizeof(std::uint32_t) && offsetof(Triangle, corner) == 0);

InterpolateJob interpolate_job(const Surface& s, const Geometry& g, const Visibility& visibility,
                               std::size_t o) {
    const ObjectGeometry& object = g.objects[o];
    InterpolateJob job;
    job.vertices = object.vertices.data();
    job.normals = s.normals[o].normals.data();
    job.triangle_vertices = object.triangle_vertices.data();
    if (!s.normals[o].of_mesh->corner.empty()) {
        job.triangle_corners = object.mesh->triangles.front().corner.data();
        job.corner_normal = s.normals[o].of_mesh->corner.data();
    }
    job.width = static_cast<float>(g.size.width);
    job.height = static_cast<float>(g.size.height);
    job.seen = visibility.seen.data();
    job.clipped_bits = needs_clipping;
    job.first_triangle = object.first_triangle;
    job.two_sided = s.choice.two_sided;
    return job;
}

void place_one_by_one(const Surface& s, const Geometry& g, const Visibility& visibility, std::size_t group,
                      PointBlock& out) {
    out = {};
    for (unsigned i = 0; i < block_size; ++i) {
        if (!(s.groups[group].mask >> i & 1u)) continue;
        SampleFace face = face_of_lane(s, g, visibility, group, i);
        locate_on_face(face, g);
        pixel_point(s, g, face).put(out, i);
    }
}

/// Computes groups first .. first + count - 1, all of one object.
void place_together(Surface& s, const Geometry& g, const Visibility& visibility, std::size_t first,
                    std::size_t count) {
    std::array<std::uint8_t, max_together> on_fast_path;
    const InterpolateJob& job = std::get<PerPixel>(s.kept).jobs[s.groups[first].object];
    surface_kernels().interpolate(job, &s.groups[first], count, &s.points[first], on_fast_path.data());
    for (std::size_t i = 0; i < count; ++i)
        if (!on_fast_path[i]) place_one_by_one(s, g, visibility, first + i, s.points[first + i]);
}

}  // namespace

void prepare_interpolation(std::vector<InterpolateJob>& jobs, const Surface& s, const Geometry& g,
                           const Visibility& visibility) {
    jobs.clear();
    for (std::size_t o = 0; o < g.objects.size(); ++o)
        jobs.push_back(g.objects[o].mesh->triangles.empty() ? InterpolateJob{}
                                                            : interpolate_job(s, g, visibility, o));
}

void interpolate_pixels(Surface& s, const Geometry& g, const Visibility& visibility) {
    s.points.resize(s.groups.size());
    s.point_object.resize(s.groups.size());
    s.point_count = s.pixel_count;
    if (!s.group_samples.empty())
        s.point_count = std::transform_reduce(
            s.groups.begin(), s.groups.end(), std::uint64_t{0}, std::plus<>(),
            [](const PixelGroup& group) { return static_cast<std::uint64_t>(std::popcount(group.mask)); });
    const bool on_fast_path = s.group_samples.empty() && !s.choice.facet_normals &&
                              s.choice.interpolation == Interpolation::Perspective &&
                              !s.choice.mistakes.unnormalized_at_pixel &&
                              !s.choice.mistakes.some_faces_flipped;
    prepare_interpolation(s.as<PerPixel>().jobs, s, g, visibility);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.groups.size(), 256), [&](const auto& range) {
        for (std::size_t r = range.begin(); r != range.end(); ++r) s.point_object[r] = s.groups[r].object;
        for (std::size_t r = range.begin(); r != range.end();) {
            if (!on_fast_path) {
                place_one_by_one(s, g, visibility, r, s.points[r]);
                ++r;
                continue;
            }
            const std::size_t count = s.blocks_of_one_object(r, std::min(range.end(), r + max_together));
            place_together(s, g, visibility, r, count);
            r += count;
        }
    });
}

}  // namespace glint
