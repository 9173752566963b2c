#pragma once
// Many pixels at once: where each one's ray meets its face, and the normal interpolated there.

#include "renderer/geometry/interpolate.h"
#include "renderer/surface/faces_of_lanes.h"

namespace glint::inline GLINT_ISA {

/// Pixels k and up of a group that begins at (x, y) and shows `seen`: their places, and the normals before
/// they are made unit. False when some lane shows a clipped triangle.
template <Number F>
bool blend_lanes(const InterpolateJob& job, const std::uint32_t* seen, std::size_t k, int x, int y,
                 PointBlock& out) {
    using I = IntOf<F>;
    const I code = load_ints<I>(seen + k);
    const FacesOfLanes<F> face =
        faces_of_lanes<F>(job, triangle_of_code(code) - static_cast<int>(job.first_triangle));
    const F at_x = to_number(load_ints<I>(iota + k) + x) + F(0.5f), at_y = to_number(y) + 0.5f;
    const ScreenPoint<F> at = to_ndc(at_x, at_y, F(job.width), F(job.height));
    const Vec3<F> w = perspective_weights(face.a.clip, face.b.clip, face.c.clip, at);
    const Vec3<F> p = blend(w, face.a.p, face.b.p, face.c.p), sum = blend(w, face.a.n, face.b.n, face.c.n);
    const F facing = job.two_sided ? F(1) - to_number(back_of_code(code) << 1) : F(1);
    const Vec3<F> n = facing * sum;
    store(out.x + k, p.x);
    store(out.y + k, p.y);
    store(out.z + k, p.z);
    store(out.nx + k, n.x);
    store(out.ny + k, n.y);
    store(out.nz + k, n.z);
    return !face.clipped;
}

/// False when some normal is too short.
template <Number F> bool make_normals_unit(PointBlock& block) {
    bool long_enough = true;
    for (std::size_t k = 0; k < block_size; k += NumberTraits<F>::width) {
        const Vec3<F> sum{load<F>(block.nx + k), load<F>(block.ny + k), load<F>(block.nz + k)};
        const Vec3<F> n = unit(sum);
        store(block.nx + k, n.x);
        store(block.ny + k, n.y);
        store(block.nz + k, n.z);
        long_enough &= !any(length(sum) <= F(shortest_normal));
    }
    return long_enough;
}

/// What the pixels of a group show; those that it leaves out, what its first does: then in `filled`.
inline const std::uint32_t* seen_in_group(const InterpolateJob& job, const PixelGroup& group,
                                          std::uint32_t (&filled)[block_size]) {
    const std::uint32_t* seen = job.seen + group.first_pixel;
    if (group.mask == 0xFFFF) return seen;
    const std::uint32_t first = seen[__builtin_ctz(group.mask)];
    for (std::size_t i = 0; i < block_size; ++i) filled[i] = group.mask >> i & 1u ? seen[i] : first;
    return filled;
}

template <Number F>
void interpolate_groups(const InterpolateJob& job, const PixelGroup* groups, std::size_t count,
                        PointBlock* out, std::uint8_t* on_fast_path) {
    const auto row = static_cast<std::uint32_t>(job.width);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t filled[block_size];
        const std::uint32_t* seen = seen_in_group(job, groups[i], filled);
        const auto x = static_cast<int>(groups[i].first_pixel % row);
        const auto y = static_cast<int>(groups[i].first_pixel / row);
        bool all = true;
        for (std::size_t k = 0; k < block_size; k += NumberTraits<F>::width)
            all &= blend_lanes<F>(job, seen, k, x, y, out[i]);
        on_fast_path[i] = all;
        // One group behind: a root and a quotient that would otherwise be waited for.
        if (i > 0) on_fast_path[i - 1] &= make_normals_unit<F>(out[i - 1]);
    }
    if (count > 0) on_fast_path[count - 1] &= make_normals_unit<F>(out[count - 1]);
}

}  // namespace glint::inline GLINT_ISA
