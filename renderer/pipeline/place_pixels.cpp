// The surface under Pixels: place and normal of every visible pixel. The usual case, 16 pixels at once, by
// the same formulas as one pixel alone (sample.cpp); the rest one by one.

#include "renderer/pipeline/place_pixels.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <bit>
#include <cstddef>

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
    return job;
}

/// What the lanes of run `r` show; those that the run leaves out take its first.
void fill_faces(RunFaces& faces, const Surface& s, const Geometry& g, const Visibility& visibility,
                std::size_t r) {
    const PixelRun& run = s.runs[r];
    const auto width = static_cast<std::uint32_t>(g.size.width);
    const auto first = static_cast<std::uint32_t>(std::countr_zero(run.mask));
    const auto x = static_cast<float>(run.first_pixel % width),
               y = static_cast<float>(run.first_pixel / width) + 0.5f;
    const std::uint32_t first_triangle = g.objects[run.object].first_triangle;
    for (std::uint32_t i = 0; i < block_size; ++i) {
        const std::uint32_t lane = run.mask >> i & 1u ? i : first, pixel = run.first_pixel + lane;
        faces.triangle[i] = visibility.triangle_at(pixel) - first_triangle;
        faces.at_x[i] = x + static_cast<float>(lane) + 0.5f;
        faces.at_y[i] = y;
        faces.facing[i] = s.choice.two_sided && visibility.back[pixel] ? -1.0f : 1.0f;
    }
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
    s.point_count = 0;
    for (const PixelRun& run : s.runs) s.point_count += static_cast<std::uint64_t>(std::popcount(run.mask));
    const bool usual = s.run_samples.empty() && !s.choice.facet_normals &&
                       s.choice.interpolation == Interpolation::Perspective &&
                       !s.choice.mistakes.unnormalized_at_pixel;
    std::vector<PlaceJob> jobs;
    for (std::size_t o = 0; o < g.objects.size(); ++o)
        jobs.push_back(g.objects[o].mesh->triangles.empty() ? PlaceJob{} : place_job(s, g, o));
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.runs.size(), 256), [&](const auto& range) {
        RunFaces faces;
        for (std::size_t r = range.begin(); r != range.end(); ++r) {
            s.point_object[r] = s.runs[r].object;
            if (usual) fill_faces(faces, s, g, visibility, r);
            if (!usual || !drawing_kernels().place(jobs[s.runs[r].object], faces, s.points[r]))
                place_one_by_one(s, g, visibility, r, s.points[r]);
        }
    });
}

}  // namespace glint
