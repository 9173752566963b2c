#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "models/memory_limit.h"
#include "renderer/surface/surface_points.h"

namespace glint {
namespace {

void number_items(Surface& s, const Geometry& g) {
    std::vector<std::size_t>& first = s.lit_items.first;
    first.assign(1, 0);
    for (std::size_t o = 0; o < g.objects.size(); ++o) {
        const Mesh& mesh = *g.objects[o].mesh;
        std::size_t items = mesh.face_count();
        if (s.choice.provoking) items = mesh.triangles.size();
        if (s.choice.kind == SurfaceKind::Corners) items = s.normals[o].slot_count();
        first.push_back(first.back() + 2 * items);
    }
    s.lit_items.seen.assign(first.back(), 0);
    s.lit_items.point.assign(first.back(), no_index);
}

/// Calls visit(group number, lane, sources) for every pixel that shows a surface.
template <class Visit>
void visit_pixels(const Surface& s, const Geometry& g, const Visibility& visibility, const Visit& visit) {
    tbb::parallel_for(std::size_t{0}, s.groups.size(), [&](std::size_t r) {
        for (unsigned i = 0; i < block_size; ++i)
            if (s.groups[r].mask >> i & 1u)
                visit(r, i, sample_sources(s, g, face_of_lane(s, g, visibility, r, i)));
    });
}

/// Gives the seen items of each object consecutive numbers, each object beginning a new block.
void number_seen(Surface& s) {
    const LitItems& items = s.lit_items;
    s.sources.clear();
    s.point_object.clear();
    s.point_count = 0;
    for (std::uint32_t o = 0; o + 1 < items.first.size(); ++o) {
        for (std::size_t i = items.first[o]; i < items.first[o + 1]; ++i) {
            if (!items.seen[i]) continue;
            s.lit_items.point[i] = static_cast<std::uint32_t>(s.sources.size());
            const std::size_t local = i - items.first[o];
            s.sources.push_back({o, static_cast<std::uint32_t>(local / 2), local % 2 != 0});
            ++s.point_count;
        }
        if (s.sources.size() >= no_index - block_size)
            throw Refused({"", "", "more than 4294967279 corners are lit", "fewer, or a smaller picture"});
        while (s.sources.size() % block_size) s.sources.push_back({o, no_index, false});
        s.point_object.resize(s.sources.size() / block_size, o);
    }
}

void place_points(Surface& s, const Geometry& g) {
    s.points.resize(s.point_object.size());
    tbb::parallel_for(std::size_t{0}, s.points.size(), [&](std::size_t b) {
        PointBlock block{};
        for (std::size_t i = 0; i < block_size; ++i) {
            const ShadingPoint& source = s.sources[b * block_size + i];
            if (source.item != no_index) lit_point(s, g, source).put(block, i);
        }
        s.points[b] = block;
    });
}

void refer_pixels(Surface& s, const Geometry& g, const Visibility& visibility) {
    const LitItems& items = s.lit_items;
    const bool corners = s.choice.kind == SurfaceKind::Corners;
    s.refs_per_pixel = max_blended(s.choice);
    const std::size_t refs = corners ? s.corner_ref(s.groups.size(), 0) : 0;
    s.ref_point.assign(refs, 0);
    s.ref_weight.assign(refs, 0);
    s.face_refs.assign(corners ? 0 : s.groups.size(), FaceRefs{});
    visit_pixels(s, g, visibility, [&](std::size_t r, unsigned i, const SampleSources& sample) {
        if (!corners) {
            s.face_refs[r].point[i] = items.point[items.number(sample.source[0])];
            return;
        }
        for (int k = 0; k < std::min(sample.count, s.refs_per_pixel); ++k) {
            s.ref_point[s.corner_ref(r, k) + i] =
                items.point[items.number(sample.source[static_cast<std::size_t>(k)])];
            s.ref_weight[s.corner_ref(r, k) + i] = sample.weight[static_cast<std::size_t>(k)];
        }
    });
}

}  // namespace

void collect_lit_points(Surface& s, const Geometry& g, const Visibility& visibility) {
    number_items(s, g);
    LitItems& items = s.lit_items;
    visit_pixels(s, g, visibility, [&](std::size_t, unsigned, const SampleSources& sample) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(sample.count);
             ++k)  // several threads may write the same 1
            std::atomic_ref(items.seen[items.number(sample.source[k])]).store(1, std::memory_order_relaxed);
    });
    number_seen(s);
    place_points(s, g);
    refer_pixels(s, g, visibility);
}

}  // namespace glint
