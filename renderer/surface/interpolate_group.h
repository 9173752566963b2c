#pragma once
// Interpolates many pixels at once: intersects each pixel's ray with its face and computes the normal there.

#include "renderer/geometry/interpolate.h"
#include "renderer/simd/int_lanes.h"
#include "renderer/simd/transpose.h"
#include "renderer/surface/surface_kernels.h"

namespace glint::inline GLINT_ISA {

// The corners of the triangles visible at neighbouring pixels, one triangle per lane. If there are few
// different triangles, each is looked up once and copied to its lanes. Otherwise they are looked up lane by
// lane.

/// One corner of each lane's triangle: its screen position, and its position and normal in camera
/// coordinates.
template <Number F> struct CornerOfLanes {
    ClipCorner<F> clip;
    Vec3<F> p, n;
};
template <Number F> struct FacesOfLanes {
    CornerOfLanes<F> a, b, c;
    bool clipped = false;  // whether some of them are clipped
};

/// The records of a corner: its position and its normal. `triangle`: number within the object.
struct CornerRecords {
    const TransformedVertex* vertex;
    const CameraNormal* normal;
};
inline CornerRecords corner_records(const InterpolateJob& job, unsigned triangle, unsigned c) {
    const unsigned vertex = job.triangle_vertices[3 * std::size_t{triangle} + c];
    const unsigned normal =
        job.corner_normal ? job.corner_normal[job.triangle_corners[4 * std::size_t{triangle} + c]] : vertex;
    return {job.vertices + vertex, job.normals + normal};
}

/// Loads corner `c`. put(old, value) selects the lanes that receive each of its numbers.
template <Number F, class Put>
void put_corner(const InterpolateJob& job, unsigned triangle, unsigned c, CornerOfLanes<F>& out,
                bool& clipped, const Put& put) {
    const CornerRecords corner = corner_records(job, triangle, c);
    const TransformedVertex& v = *corner.vertex;
    const CameraNormal& n = *corner.normal;
    out = {{put(out.clip.x, v.clip_x), put(out.clip.y, v.clip_y), put(out.clip.w, v.clip_w)},
           {put(out.p.x, v.x), put(out.p.y, v.y), put(out.p.z, v.z)},
           {put(out.n.x, n.x), put(out.n.y, n.y), put(out.n.z, n.z)}};
    clipped |= (v.outside & job.clipped_bits) != 0;
}
template <Number F, class Put>
void put_face(const InterpolateJob& job, unsigned triangle, FacesOfLanes<F>& out, const Put& put) {
    put_corner(job, triangle, 0, out.a, out.clipped, put);
    put_corner(job, triangle, 1, out.b, out.clipped, put);
    put_corner(job, triangle, 2, out.c, out.clipped, put);
}

/// Loads corner `c` of each lane's own triangle.
template <Number F>
CornerOfLanes<F> take_corner(const InterpolateJob& job, const unsigned* triangle, unsigned c, bool& clipped) {
    constexpr int width = NumberTraits<F>::width;
    if constexpr (width == 1) {
        CornerOfLanes<F> corner;
        put_corner(job, triangle[0], c, corner, clipped, [](F, float from) { return from; });
        return corner;
    } else {
        using T = transposing::Rows<width>;
        typename T::V clip[4], p[4], n[4];
        const auto take_rows = [&](int k) {  // lanes k, k + 4, ...
            const char *vertex[width / 4], *normal[width / 4];
            for (int row = 0; row < width / 4; ++row) {
                const CornerRecords corner = corner_records(job, triangle[k + 4 * row], c);
                vertex[row] = reinterpret_cast<const char*>(corner.vertex);
                normal[row] = reinterpret_cast<const char*>(corner.normal);
            }
            clip[k] = T::rows(vertex, 0);
            p[k] = T::rows(vertex, 16);
            n[k] = T::rows(normal, 0);
        };
        take_rows(0);  // separate calls, to keep the rows in registers
        take_rows(1);
        take_rows(2);
        take_rows(3);
        const Columns<F> clips = transposing::transposed<F>(clip), ps = transposing::transposed<F>(p),
                         ns = transposing::transposed<F>(n);
        clipped |= any_bit(bits_of(clips.d) & static_cast<int>(job.clipped_bits));
        return {{clips.a, clips.b, clips.c}, {ps.a, ps.b, ps.c}, {ns.a, ns.b, ns.c}};
    }
}

/// If a group contains more triangles than this, lookup lane by lane is faster.
inline constexpr int max_looked_up_once = 4;

/// Loads the corners of each lane's triangle. `triangles`: numbers within the object.
template <Number F> FacesOfLanes<F> faces_of_lanes(const InterpolateJob& job, IntOf<F> triangles) {
    constexpr int width = NumberTraits<F>::width;
    unsigned number[width];
    store_ints(number, triangles);
    FacesOfLanes<F> faces;
    unsigned changes = mask_bits(not_equal(triangles, slide1up(triangles)));  // bit i: a run begins at lane i
    if (width == 1 || __builtin_popcount(changes) > max_looked_up_once) {
        faces.a = take_corner<F>(job, number, 0, faces.clipped);
        faces.b = take_corner<F>(job, number, 1, faces.clipped);
        faces.c = take_corner<F>(job, number, 2, faces.clipped);
        return faces;
    }
    put_face(job, number[0], faces, [](F, float of_corner) { return F(of_corner); });
    for (; changes; changes &= changes - 1) {
        const int first = __builtin_ctz(changes);
        const auto before = first_n<F>(first);
        put_face(job, number[first], faces,
                 [&before](F lanes, float of_corner) { return select(before, lanes, F(of_corner)); });
    }
    return faces;
}

/// The centres, in NDC, of consecutive pixels starting at pixel k of a group that begins at pixel (x, y).
template <Number F> ScreenPoint<F> centers_of_lanes(const InterpolateJob& job, std::size_t k, int x, int y) {
    const F at_x = to_number(load_ints<IntOf<F>>(iota + k) + x) + F(0.5f), at_y = to_number(y) + 0.5f;
    return to_ndc(at_x, at_y, F(job.width), F(job.height));
}

/// Interpolates position and normal (not yet normalized) of consecutive pixels, starting at pixel k of a
/// group that begins at (x, y) and shows `seen`. Returns false if any lane shows a clipped triangle.
template <Number F>
bool blend_lanes(const InterpolateJob& job, const std::uint32_t* seen, std::size_t k, int x, int y,
                 PointBlock& out) {
    using I = IntOf<F>;
    const I code = load_ints<I>(seen + k);
    const FacesOfLanes<F> face =
        faces_of_lanes<F>(job, triangle_of_code(code) - static_cast<int>(job.first_triangle));
    const Vec3<F> w =
        perspective_weights(face.a.clip, face.b.clip, face.c.clip, centers_of_lanes<F>(job, k, x, y));
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

/// Computes the corners' weights at the same pixels. `out` is the destination of the first corner's weight
/// for pixel k. Returns false if any lane shows a clipped triangle.
template <Number F>
bool weigh_lanes(const InterpolateJob& job, const std::uint32_t* seen, std::size_t k, int x, int y,
                 float* out) {
    const auto triangles = triangle_of_code(load_ints<IntOf<F>>(seen + k));
    const FacesOfLanes<F> face = faces_of_lanes<F>(job, triangles - static_cast<int>(job.first_triangle));
    const Vec3<F> w =
        perspective_weights(face.a.clip, face.b.clip, face.c.clip, centers_of_lanes<F>(job, k, x, y));
    store(out, w.x);
    store(out + block_size, w.y);
    store(out + 2 * block_size, w.z);
    return !face.clipped;
}

/// Normalizes the normals. Returns false if any of them is too short.
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

/// Returns the codes of the 16 pixels. Pixels outside the group receive the code of its first pixel, using
/// `filled` as memory.
inline const std::uint32_t* seen_in_group(const InterpolateJob& job, const PixelGroup& group,
                                          std::uint32_t (&filled)[block_size]) {
    const std::uint32_t* seen = job.seen + group.first_pixel;
    if (group.mask == 0xFFFF) return seen;
    const std::uint32_t first = seen[__builtin_ctz(group.mask)];
    for (std::size_t i = 0; i < block_size; ++i) filled[i] = group.mask >> i & 1u ? seen[i] : first;
    return filled;
}

/// The pixel at which a group of 16 pixels begins.
struct GroupPlace {
    int x, y;
};
inline GroupPlace place_of(const InterpolateJob& job, const PixelGroup& group) {
    const auto row = static_cast<std::uint32_t>(job.width);
    return {static_cast<int>(group.first_pixel % row), static_cast<int>(group.first_pixel / row)};
}

/// Implements SurfaceKernels::weigh.
template <Number F>
void weigh_groups(const InterpolateJob& job, const PixelGroup* groups, std::size_t count, float* out,
                  std::uint8_t* on_fast_path) {
    for (std::size_t i = 0; i < count; ++i, out += 3 * block_size) {
        std::uint32_t filled[block_size];
        const std::uint32_t* seen = seen_in_group(job, groups[i], filled);
        const GroupPlace at = place_of(job, groups[i]);
        bool all = true;
        for (std::size_t k = 0; k < block_size; k += NumberTraits<F>::width)
            all &= weigh_lanes<F>(job, seen, k, at.x, at.y, out + k);
        on_fast_path[i] = all;
    }
}

template <Number F>
void interpolate_groups(const InterpolateJob& job, const PixelGroup* groups, std::size_t count,
                        PointBlock* out, std::uint8_t* on_fast_path) {
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t filled[block_size];
        const std::uint32_t* seen = seen_in_group(job, groups[i], filled);
        const GroupPlace at = place_of(job, groups[i]);
        bool all = true;
        for (std::size_t k = 0; k < block_size; k += NumberTraits<F>::width)
            all &= blend_lanes<F>(job, seen, k, at.x, at.y, out[i]);
        on_fast_path[i] = all;
        // Software pipelining, depth 1: hides the latency of the square root and the division.
        if (i > 0) on_fast_path[i - 1] &= make_normals_unit<F>(out[i - 1]);
    }
    if (count > 0) on_fast_path[count - 1] &= make_normals_unit<F>(out[count - 1]);
}

}  // namespace glint::inline GLINT_ISA
