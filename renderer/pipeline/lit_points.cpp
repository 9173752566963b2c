#include "renderer/pipeline/lit_points.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace glint {
namespace {

/// A number for every possible lit point of the scene: objects one after the other, twice each item (turned
/// or not).
struct Numbering {
    std::vector<std::size_t> first;  // #objects + 1

    [[nodiscard]] std::size_t operator()(const PointSource& s) const {
        return first[s.object] + 2 * std::size_t{s.item} + (s.turned ? 1 : 0);
    }
};

Numbering number_items(const Surface& s, const Geometry& g) {
    Numbering n;
    n.first.push_back(0);
    for (std::size_t o = 0; o < g.objects.size(); ++o) {
        const Mesh& mesh = *g.objects[o].mesh;
        std::size_t items = mesh.face_count();
        if (s.choice.provoking) items = mesh.triangles.size();
        if (s.choice.kind == SurfaceKind::Corners) items = s.normals[o].slot_count();
        n.first.push_back(n.first.back() + 2 * items);
    }
    return n;
}

/// Calls visit(run number, lane, sources) for every pixel that shows a surface.
template <class Visit>
void visit_pixels(const Surface& s, const Geometry& g, const Visibility& visibility, const Visit& visit) {
    tbb::parallel_for(std::size_t{0}, s.runs.size(), [&](std::size_t r) {
        for (unsigned i = 0; i < block_size; ++i)
            if (s.runs[r].mask >> i & 1u)
                visit(r, i, sample_sources(s, g, face_of_lane(s, g, visibility, r, i)));
    });
}

/// Gives the seen items of each object consecutive numbers, each object beginning a new block. Returns, for
/// every possible item, its point's number (or no_index).
std::vector<std::uint32_t> number_seen(Surface& s, const Numbering& numbering,
                                       const std::vector<std::uint8_t>& seen) {
    std::vector<std::uint32_t> point(seen.size(), no_index);
    s.sources.clear();
    s.point_object.clear();
    s.point_count = 0;
    for (std::uint32_t o = 0; o + 1 < numbering.first.size(); ++o) {
        for (std::size_t i = numbering.first[o]; i < numbering.first[o + 1]; ++i) {
            if (!seen[i]) continue;
            point[i] = static_cast<std::uint32_t>(s.sources.size());
            const std::size_t local = i - numbering.first[o];
            s.sources.push_back({o, static_cast<std::uint32_t>(local / 2), local % 2 != 0});
            ++s.point_count;
        }
        while (s.sources.size() % block_size) s.sources.push_back({o, no_index, false});
        s.point_object.resize(s.sources.size() / block_size, o);
    }
    return point;
}

void place_points(Surface& s, const Geometry& g) {
    s.points.resize(s.point_object.size());
    tbb::parallel_for(std::size_t{0}, s.points.size(), [&](std::size_t b) {
        PointBlock block{};
        for (std::size_t i = 0; i < block_size; ++i) {
            const PointSource& source = s.sources[b * block_size + i];
            if (source.item != no_index) lit_point(s, g, source).put(block, i);
        }
        s.points[b] = block;
    });
}

void refer_pixels(Surface& s, const Geometry& g, const Visibility& visibility, const Numbering& numbering,
                  const std::vector<std::uint32_t>& point) {
    const bool corners = s.choice.kind == SurfaceKind::Corners;
    s.refs_per_pixel = s.choice.interpolation == Interpolation::Scanline ? CornerWeights::most : 3;
    const std::size_t refs = corners ? s.corner_ref(s.runs.size(), 0) : 0;
    s.ref_point.assign(refs, 0);
    s.ref_weight.assign(refs, 0);
    s.face_refs.assign(corners ? 0 : s.runs.size(), FaceRefs{});
    visit_pixels(s, g, visibility, [&](std::size_t r, unsigned i, const SampleSources& sample) {
        if (!corners) {
            s.face_refs[r].point[i] = point[numbering(sample.source[0])];
            return;
        }
        for (int k = 0; k < std::min(sample.count, s.refs_per_pixel); ++k) {
            s.ref_point[s.corner_ref(r, k) + i] =
                point[numbering(sample.source[static_cast<std::size_t>(k)])];
            s.ref_weight[s.corner_ref(r, k) + i] = sample.weight[static_cast<std::size_t>(k)];
        }
    });
}

}  // namespace

void place_lit_points(Surface& s, const Geometry& g, const Visibility& visibility) {
    const Numbering numbering = number_items(s, g);
    std::vector<std::uint8_t> seen(numbering.first.back(), 0);
    visit_pixels(s, g, visibility, [&](std::size_t, unsigned, const SampleSources& sample) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(sample.count);
             ++k)  // several threads may write the same 1
            std::atomic_ref(seen[numbering(sample.source[k])]).store(1, std::memory_order_relaxed);
    });
    const std::vector<std::uint32_t> point = number_seen(s, numbering, seen);
    place_points(s, g);
    refer_pixels(s, g, visibility, numbering, point);
}

}  // namespace glint
