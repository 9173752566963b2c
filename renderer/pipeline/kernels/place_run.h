#pragma once
// Many pixels at once: where each one's ray meets its face, and the normal interpolated there.

#include "renderer/lighting/quads.h"
#include "renderer/lighting/whole_numbers.h"
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

/// Corner `c` of one triangle (number within the object) for each lane.
template <Number F>
CornerOfLanes<F> corner_of_lanes(const PlaceJob& job, const unsigned* triangle, unsigned c) {
    constexpr unsigned width = NumberTraits<F>::width;
    unsigned vertex[width], normal[width];
    for (unsigned i = 0; i < width; ++i) vertex[i] = job.triangle_vertices[3 * std::size_t{triangle[i]} + c];
    const Quad<F> clip = load_quads<F>(&job.vertices->clip_x, vertex, sizeof(PlacedVertex));
    const Quad<F> p = load_quads<F>(&job.vertices->x, vertex, sizeof(PlacedVertex));
    if (job.corner_normal)
        for (unsigned i = 0; i < width; ++i)
            normal[i] = job.corner_normal[job.triangle_corners[4 * std::size_t{triangle[i]} + c]];
    const Quad<F> n = load_quads<F>(job.normals, job.corner_normal ? normal : vertex, sizeof(CameraNormal));
    return {{clip.a, clip.b, clip.c}, clip.d, {p.a, p.b, p.c}, {n.a, n.b, n.c}};
}

/// Pixels k and up of a run that begins at (x, y). False when some lane is none of the usual case
/// (DrawingKernels::place).
template <Number F>
bool place_lanes(const PlaceJob& job, const std::uint32_t* seen, std::size_t k, int x, int y,
                 PointBlock& out) {
    using I = IntOf<F>;
    const I inverted = 0x7fffffff - load_ints<I>(seen + k);  // as seen_code made it
    unsigned triangle[NumberTraits<F>::width];
    store_ints(triangle, (inverted >> 1) - static_cast<int>(job.first_triangle));
    const auto a = corner_of_lanes<F>(job, triangle, 0), b = corner_of_lanes<F>(job, triangle, 1),
               c = corner_of_lanes<F>(job, triangle, 2);
    const I outside = bits_of(a.outside) | bits_of(b.outside) | bits_of(c.outside);
    if (any_bit(outside & static_cast<int>(job.clipped_bits))) return false;
    const F at_x = to_number(load_ints<I>(counting + k) + x) + F(0.5f), at_y = to_number(y) + 0.5f;
    const ScreenPoint<F> at = screen_point(at_x, at_y, F(job.width), F(job.height));
    const Vec3<F> w = perspective_weights(a.clip, b.clip, c.clip, at);
    const Vec3<F> p = blend(w, a.p, b.p, c.p), sum = blend(w, a.n, b.n, c.n);
    const F facing = job.two_sided ? F(1) - to_number((inverted & 1) << 1) : F(1);
    const Vec3<F> n = facing * unit(sum);
    store(out.x + k, p.x);
    store(out.y + k, p.y);
    store(out.z + k, p.z);
    store(out.nx + k, n.x);
    store(out.ny + k, n.y);
    store(out.nz + k, n.z);
    return !any(length(sum) <= F(shortest_normal));
}

}  // namespace glint::inline GLINT_ISA
