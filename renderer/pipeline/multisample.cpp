#include "renderer/pipeline/multisample.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace glint {
namespace {

constexpr int most_samples = 8;

/// One face in one pixel.
struct Fragment {
    std::uint32_t object = 0, triangle = 0;
    SamplePlace at;
    float weight = 0;
    bool back = false, taken = false;
};

/// The faces of one pixel, in the order of their first samples.
struct PixelFragments {
    std::array<Fragment, most_samples> fragment;
    int count = 0;
};

PixelFragments fragments_of(const Geometry& g, const Visibility& visibility, std::size_t pixel, float x,
                            float y) {
    PixelFragments found;
    for (int s = 0; s < visibility.samples; ++s) {
        const std::size_t key = static_cast<std::size_t>(s) * visibility.plane + pixel;
        const std::uint32_t triangle = visibility.triangle_at(key);
        if (triangle == no_triangle) continue;
        const auto end = found.fragment.begin() + found.count;
        auto f = std::find_if(found.fragment.begin(), end,
                              [triangle](const Fragment& other) { return other.triangle == triangle; });
        if (f == end) {
            *f = {g.object_of(triangle), triangle, {0, 0}, 0, visibility.back_at(key), false};
            ++found.count;
        }
        const SampleOffset offset = sample_offset(visibility.samples, s);
        f->at.x += static_cast<float>(offset.x);
        f->at.y += static_cast<float>(offset.y);
        f->weight += 1;
    }
    for (int i = 0; i < found.count; ++i) {
        Fragment& f = found.fragment[static_cast<std::size_t>(i)];
        f.at = {x + 0.5f + f.at.x / (f.weight * subpixels), y + 0.5f + f.at.y / (f.weight * subpixels)};
        f.weight /= static_cast<float>(visibility.samples);
    }
    return found;
}

/// Takes fragments of one object, at most one a pixel, into a run; false when none is left.
bool next_run(std::array<PixelFragments, block_size>& pixels, std::uint32_t first_pixel, PixelRun& run,
              RunSamples& samples) {
    run = {first_pixel, no_index, 0};
    samples = RunSamples{};
    for (std::size_t i = 0; i < block_size; ++i) {
        for (int k = 0; k < pixels[i].count; ++k) {
            Fragment& f = pixels[i].fragment[static_cast<std::size_t>(k)];
            if (f.taken || (run.object != no_index && run.object != f.object)) continue;
            f.taken = true;
            run.object = f.object;
            run.mask = static_cast<std::uint16_t>(run.mask | 1u << i);
            samples.triangle[i] = f.triangle;
            samples.weight[i] = f.weight;
            samples.at[i] = f.at;
            samples.back = static_cast<std::uint16_t>(samples.back | (f.back ? 1u : 0u) << i);
            break;
        }
    }
    return run.mask != 0;
}

struct Row {
    std::vector<PixelRun> runs;
    std::vector<RunSamples> samples;
    std::uint64_t pixels = 0;
};

Row row_of(const Geometry& g, const Visibility& visibility, int y) {
    Row row;
    const auto width = static_cast<std::uint32_t>(g.size.width);
    const std::uint32_t begin = static_cast<std::uint32_t>(y) * width;
    for (std::uint32_t x0 = 0; x0 < width; x0 += block_size) {
        std::array<PixelFragments, block_size> pixels;
        for (std::uint32_t i = 0; i < std::min<std::uint32_t>(block_size, width - x0); ++i) {
            pixels[i] = fragments_of(g, visibility, begin + x0 + i, static_cast<float>(x0 + i),
                                     static_cast<float>(y));
            row.pixels += pixels[i].count > 0;
        }
        PixelRun run;
        RunSamples samples;
        while (next_run(pixels, begin + x0, run, samples)) {
            row.runs.push_back(run);
            row.samples.push_back(samples);
        }
    }
    return row;
}

}  // namespace

void find_sampled_runs(Surface& s, const Geometry& g, const Visibility& visibility) {
    std::vector<Row> rows(static_cast<std::size_t>(g.size.height));
    tbb::parallel_for(0, g.size.height,
                      [&](int y) { rows[static_cast<std::size_t>(y)] = row_of(g, visibility, y); });
    s.runs.clear();
    s.run_samples.clear();
    s.pixel_count = 0;
    for (const Row& row : rows) {
        s.runs.insert(s.runs.end(), row.runs.begin(), row.runs.end());
        s.run_samples.insert(s.run_samples.end(), row.samples.begin(), row.samples.end());
        s.pixel_count += row.pixels;
    }
}

}  // namespace glint
