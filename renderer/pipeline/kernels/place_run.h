#pragma once
// Many pixels at once: where each one's ray meets its face, and the normal interpolated there.

#include "renderer/lighting/quads.h"
#include "renderer/pipeline/kernels/drawing_kernels.h"
#include "renderer/shading/interpolate.h"

namespace glint::inline GLINT_ISA {

/// Below this a blended normal counts as none: opposite corner normals can cancel.
inline constexpr float shortest_normal = 1e-6f;

/// One corner of the triangles that the lanes show.
template <Number F> struct CornerOfLanes {
    ClipCorner<F> clip;
    F outside;  // bits, not a number
    Vec3<F> p, n;
};

/// Corner `c` for lanes `k` and up.
template <Number F>
CornerOfLanes<F> corner_of_lanes(const PlaceJob& job, const RunFaces& run, std::size_t k, unsigned c) {
    constexpr int width = NumberTraits<F>::width;
    constexpr unsigned vertex_floats = sizeof(PlacedVertex) / sizeof(float);
    constexpr unsigned normal_floats = sizeof(CameraNormal) / sizeof(float);
    unsigned vertex[width], normal[width];
    for (unsigned i = 0; i < width; ++i)
        vertex[i] = job.triangle_vertices[3 * std::size_t{run.triangle[k + i]} + c];
    const Quad<F> clip = load_quads<F>(&job.vertices->clip_x, vertex, vertex_floats);
    const Quad<F> p = load_quads<F>(&job.vertices->x, vertex, vertex_floats);
    if (job.corner_normal)
        for (unsigned i = 0; i < width; ++i)
            normal[i] = job.corner_normal[job.triangle_corners[4 * std::size_t{run.triangle[k + i]} + c]];
    const Quad<F> n = load_quads<F>(&job.normals->x, job.corner_normal ? normal : vertex, normal_floats);
    return {{clip.a, clip.b, clip.c}, clip.d, {p.a, p.b, p.c}, {n.a, n.b, n.c}};
}

/// Lanes `k` and up of a run. False when some lane is none of the usual case (DrawingKernels::place).
template <Number F>
bool place_lanes(const PlaceJob& job, const RunFaces& run, std::size_t k, PointBlock& out) {
    const CornerOfLanes<F> a = corner_of_lanes<F>(job, run, k, 0), b = corner_of_lanes<F>(job, run, k, 1),
                           c = corner_of_lanes<F>(job, run, k, 2);
    const auto outside = bits_of(a.outside) | bits_of(b.outside) | bits_of(c.outside);
    if (any_bit(outside & static_cast<int>(job.clipped_bits))) return false;
    const ScreenPoint<F> at =
        screen_point(load<F>(run.at_x + k), load<F>(run.at_y + k), F(job.width), F(job.height));
    const Vec3<F> w = perspective_weights(a.clip, b.clip, c.clip, at);
    const Vec3<F> p = blend(w, a.p, b.p, c.p), sum = blend(w, a.n, b.n, c.n);
    const Vec3<F> n = load<F>(run.facing + k) * unit(sum);
    store(out.x + k, p.x);
    store(out.y + k, p.y);
    store(out.z + k, p.z);
    store(out.nx + k, n.x);
    store(out.ny + k, n.y);
    store(out.nz + k, n.z);
    return !any(length(sum) <= F(shortest_normal));
}

}  // namespace glint::inline GLINT_ISA
