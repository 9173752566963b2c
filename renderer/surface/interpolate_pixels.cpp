// The surface of kind Pixels: position and normal of every visible pixel. The fast path computes 16 pixels at
// once, with the same formulas as for a single pixel (surface.cpp). Other pixels are computed one by one.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <numeric>

#include "renderer/geometry/clip.h"
#include "renderer/surface/surface.h"

namespace glint {
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
