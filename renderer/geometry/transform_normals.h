#pragma once
// Eight normals at once, made unit in camera coordinates.

#include "renderer/geometry/camera_normal.h"
#include "renderer/simd/transpose.h"

namespace glint::inline GLINT_ISA {

/// Eight from `first` on; those past the first `count` repeat the first.
template <Number F>
void eight_normals(const NormalJob& job, std::size_t first, std::size_t count, CameraNormal* out) {
    using D = typename HalfAsMany<F>::Type;
    constexpr int eight = 8;
    float n[3][eight], lists[4][eight] = {};
    transpose_triples(job.normals + 3 * first, count, n);
    for (int i = 0; i < eight; i += HalfAsMany<F>::width) {
        const Vec3<D> object{widened<D>(n[0] + i), widened<D>(n[1] + i), widened<D>(n[2] + i)};
        const Vec3<D> camera = unit_or_zero(to_camera(job.matrix, object));
        store_narrowed(lists[0] + i, camera.x);
        store_narrowed(lists[1] + i, camera.y);
        store_narrowed(lists[2] + i, camera.z);
    }
    store_transposed(lists, out, sizeof(CameraNormal));
}

/// The normals begin .. end - 1.
template <Number F> void transform_normals(const NormalJob& job, std::size_t begin, std::size_t end) {
    std::size_t first = begin;
    for (; end - first >= 8; first += 8) eight_normals<F>(job, first, 8, job.in_camera + first);
    if (first == end) return;
    CameraNormal rest[8];
    eight_normals<F>(job, first, end - first, rest);
    for (std::size_t i = 0; first + i < end; ++i) job.in_camera[first + i] = rest[i];
}

}  // namespace glint::inline GLINT_ISA
