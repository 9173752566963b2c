#pragma once
// Transforms vertices to the screen and normals to camera coordinates, eight at a time.

#include "renderer/geometry/vertex_transform.h"
#include "renderer/simd/transpose.h"

namespace glint::inline GLINT_ISA {

inline constexpr int together = 8;  // a multiple of every vector width of doubles

/// Transformed vertices as arrays of numbers, in the order of the members of TransformedVertex (in two
/// halves) and ScreenVertex.
struct VertexLists {
    float clip[4][together], camera[4][together] = {}, screen[4][together];
};

/// Transforms as many vertices as D has lanes, starting at i. `p`: object coordinates.
template <Number D>
void transform_lanes(const VertexJob& job, const float (&p)[3][together], int i, VertexLists& out) {
    const Point4<D> object{widened<D>(p[0] + i), widened<D>(p[1] + i), widened<D>(p[2] + i), D(1)};
    const Point4<D> camera = transformed(job.view_from_object, object);
    const Point4<D> clip = transformed(job.clip_from_view, camera);
    const Outside<D> outside = outside_of(clip);
    const GridPoint<D> at = grid_point(job.viewport, clip);
    const auto whole = outside.cut <= D(0);  // otherwise it has no position on the grid
    store_narrowed(out.clip[0] + i, clip.x);
    store_narrowed(out.clip[1] + i, clip.y);
    store_narrowed(out.clip[2] + i, clip.w);
    store_truncated(out.clip[3] + i, outside.sides + outside.cut);
    store_narrowed(out.camera[0] + i, camera.x);
    store_narrowed(out.camera[1] + i, camera.y);
    store_narrowed(out.camera[2] + i, camera.z);
    store_truncated(out.screen[0] + i, nearest(select(whole, at.x, D(0))));
    store_truncated(out.screen[1] + i, nearest(select(whole, at.y, D(0))));
    store_narrowed(out.screen[2] + i, select(whole, at.inv_w, D(0)));
    store_truncated(out.screen[3] + i, outside.sides + outside.cut);
}

/// Transforms eight vertices, starting at `first`. Entries past the first `count` repeat the first.
template <Number F>
void transform_eight(const VertexJob& job, std::size_t first, std::size_t count, TransformedVertex* vertices,
                     ScreenVertex* on_screen) {
    float p[3][together];
    transpose_triples(job.positions + 3 * first, count, p);
    VertexLists lists;
    for (int i = 0; i < together; i += HalfAsMany<F>::width)
        transform_lanes<typename HalfAsMany<F>::Type>(job, p, i, lists);
    store_transposed(lists.clip, vertices, sizeof(TransformedVertex));
    store_transposed(lists.camera, &vertices->x, sizeof(TransformedVertex));
    store_transposed(lists.screen, on_screen, sizeof(ScreenVertex));
}

/// Transforms the vertices begin .. end - 1.
template <Number F> void transform_all_vertices(const VertexJob& job, std::size_t begin, std::size_t end) {
    std::size_t first = begin;
    for (; end - first >= together; first += together)
        transform_eight<F>(job, first, together, job.vertices + first, job.on_screen + first);
    if (first == end) return;
    TransformedVertex vertices[together];
    ScreenVertex on_screen[together];
    transform_eight<F>(job, first, end - first, vertices, on_screen);
    for (std::size_t i = 0; first + i < end; ++i) {
        job.vertices[first + i] = vertices[i];
        job.on_screen[first + i] = on_screen[i];
    }
}

/// Transforms eight normals, starting at `first`. Entries past the first `count` repeat the first.
template <Number F>
void eight_normals(const NormalJob& job, std::size_t first, std::size_t count, CameraNormal* out) {
    using D = typename HalfAsMany<F>::Type;
    float n[3][together], lists[4][together] = {};
    transpose_triples(job.normals + 3 * first, count, n);
    for (int i = 0; i < together; i += HalfAsMany<F>::width) {
        const Vec3<D> object{widened<D>(n[0] + i), widened<D>(n[1] + i), widened<D>(n[2] + i)};
        const Vec3<D> camera = unit_or_zero(to_camera(job.matrix, object));
        store_narrowed(lists[0] + i, camera.x);
        store_narrowed(lists[1] + i, camera.y);
        store_narrowed(lists[2] + i, camera.z);
    }
    store_transposed(lists, out, sizeof(CameraNormal));
}

/// Transforms the normals begin .. end - 1.
template <Number F> void transform_normals(const NormalJob& job, std::size_t begin, std::size_t end) {
    std::size_t first = begin;
    for (; end - first >= together; first += together)
        eight_normals<F>(job, first, together, job.in_camera + first);
    if (first == end) return;
    CameraNormal rest[together];
    eight_normals<F>(job, first, end - first, rest);
    for (std::size_t i = 0; first + i < end; ++i) job.in_camera[first + i] = rest[i];
}

}  // namespace glint::inline GLINT_ISA
