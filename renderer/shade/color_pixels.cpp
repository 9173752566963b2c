// Computes pixels from lit points. Phong and facet shading have one point per pixel, Gouraud blends corners,
// flat shading uses the point of the face. Then applies strokes, exposure and conversion to bytes.
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "renderer/shade/lighting.h"
#include "renderer/simd/lanes.h"

namespace glint {
namespace {

static_assert(batch_size == block_size,
              "GroupsToDo and BoundsBlock hold as many groups as a block has points");

/// 16 pixels with the same colour.
struct UniformBlock {
    ColorBlock color;
    std::array<std::uint32_t, block_size> rgba{};

    UniformBlock(const glm::vec3& c, const DisplayJob& display) {
        std::fill_n(color.r, block_size, c.x);
        std::fill_n(color.g, block_size, c.y);
        std::fill_n(color.b, block_size, c.z);
        lighting_kernels().encode(display, &color, rgba.data(), 1);
    }
};

void write_group(Lighting& l, const PixelGroup& group, const ColorBlock& color, const std::uint32_t* rgba) {
    if (group.mask == 0xFFFF && !l.linear) {  // the typical case
        std::memcpy(&l.picture.rgba[4 * std::size_t{group.first_pixel}], rgba, 4 * block_size);
        return;
    }
    for (std::size_t i = 0; i < block_size; ++i) {
        if (!(group.mask >> i & 1u)) continue;
        std::memcpy(&l.picture.rgba[4 * (group.first_pixel + i)], &rgba[i], 4);
        if (!l.linear) continue;
        float* to = &l.picture.linear[3 * (group.first_pixel + i)];
        to[0] = color.r[i];
        to[1] = color.g[i];
        to[2] = color.b[i];
    }
}

/// Computes the colours of `count` groups, starting at `first`.
void color_groups(Lighting& l, const Surface& s, std::size_t first, std::size_t count, ColorBlock* colors) {
    const ColorRecord* lit = l.point_colors.data();
    if (const auto* faces = std::get_if<PerFace>(&s.kept))
        return shade_kernels().pick(lit, faces->refs[first].point, colors, count);
    if (const auto* vertices = std::get_if<PerVertex>(&s.kept)) {
        const std::size_t ref = s.corner_ref(first, 0);
        return shade_kernels().blend(lit, &vertices->ref_point[ref], &vertices->ref_weight[ref],
                                     max_blended(s.choice), colors, count);
    }
    light_points(l, s, first, count, colors);
}

/// Copies the bytes of lit points to pixels. The loop is unrolled and uses local pointers: byte stores may
/// alias anything, so the compiler would reload members after each.
void show_points(const std::uint32_t* point_rgba, const std::uint32_t (&points)[block_size],
                 std::uint16_t mask, std::uint8_t* to) {
    if (mask == 0xFFFF) {
#pragma GCC unroll 16
        for (std::size_t i = 0; i < block_size; ++i) std::memcpy(to + 4 * i, point_rgba + points[i], 4);
        return;
    }
    for (std::size_t i = 0; i < block_size; ++i)
        if (mask >> i & 1u) std::memcpy(to + 4 * i, point_rgba + points[i], 4);
}

/// Flat shading without strokes: each pixel shows the bytes of its lit point.
void show_faces(Lighting& l, const Surface& s, const PerFace& faces) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.groups.size(), 8 * batch_size),
                      [&](const auto& range) {
                          for (std::size_t r = range.begin(); r != range.end(); ++r) {
                              const PixelGroup& group = s.groups[r];
                              if (!l.again(group.object)) continue;
                              show_points(l.point_rgba.data(), faces.refs[r].point, group.mask,
                                          &l.picture.rgba[4 * std::size_t{group.first_pixel}]);
                          }
                      });
}

/// Calls visit(first, count) for each run of set bits.
template <class Visit> void for_stretches(unsigned bits, const Visit& visit) {
    while (bits != 0) {
        const int first = std::countr_zero(bits), count = std::countr_one(bits >> first);
        visit(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
        bits &= ~(((1u << count) - 1) << first);
    }
}

/// The groups that show objects of which only the material has changed.
GroupsToDo of_objects_again(const Lighting& l, const Surface& s, std::size_t first) {
    GroupsToDo todo{0, 0};
    for (std::size_t i = 0; i < std::min(batch_size, s.groups.size() - first); ++i)
        todo.light |= unsigned{l.objects_again[s.groups[first + i].object]} << i;
    return todo;
}

/// Computes up to 16 groups, starting at `first`: colours, strokes, bytes. Skips groups that are up to date.
void color_batch(Lighting& l, const Surface& s, const Strokes& strokes, const DisplayJob& display,
                 std::size_t first) {
    std::array<ColorBlock, batch_size> colors;
    std::array<std::uint32_t, batch_size * block_size> rgba;
    const unsigned there = 0xFFFFu >> (batch_size - std::min(batch_size, s.groups.size() - first));
    const GroupsToDo todo = l.objects_again.empty() ? l.moving_light.groups_to_do(first / batch_size)
                                                    : of_objects_again(l, s, first);
    for_stretches(todo.light & there, [&](std::size_t i, std::size_t count) {
        color_groups(l, s, first + i, count, &colors[i]);
    });
    for_stretches(todo.others_only & there, [&](std::size_t i, std::size_t count) {
        std::copy_n(l.moving_light.others(first + i), count, &colors[i]);
    });
    for_stretches((todo.light | todo.others_only) & there, [&](std::size_t begin, std::size_t count) {
        for (std::size_t i = begin; i < begin + count; ++i) {
            const PixelGroup& group = s.groups[first + i];
            draw_over(strokes, l.npr.stroke, group.first_pixel, group.mask, colors[i]);
        }
        lighting_kernels().encode(display, &colors[begin], &rgba[begin * block_size], count);
        for (std::size_t i = begin; i < begin + count; ++i) {
            write_group(l, s.groups[first + i], colors[i], &rgba[i * block_size]);
            if (first + i + batch_size < s.groups.size())  // prefetches the next batch's pixels
                prefetch_to_write(
                    &l.picture.rgba[4 * std::size_t{s.groups[first + i + batch_size].first_pixel}]);
        }
    });
}

void color_groups_to_bytes(Lighting& l, const Surface& s, const Strokes& strokes, const DisplayJob& display) {
    const std::size_t batches = (s.groups.size() + batch_size - 1) / batch_size;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, batches, 8), [&](const auto& range) {
        for (std::size_t b = range.begin(); b != range.end(); ++b)
            color_batch(l, s, strokes, display, b * batch_size);
    });
}

/// Adds one group's contribution to its pixels.
void add_share(ColorBlock& sum, std::array<float, block_size>& covered, const PixelGroup& group,
               const GroupSamples& samples, const ColorBlock& color) {
    for (std::size_t i = 0; i < block_size; ++i) {
        if (!(group.mask >> i & 1u)) continue;
        const float w = samples.weight[i];
        covered[i] += w;
        sum.r[i] += w * color.r[i];
        sum.g[i] += w * color.g[i];
        sum.b[i] += w * color.b[i];
    }
}

/// Adds the background to the part of each pixel that is not covered by a face.
void add_background(ColorBlock& sum, const std::array<float, block_size>& covered,
                    const glm::vec3& background) {
    for (std::size_t i = 0; i < block_size; ++i) {
        const float left = 1 - covered[i];  // exact, because coverages are multiples of 1/8
        if (left <= 0) continue;
        sum.r[i] += left * background.x;
        sum.g[i] += left * background.y;
        sum.b[i] += left * background.z;
    }
}

/// Computes pixels with several samples each: adds the contributions in linear light, group by group.
void color_sampled_pixels(Lighting& l, const Surface& s, const Strokes& strokes, const DisplayJob& display) {
    std::vector<std::size_t>& begins = l.block_begins;
    begins.assign(1, 0);
    for (std::size_t r = 1; r <= s.groups.size(); ++r)
        if (r == s.groups.size() || s.groups[r].first_pixel != s.groups[r - 1].first_pixel)
            begins.push_back(r);
    tbb::parallel_for(std::size_t{1}, begins.size(), [&](std::size_t n) {
        ColorBlock sum{}, color;
        std::array<float, block_size> covered{};
        PixelGroup all = s.groups[begins[n - 1]];
        for (std::size_t r = begins[n - 1]; r < begins[n]; ++r) {
            color_groups(l, s, r, 1, &color);
            add_share(sum, covered, s.groups[r], s.group_samples[r], color);
            all.mask = static_cast<std::uint16_t>(all.mask | s.groups[r].mask);
        }
        add_background(sum, covered, l.display.background);
        draw_over(strokes, l.npr.stroke, all.first_pixel, all.mask, sum);
        std::array<std::uint32_t, block_size> rgba;
        lighting_kernels().encode(display, &sum, rgba.data(), 1);
        write_group(l, all, sum, rgba.data());
    });
}

}  // namespace

void color_pixels(Lighting& l, const Surface& s, const Strokes& strokes, const DisplayJob& display) {
    if (!s.group_samples.empty()) return color_sampled_pixels(l, s, strokes, display);
    const auto* faces = std::get_if<PerFace>(&s.kept);
    const bool as_they_are = faces != nullptr && strokes.coverage.empty() && !l.linear;
    as_they_are ? show_faces(l, s, *faces) : color_groups_to_bytes(l, s, strokes, display);
}

void clear_picture(Lighting& l, PictureSize size, const Strokes& strokes, const DisplayJob& display) {
    const UniformBlock ground(l.display.background, display);
    l.picture.size = size;
    const std::size_t pixels = size.pixels();
    l.picture.rgba.resize(4 * pixels);
    l.picture.linear.resize(l.linear ? 3 * pixels : 0);
    const std::size_t blocks = (pixels + block_size - 1) / block_size;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks, 1024), [&](const auto& range) {
        for (std::size_t b = range.begin(); b != range.end(); ++b) {
            const std::size_t left = std::min(block_size, pixels - b * block_size);
            const PixelGroup group{static_cast<std::uint32_t>(b * block_size), 0,
                                   static_cast<std::uint16_t>(0xFFFFu >> (block_size - left))};
            ColorBlock drawn = ground.color;
            if (!draw_over(strokes, l.npr.stroke, group.first_pixel, group.mask, drawn)) {
                write_group(l, group, ground.color, ground.rgba.data());
                continue;
            }
            std::array<std::uint32_t, block_size> drawn_rgba{};
            lighting_kernels().encode(display, &drawn, drawn_rgba.data(), 1);
            write_group(l, group, drawn, drawn_rgba.data());
        }
    });
}

void uncover(Lighting& l, const Visibility& v, const DisplayJob& display) {
    const UniformBlock ground(l.display.background, display);
    const auto width = static_cast<std::size_t>(l.picture.size.width);
    tbb::parallel_for(std::size_t{0}, static_cast<std::size_t>(l.picture.size.height), [&](std::size_t y) {
        for (std::size_t i = 0; i < v.groups_a_row; ++i) {
            const std::size_t block = y * v.groups_a_row + i;
            const auto bare = static_cast<std::uint16_t>(l.covered[block] & ~v.covered[block]);
            if (bare == 0) continue;
            const PixelGroup group{static_cast<std::uint32_t>(y * width + i * block_size), 0, bare};
            write_group(l, group, ground.color, ground.rgba.data());
        }
    });
}

}  // namespace glint
