// The surface under Pixels: place and normal of every visible pixel. The usual case, 16 pixels at once, by
// the same formulas as one pixel alone (sample.cpp); the rest one by one.

#include "renderer/pipeline/place_pixels.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <bit>

#include "renderer/pipeline/clip.h"

namespace glint {
namespace {

/// Corners of the triangle that a lane shows. False when the triangle had to be clipped: then its place wants
/// more digits than floats have.
bool take_face(FaceBlock& block, std::size_t lane, const ObjectGeometry& object, const ObjectNormals& normals,
               const Triangle& t) {
    std::uint32_t outside = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t position = object.mesh->corner_position[t.corner[k]];
        const ClipVertex& v = object.vertices[position];
        const glm::vec3& p = object.positions[position];
        const glm::vec3 n = normals.at_corner(t.corner[k]);
        outside |= v.outside;
        block.clip_x[k][lane] = v.x;
        block.clip_y[k][lane] = v.y;
        block.clip_w[k][lane] = v.w;
        block.x[k][lane] = p.x;
        block.y[k][lane] = p.y;
        block.z[k][lane] = p.z;
        block.nx[k][lane] = n.x;
        block.ny[k][lane] = n.y;
        block.nz[k][lane] = n.z;
    }
    return !(outside & needs_clipping);
}

/// All lanes of a run at once; false when some lane is none of the usual case. Lanes that the run leaves out
/// take the face of its first.
bool place_together(const Surface& s, const Geometry& g, const Visibility& visibility, const PixelRun& run,
                    PointBlock& out) {
    FaceBlock block;
    const ObjectGeometry& object = g.objects[run.object];
    const auto width = static_cast<std::uint32_t>(g.size.width);
    const auto first = static_cast<std::uint32_t>(std::countr_zero(run.mask));
    const auto x = static_cast<float>(run.first_pixel % width),
               y = static_cast<float>(run.first_pixel / width);
    block.width = static_cast<float>(g.size.width);
    block.height = static_cast<float>(g.size.height);
    for (std::uint32_t i = 0; i < block_size; ++i) {
        const std::uint32_t lane = run.mask >> i & 1u ? i : first, pixel = run.first_pixel + lane;
        block.at_x[i] = x + static_cast<float>(lane) + 0.5f;
        block.at_y[i] = y + 0.5f;
        block.facing[i] = s.choice.two_sided && visibility.back[pixel] ? -1.0f : 1.0f;
        if (!take_face(block, i, object, s.normals[run.object],
                       g.triangle(run.object, visibility.triangle_at(pixel))))
            return false;
    }
    return lighting_kernels().place(block, out);
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
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.runs.size(), 256), [&](const auto& range) {
        for (std::size_t r = range.begin(); r != range.end(); ++r) {
            s.point_object[r] = s.runs[r].object;
            if (!usual || !place_together(s, g, visibility, s.runs[r], s.points[r]))
                place_one_by_one(s, g, visibility, r, s.points[r]);
        }
    });
}

}  // namespace glint
