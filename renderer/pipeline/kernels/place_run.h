#pragma once
// Many pixels at once: where each one's ray meets its face, and the normal interpolated there.

#include "renderer/pipeline/kernels/faces_of_lanes.h"
#include "renderer/shading/interpolate.h"

namespace glint::inline GLINT_ISA {

/// Below this a blended normal counts as none: opposite corner normals can cancel.
inline constexpr float shortest_normal = 1e-6f;

/// Pixels k and up of a run that begins at (x, y). False when some lane is none of the usual case
/// (DrawingKernels::place).
template <Number F>
bool place_lanes(const PlaceJob& job, const std::uint32_t* seen, std::size_t k, int x, int y,
                 PointBlock& out) {
    using I = IntOf<F>;
    const I inverted = 0x7fffffff - load_ints<I>(seen + k);  // as seen_code made it
    const FacesOfLanes<F> face =
        faces_of_lanes<F>(job, (inverted >> 1) - static_cast<int>(job.first_triangle));
    const F at_x = to_number(load_ints<I>(counting + k) + x) + F(0.5f), at_y = to_number(y) + 0.5f;
    const ScreenPoint<F> at = screen_point(at_x, at_y, F(job.width), F(job.height));
    const Vec3<F> w = perspective_weights(face.a.clip, face.b.clip, face.c.clip, at);
    const Vec3<F> p = blend(w, face.a.p, face.b.p, face.c.p), sum = blend(w, face.a.n, face.b.n, face.c.n);
    const F facing = job.two_sided ? F(1) - to_number((inverted & 1) << 1) : F(1);
    const Vec3<F> n = facing * unit(sum);
    store(out.x + k, p.x);
    store(out.y + k, p.y);
    store(out.z + k, p.z);
    store(out.nx + k, n.x);
    store(out.ny + k, n.y);
    store(out.nz + k, n.z);
    const bool usual = !any(length(sum) <= F(shortest_normal));
    return usual && !face.clipped;
}

}  // namespace glint::inline GLINT_ISA
