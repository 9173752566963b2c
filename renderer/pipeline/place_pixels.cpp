// The surface under Pixels: place and normal of every visible pixel. The usual case, 16 pixels at once, by
// the same formulas as one pixel alone (sample.cpp); the rest one by one.

#include "renderer/pipeline/place_pixels.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <numeric>

#include "renderer/pipeline/clip.h"

namespace glint {
namespace {

// The kernels read a mesh's triangles as plain numbers.
static_assert(sizeof(Triangle) == 4 * sizeof(std::uint32_t) && offsetof(Triangle, corner) == 0);

PlaceJob place_job(const Surface& s, const Geometry& g, std::size_t o) {
    const ObjectGeometry& object = g.objects[o];
    PlaceJob job;
    job.vertices = object.vertices.data();
    job.normals = s.normals[o].normals.data();
    job.triangle_vertices = object.triangle_vertices.data();
    if (!s.normals[o].of_mesh.corner.empty()) {
        job.triangle_corners = object.mesh->triangles.front().corner.data();
        job.corner_normal = s.normals[o].of_mesh.corner.data();
    }
    job.width = static_cast<float>(g.size.width);
    job.height = static_cast<float>(g.size.height);
    job.clipped_bits = needs_clipping;
    job.first_triangle = object.first_triangle;
    job.two_sided = s.choice.two_sided;
    return job;
}

/// All pixels of a run at once; false when some are none of the usual case. Lanes that the run leaves out
/// take the face of its first.
bool place_together(const PlaceJob& job, const PixelRun& run, std::uint32_t width,
                    const Visibility& visibility, PointBlock& out) {
    const std::uint32_t* seen = &visibility.seen[run.first_pixel];
    std::array<std::uint32_t, block_size> filled;
    if (run.mask != 0xFFFF) {
        const auto first = static_cast<std::size_t>(std::countr_zero(run.mask));
        for (std::size_t i = 0; i < block_size; ++i) filled[i] = seen[run.mask >> i & 1u ? i : first];
        seen = filled.data();
    }
    return drawing_kernels().place(job, seen, static_cast<int>(run.first_pixel % width),
                                   static_cast<int>(run.first_pixel / width), out);
}

void place_one_by_one(const Surface& s, const Geometry& g, const Visibility& visibility, std::size_t run,
                      PointBlock& out) {
    out = {};
    for (unsigned i = 0; i < block_size; ++i) {
        if (s.runs[run].mask >> i & 1u) pixel_point(s, g, face_of_lane(s, g, visibility, run, i)).put(out, i);
    }
}

}  // namespace

void place_pixels(Surface& s, const Geometry& g, const Visibility& visibility) {
    s.points.resize(s.runs.size());
    s.point_object.resize(s.runs.size());
    s.point_count = s.pixel_count;
    if (!s.run_samples.empty())
        s.point_count = std::transform_reduce(
            s.runs.begin(), s.runs.end(), std::uint64_t{0}, std::plus<>(),
            [](const PixelRun& run) { return static_cast<std::uint64_t>(std::popcount(run.mask)); });
    const bool usual = s.run_samples.empty() && !s.choice.facet_normals &&
                       s.choice.interpolation == Interpolation::Perspective &&
                       !s.choice.mistakes.unnormalized_at_pixel;
    const auto width = static_cast<std::uint32_t>(g.size.width);
    s.place_jobs.clear();
    for (std::size_t o = 0; o < g.objects.size(); ++o)
        s.place_jobs.push_back(g.objects[o].mesh->triangles.empty() ? PlaceJob{} : place_job(s, g, o));
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.runs.size(), 256), [&](const auto& range) {
        for (std::size_t r = range.begin(); r != range.end(); ++r) {
            s.point_object[r] = s.runs[r].object;
            const PixelRun& run = s.runs[r];
            if (!usual || !place_together(s.place_jobs[run.object], run, width, visibility, s.points[r]))
                place_one_by_one(s, g, visibility, r, s.points[r]);
        }
    });
}

}  // namespace glint
