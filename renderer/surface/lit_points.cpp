// The points that several pixels share: under flat shading one a face (SurfaceKind::Faces), under Gouraud the
// corners (SurfaceKind::Corners). renderer/shade/color_pixels.cpp blends their colours. Phong and facet light
// each pixel.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "models/memory_limit.h"
#include "renderer/surface/surface.h"

namespace glint {
namespace {

void number_items(LitPoints& lit, const Surface& s, const Geometry& g) {
    lit.first.assign(1, 0);
    for (std::size_t o = 0; o < g.objects.size(); ++o) {
        const Mesh& mesh = *g.objects[o].mesh;
        std::size_t items = mesh.face_count();
        if (s.choice.provoking) items = mesh.triangles.size();
        if (s.choice.kind == SurfaceKind::Corners) items = s.normals[o].slot_count();
        lit.first.push_back(lit.first.back() + 2 * items);
    }
    lit.seen.assign(lit.first.back(), 0);
    lit.point.assign(lit.first.back(), no_index);
}

/// Calls visit(group number, lane, blended points) for every pixel that shows a surface. `weighted`: with the
/// points' weights, for which the pixel has to be located on its face.
template <class Visit>
void visit_pixels(const Surface& s, const Geometry& g, const Visibility& visibility, bool weighted,
                  const Visit& visit) {
    tbb::parallel_for(std::size_t{0}, s.groups.size(), [&](std::size_t r) {
        for (unsigned i = 0; i < block_size; ++i) {
            if (!(s.groups[r].mask >> i & 1u)) continue;
            SampleFace face = face_of_lane(s, g, visibility, r, i);
            if (weighted) locate_on_face(face, g);
            visit(r, i, blended_points(s, g, face));
        }
    });
}

/// Gives the seen items of each object consecutive numbers, each object beginning a new block.
void number_seen(LitPoints& lit, Surface& s) {
    lit.shading_points.clear();
    s.point_object.clear();
    s.point_count = 0;
    for (std::uint32_t o = 0; o + 1 < lit.first.size(); ++o) {
        for (std::size_t i = lit.first[o]; i < lit.first[o + 1]; ++i) {
            if (!lit.seen[i]) continue;
            lit.point[i] = static_cast<std::uint32_t>(lit.shading_points.size());
            const std::size_t local = i - lit.first[o];
            lit.shading_points.push_back({o, static_cast<std::uint32_t>(local / 2), local % 2 != 0});
            ++s.point_count;
        }
        if (lit.shading_points.size() >= no_index - block_size)
            throw Refused({"", "", "more than 4294967279 corners are lit", "fewer, or a smaller picture"});
        while (lit.shading_points.size() % block_size) lit.shading_points.push_back({o, no_index, false});
        s.point_object.resize(lit.shading_points.size() / block_size, o);
    }
}

void place_points(const LitPoints& lit, Surface& s, const Geometry& g) {
    s.points.resize(s.point_object.size());
    tbb::parallel_for(std::size_t{0}, s.points.size(), [&](std::size_t b) {
        PointBlock block{};
        for (std::size_t i = 0; i < block_size; ++i) {
            const ShadingPoint& source = lit.shading_points[b * block_size + i];
            if (source.item != no_index) lit_point(s, g, source).put(block, i);
        }
        s.points[b] = block;
    });
}

/// Finds the lit points that the pixels show.
void find_lit_points(LitPoints& lit, Surface& s, const Geometry& g, const Visibility& visibility) {
    number_items(lit, s, g);
    // Perspective blends the three corners of a triangle wherever the pixel is.
    const bool weighted =
        s.choice.kind == SurfaceKind::Corners && s.choice.interpolation != Interpolation::Perspective;
    visit_pixels(s, g, visibility, weighted, [&lit](std::size_t, unsigned, const BlendedPoints& sample) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(sample.count); ++k)
            // Several threads may write the same 1.
            std::atomic_ref(lit.seen[lit.number(sample.point[k])]).store(1, std::memory_order_relaxed);
    });
    number_seen(lit, s);
    place_points(lit, s, g);
}

}  // namespace

void collect_lit_points(Surface& s, const Geometry& g, const Visibility& visibility) {
    if (s.choice.kind == SurfaceKind::Faces) {
        PerFace& faces = s.as<PerFace>();
        LitPoints& lit = faces.lit;
        std::vector<FaceRefs>& refs = faces.refs;
        find_lit_points(lit, s, g, visibility);
        refs.assign(s.groups.size(), FaceRefs{});
        return visit_pixels(s, g, visibility, false,
                            [&](std::size_t r, unsigned i, const BlendedPoints& sample) {
                                refs[r].point[i] = lit.point[lit.number(sample.point[0])];
                            });
    }
    PerVertex& vertices = s.as<PerVertex>();
    LitPoints& lit = vertices.lit;
    std::vector<std::uint32_t>& ref_point = vertices.ref_point;
    std::vector<float>& ref_weight = vertices.ref_weight;
    find_lit_points(lit, s, g, visibility);
    ref_point.assign(s.corner_ref(s.groups.size(), 0), 0);
    ref_weight.assign(ref_point.size(), 0);
    visit_pixels(s, g, visibility, true, [&](std::size_t r, unsigned i, const BlendedPoints& sample) {
        for (int k = 0; k < std::min(sample.count, max_blended(s.choice)); ++k) {
            const auto which = static_cast<std::size_t>(k);
            ref_point[s.corner_ref(r, k) + i] = lit.point[lit.number(sample.point[which])];
            ref_weight[s.corner_ref(r, k) + i] = sample.weight[which];
        }
    });
}

}  // namespace glint
