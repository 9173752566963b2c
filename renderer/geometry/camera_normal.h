#pragma once
// A normal on its way to camera coordinates, in doubles. One at a time (double) or side by side (Doubles).

#include "renderer/geometry/geometry_kernels.h"
#include "renderer/simd/double_lanes.h"
#include "renderer/simd/vec3.h"

namespace glint::inline GLINT_ISA {

/// Transforms a normal to camera coordinates; its length is what the matrix leaves.
template <Number D> Vec3<D> to_camera(const Matrix3& m, Vec3<D> n) {
    const auto row = [&](int r) {
        return D(m.column[0][r]) * n.x + D(m.column[1][r]) * n.y + D(m.column[2][r]) * n.z;
    };
    return {row(0), row(1), row(2)};
}

/// v / |v|, correctly rounded divisions; (0, 0, 0) stays so.
template <Number D> Vec3<D> unit_or_zero(Vec3<D> v) {
    const D length = square_root(dot(v, v));
    const auto any_length = length > D(0);
    const D divisor = select(any_length, length, D(1));
    return select<D>(any_length, Vec3<D>{v.x / divisor, v.y / divisor, v.z / divisor}, Vec3<D>{});
}

}  // namespace glint::inline GLINT_ISA
