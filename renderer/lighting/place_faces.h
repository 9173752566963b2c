#pragma once
// Many pixels at once: where each one's ray meets its face, and the normal interpolated there.

#include "renderer/lighting/light_job.h"
#include "renderer/shading/interpolate.h"

namespace glint::inline GLINT_ISA {

/// Below this a blended normal counts as none: opposite corner normals can cancel.
inline constexpr float shortest_normal = 1e-6f;

/// Lanes `k` and up of a block. False when the normal of some lane is too short: such a lane wants the
/// facet's.
template <Number F> bool place_faces(const FaceBlock& in, std::size_t k, PointBlock& out) {
    using Corners = const float(&)[3][block_size];
    const auto corner = [k](Corners x, Corners y, Corners z, int c) {
        return Vec3<F>{load<F>(x[c] + k), load<F>(y[c] + k), load<F>(z[c] + k)};
    };
    const auto clip = [k, &in](int c) {
        return ClipCorner<F>{load<F>(in.clip_x[c] + k), load<F>(in.clip_y[c] + k), load<F>(in.clip_w[c] + k)};
    };
    const ScreenPoint<F> at =
        screen_point(load<F>(in.at_x + k), load<F>(in.at_y + k), F(in.width), F(in.height));
    const Vec3<F> w = perspective_weights(clip(0), clip(1), clip(2), at);
    const Vec3<F> p =
        blend(w, corner(in.x, in.y, in.z, 0), corner(in.x, in.y, in.z, 1), corner(in.x, in.y, in.z, 2));
    const Vec3<F> sum = blend(w, corner(in.nx, in.ny, in.nz, 0), corner(in.nx, in.ny, in.nz, 1),
                              corner(in.nx, in.ny, in.nz, 2));
    store(out.x + k, p.x);
    store(out.y + k, p.y);
    store(out.z + k, p.z);
    const Vec3<F> n = load<F>(in.facing + k) * unit(sum);
    store(out.nx + k, n.x);
    store(out.ny + k, n.y);
    store(out.nz + k, n.z);
    return !any(length(sum) <= F(shortest_normal));
}

}  // namespace glint::inline GLINT_ISA
