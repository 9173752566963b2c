// Anti-aliasing: each face that shows at some samples of a pixel is lit once in that pixel, and the pixel is
// their weighted mean. Where the samples are: sample_offset() in visibility.cpp.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "renderer/geometry/interpolate.h"
#include "renderer/surface/surface.h"

namespace glint {
namespace {

constexpr int max_samples = 8;

/// The surface at one sample.
struct SampleSeen {
    std::uint32_t object = 0, triangle = 0, face = 0;
    bool back = false;
};

/// One face in one pixel: its samples as bits, and the triangle and position at which it is lit.
struct Fragment {
    SampleSeen seen;
    unsigned samples = 0;
    PixelPosition at;
    float weight = 0;
    bool taken = false;
};

/// The faces of one pixel, in the order of their first samples.
struct PixelFragments {
    std::array<SampleSeen, max_samples> sample;
    std::array<Fragment, max_samples> fragment;
    int count = 0;
};

/// The depth of a screen position inside a triangle: the smallest of its corners' weights there, negative
/// outside.
double least_weight(const Geometry& g, const SampleSeen& seen, PixelPosition at) {
    const ObjectGeometry& object = g.objects[seen.object];
    std::array<ClipCorner<double>, 3> corner;
    const auto positions = g.position_indices(seen.object, g.triangle(seen.object, seen.triangle));
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 p(object.mesh->positions[positions[i]]);
        const glm::dvec4 c = object.clip_from_object * glm::dvec4(p, 1.0);
        corner[i] = {c.x, c.y, c.w};
    }
    const ScreenPoint<double> point = to_ndc<double>(at.x, at.y, g.size.width, g.size.height);
    const Vec3<double> e = edge_functions(corner[0], corner[1], corner[2], point);
    const double sum = e.x + e.y + e.z;
    return sum > 0 ? std::min({e.x, e.y, e.z}) / sum : -HUGE_VAL;
}

/// Finds, among the triangles that a face shows at its samples, the one that contains their mean, or is
/// nearest to it.
SampleSeen triangle_at_mean(const Geometry& g, const PixelFragments& pixel, const Fragment& f) {
    SampleSeen best = f.seen;
    double deepest = -HUGE_VAL;
    std::uint32_t tried = no_triangle;
    for (unsigned s = 0; s < max_samples; ++s) {
        const SampleSeen& sample = pixel.sample[s];
        if (!(f.samples >> s & 1u) || sample.triangle == tried) continue;
        tried = sample.triangle;
        const double depth = least_weight(g, sample, f.at);
        if (depth > deepest) best = sample;
        deepest = std::max(deepest, depth);
    }
    return best;
}

/// Whether a face shows several of its triangles.
bool is_divided(const PixelFragments& pixel, const Fragment& f) {
    for (unsigned s = 0; s < max_samples; ++s)
        if ((f.samples >> s & 1u) && pixel.sample[s].triangle != f.seen.triangle) return true;
    return false;
}

SampleSeen seen_at(const Geometry& g, const Visibility& visibility, std::size_t key) {
    SampleSeen seen;
    seen.triangle = visibility.triangle_at(key);
    if (seen.triangle == no_triangle) return seen;
    seen.object = g.object_of(seen.triangle);
    seen.face = g.triangle(seen.object, seen.triangle).face;
    seen.back = visibility.back_at(key);
    return seen;
}

PixelFragments fragments_of(const Geometry& g, const Visibility& visibility, std::size_t pixel, float x,
                            float y) {
    PixelFragments found;
    for (int s = 0; s < visibility.samples; ++s) {
        const SampleSeen seen =
            seen_at(g, visibility, static_cast<std::size_t>(s) * visibility.plane + pixel);
        if (seen.triangle == no_triangle) continue;
        found.sample[static_cast<std::size_t>(s)] = seen;
        const auto end = found.fragment.begin() + found.count;
        auto f = std::find_if(found.fragment.begin(), end, [&seen](const Fragment& other) {
            return other.seen.object == seen.object && other.seen.face == seen.face;
        });
        if (f == end) {
            f->seen = seen;
            ++found.count;
        }
        const SampleOffset offset = sample_offset(visibility.samples, s);
        f->samples |= 1u << s;
        f->at.x += static_cast<float>(offset.x);
        f->at.y += static_cast<float>(offset.y);
        f->weight += 1;
    }
    for (int i = 0; i < found.count; ++i) {
        Fragment& f = found.fragment[static_cast<std::size_t>(i)];
        f.at = {x + 0.5f + f.at.x / (f.weight * subpixels), y + 0.5f + f.at.y / (f.weight * subpixels)};
        f.weight /= static_cast<float>(visibility.samples);
        if (is_divided(found, f)) f.seen = triangle_at_mean(g, found, f);
    }
    return found;
}

/// Moves fragments of one object, at most one per pixel, into a group; returns false if none are left.
bool next_group(std::array<PixelFragments, block_size>& pixels, std::uint32_t first_pixel, PixelGroup& group,
                GroupSamples& samples) {
    group = {first_pixel, no_index, 0};
    samples = GroupSamples{};
    for (std::size_t i = 0; i < block_size; ++i) {
        for (int k = 0; k < pixels[i].count; ++k) {
            Fragment& f = pixels[i].fragment[static_cast<std::size_t>(k)];
            if (f.taken || (group.object != no_index && group.object != f.seen.object)) continue;
            f.taken = true;
            group.object = f.seen.object;
            group.mask = static_cast<std::uint16_t>(group.mask | 1u << i);
            samples.triangle[i] = f.seen.triangle;
            samples.weight[i] = f.weight;
            samples.at[i] = f.at;
            samples.back = static_cast<std::uint16_t>(samples.back | (f.seen.back ? 1u : 0u) << i);
            break;
        }
    }
    return group.mask != 0;
}

void find_row(const Geometry& g, const Visibility& visibility, int y, SampledRow& row) {
    row.groups.clear();
    row.samples.clear();
    row.pixels = 0;
    const auto width = static_cast<std::uint32_t>(g.size.width);
    const std::uint32_t begin = static_cast<std::uint32_t>(y) * width;
    for (std::uint32_t x0 = 0; x0 < width; x0 += block_size) {
        std::array<PixelFragments, block_size> pixels;
        for (std::uint32_t i = 0; i < std::min<std::uint32_t>(block_size, width - x0); ++i) {
            pixels[i] = fragments_of(g, visibility, begin + x0 + i, static_cast<float>(x0 + i),
                                     static_cast<float>(y));
            row.pixels += pixels[i].count > 0;
        }
        PixelGroup group;
        GroupSamples samples;
        while (next_group(pixels, begin + x0, group, samples)) {
            row.groups.push_back(group);
            row.samples.push_back(samples);
        }
    }
}

}  // namespace

void find_sampled_groups(Surface& s, const Geometry& g, const Visibility& visibility) {
    s.sampled_rows.resize(static_cast<std::size_t>(g.size.height));
    tbb::parallel_for(0, g.size.height, [&](int y) {
        SampledRow& row = s.sampled_rows[static_cast<std::size_t>(y)];
        find_row(g, visibility, y, row);
    });
    std::size_t count = 0;
    for (const SampledRow& row : s.sampled_rows) count += row.groups.size();
    s.groups.clear();
    s.groups.reserve(count);
    s.group_samples.clear();
    s.group_samples.reserve(count);
    s.pixel_count = 0;
    for (const SampledRow& row : s.sampled_rows) {
        s.groups.insert(s.groups.end(), row.groups.begin(), row.groups.end());
        s.group_samples.insert(s.group_samples.end(), row.samples.begin(), row.samples.end());
        s.pixel_count += row.pixels;
    }
}

}  // namespace glint
