// The lighting kernels, compiled once for each instruction set (renderer/CMakeLists.txt, add_kernels). They
// do not use the standard library, because the linker would merge functions with the same name from two
// instruction sets.

#include "renderer/geometry/interpolate.h"
#include "renderer/lighting/display.h"
#include "renderer/lighting/illuminate.h"
#include "renderer/shade/group_bounds.h"
#include "renderer/shade/shade_kernels.h"
#include "renderer/simd/int_lanes.h"
#include "renderer/simd/isa/kernel_set.h"
#include "renderer/simd/transpose.h"
#include "renderer/simd/wide.h"

namespace glint::inline GLINT_ISA {

constexpr int opaque = static_cast<int>(0xFF000000u);

static void store_colors(ColorBlock& out, std::size_t k, Vec3<Wide> c) {
    store(out.r + k, c.x);
    store(out.g + k, c.y);
    store(out.b + k, c.z);
}

/// One group of `Wide` points in a batch, with their partial sums.
struct Group {
    PointAt<Wide> at;
    Vec3<Wide> sum;
};
union Slot {  // avoids zero-initializing the group
    Group group;
    Slot() {}
};

/// Prefetches part i of the next batch. Prefetches are spread over the first light's pass, because issuing
/// all of them at once would overflow the line-fill buffers.
[[gnu::always_inline]] static inline void prefetch_next(const PointBlock* points,
                                                        const ColorBlock* partial_sums, std::size_t i) {
    constexpr std::size_t share = block_size / GLINT_LANES;
    const auto part_of = [i](const auto* blocks) __attribute__((always_inline)) {
        constexpr std::size_t bytes = sizeof(*blocks) / share;
        prefetch(reinterpret_cast<const char*>(blocks) + batch_size * sizeof(*blocks) + i * bytes, bytes);
    };
    part_of(points);
    if (partial_sums) part_of(partial_sums);
}

/// 1 where light `l` reaches a point of group i of a batch, otherwise 0.
[[gnu::always_inline]] static inline Wide reached_lanes(const Arrivals& arrivals, std::size_t l,
                                                        std::size_t i) {
    const std::size_t first = i * GLINT_LANES;
    const unsigned bits = arrivals.reached[l * arrivals.stride + first / block_size];
    float reached[GLINT_LANES];
    for (std::size_t k = 0; k < GLINT_LANES; ++k)
        reached[k] = static_cast<float>(bits >> (first % block_size + k) & 1u);
    return load<Wide>(reached);
}

/// Lights a batch with one reflection model. The model is a template argument so that the compiler omits
/// unused computations; the source of the equation is the same for all models. flatten: the equation consists
/// of many small functions, and each call would pass its vectors through memory. The outer loop runs over the
/// lights and the inner loop over a batch of points: the light stays in registers, the branch on whether it
/// reaches the points is predictable, and independent points hide the latency of a power. This is
/// deliberately one function: split into three that are always inlined, it took 2.3 times as long. `general`:
/// supports mistakes and blocked lights; the other instantiation contains no code for them.
template <Reflection model, bool general>
GLINT_FLATTEN static void light_batch(const LightJob& job, const PointBlock* points,
                                      const ColorBlock* partial_sums,
                                      [[maybe_unused]] const Arrivals* arrivals, ColorBlock* colors,
                                      std::size_t blocks) {
    const bool any_mistake = general && job.any_mistake;
    const Equation equation = equation_of(job, model, any_mistake);
    const MaterialAt<Wide> material = material_at<Wide>(job.material);
    Slot slots[batch_size * block_size / GLINT_LANES];
    const std::size_t count = blocks * block_size / GLINT_LANES;
    for (std::size_t i = 0; i < count; ++i) {
        const PointBlock& in = points[i * GLINT_LANES / block_size];
        const std::size_t k = i * GLINT_LANES % block_size;
        const Vec3<Wide> p{load<Wide>(in.x + k), load<Wide>(in.y + k), load<Wide>(in.z + k)};
        const Vec3<Wide> n{load<Wide>(in.nx + k), load<Wide>(in.ny + k), load<Wide>(in.nz + k)};
        Group group;
        group.at = seen_from_eye(job, any_mistake, p, n);
        if (partial_sums) {
            const ColorBlock& from = partial_sums[i * GLINT_LANES / block_size];
            group.sum = {load<Wide>(from.r + k), load<Wide>(from.g + k), load<Wide>(from.b + k)};
        } else if (general && arrivals && arrivals->bounced) {
            const ColorBlock& from = arrivals->bounced[i * GLINT_LANES / block_size];
            group.sum =
                begin_sum(job, group.at,
                          Vec3<Wide>{load<Wide>(from.r + k), load<Wide>(from.g + k), load<Wide>(from.b + k)});
        } else {
            group.sum = begin_sum(job, group.at);
        }
        slots[i].group = group;
    }
    for (std::size_t l = 0; l < job.light_count; ++l) {
        const auto add = [&](const LightAt<Wide>& light) {
            const LightColors<Wide> reflected = colors_on(material, light);
            // Software pipelining, depth 1: starts group i's square root and divisions, then finishes the
            // previous group. Out-of-order execution alone looks ahead only one or two groups.
            std::size_t behind = count;
            LightVector<Wide> towards_behind;
            Attenuation<Wide> attenuation_behind;
            const auto finish = [&] {
                Group& group = slots[behind].group;
                auto terms = illuminate<general>(equation, light, material, reflected, towards_behind,
                                                 attenuation_behind, group.at);
                if constexpr (general)
                    if (arrivals) remove_blocked(terms, reached_lanes(*arrivals, l, behind));
                add_light(group.sum, equation, light, terms);
            };
            for (std::size_t i = 0; i < count; ++i) {
                if (l == 0) prefetch_next(points, partial_sums, i);
                const LightVector<Wide> towards = light_vector(light, slots[i].group.at);
                if (!may_add(equation, light, towards)) continue;
                const Attenuation<Wide> begins = attenuation(light, towards);
                if (behind < count) finish();
                behind = i;
                towards_behind = towards;
                attenuation_behind = begins;
            }
            if (behind < count) finish();
        };
        // Three specialized copies of the loop: any light, a plain point light, a plain directional light.
        LightAt<Wide> light = light_at<Wide>(job.lights[l]);
        if (general || light.has_cone || light.is_patch || light.has_ambient) {
            add(light);
        } else if (job.lights[l].w > 0) {
            light.w = Wide(1);
            light.has_cone = light.is_patch = light.has_ambient = false;
            add(light);
        } else {
            light.w = Wide(0);
            light.has_cone = light.is_patch = light.has_ambient = light.has_falloff = false;
            add(light);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        ColorBlock& out = colors[i * GLINT_LANES / block_size];
        const std::size_t k = i * GLINT_LANES % block_size;
        store_colors(out, k, end_sum(job, slots[i].group.sum));
    }
}

template <Reflection model, bool general>
static void light_as(const LightJob& job, const PointBlock* points, const ColorBlock* partial_sums,
                     const Arrivals* arrivals, ColorBlock* colors, std::size_t blocks) {
    for (std::size_t i = 0; i < blocks; i += batch_size) {
        Arrivals here;
        if (arrivals) here = arrivals->from(i);
        light_batch<model, general>(job, points + i, partial_sums ? partial_sums + i : nullptr,
                                    arrivals ? &here : nullptr, colors + i,
                                    i + batch_size < blocks ? batch_size : blocks - i);
    }
}

/// Calls the function for the job's model, starting the search at model number `model`.
template <bool general, int model = 0>
static void light_with(const LightJob& job, const PointBlock* points, const ColorBlock* partial_sums,
                       const Arrivals* arrivals, ColorBlock* colors, std::size_t blocks) {
    if constexpr (model < reflection_count) {
        constexpr auto candidate = static_cast<Reflection>(model);
        if (job.model == candidate)
            return light_as<candidate, general>(job, points, partial_sums, arrivals, colors, blocks);
        light_with<general, model + 1>(job, points, partial_sums, arrivals, colors, blocks);
    }
}

static void light(const LightJob& job, const PointBlock* points, const ColorBlock* partial_sums,
                  const Arrivals* arrivals, ColorBlock* colors, std::size_t blocks) {
    if (job.any_mistake || arrivals)
        return light_with<true>(job, points, partial_sums, arrivals, colors, blocks);
    light_with<false>(job, points, partial_sums, nullptr, colors, blocks);
}

GLINT_FLATTEN static std::uint16_t find_lit(const LightSource& source, const BoundsBlock& b) {
    const LightAt<Wide> light = light_at<Wide>(source);
    if (light.has_ambient) return 0xFFFF;
    unsigned behind = 0;
    for (std::size_t k = 0; k < block_size; k += GLINT_LANES) {
        const GroupBounds<Wide> bounds{{load<Wide>(b.x + k), load<Wide>(b.y + k), load<Wide>(b.z + k)},
                                       load<Wide>(b.radius + k),
                                       {load<Wide>(b.nx + k), load<Wide>(b.ny + k), load<Wide>(b.nz + k)},
                                       load<Wide>(b.spread + k)};
        behind |= mask_bits(certainly_behind(light, bounds)) << k;
    }
    return static_cast<std::uint16_t>(~behind);
}

template <bool any_mistake>
GLINT_FLATTEN static void encode_with(const DisplayJob& job, const ColorBlock* colors, std::uint32_t* rgba,
                                      std::size_t blocks) {
    for (std::size_t i = 0; i < blocks; ++i) {
        for (std::size_t k = 0; k < block_size; k += GLINT_LANES) {
            const auto byte = [&job](const float* linear) {
                if constexpr (any_mistake)
                    return wrapped_byte_of(mistakenly_displayed(job, load<Wide>(linear)));
                else
                    return byte_of(displayed(job, load<Wide>(linear)));
            };
            const auto r = byte(colors[i].r + k), g = byte(colors[i].g + k), b = byte(colors[i].b + k);
            store_ints(rgba + i * block_size + k, r | g << 8 | b << 16 | opaque);
        }
    }
}

static void encode(const DisplayJob& job, const ColorBlock* colors, std::uint32_t* rgba, std::size_t blocks) {
    if (job.any_mistake()) return encode_with<true>(job, colors, rgba, blocks);
    encode_with<false>(job, colors, rgba, blocks);
}

/// Loads the colours of the lit points with these numbers.
template <Number F> Vec3<F> colors_of(const ColorRecord* points, const std::uint32_t* number) {
    const Columns<F> color = gather_transposed<F>(points, number, sizeof(ColorRecord));
    return {color.a, color.b, color.c};
}

/// Gouraud shading: the colour of a pixel is the weighted sum of its corners' colours. `each`: the number of
/// corners (lit points) per pixel, whose numbers and weights are in groups of 16.
template <Number F>
Vec3<F> blended_colors(const ColorRecord* points, const std::uint32_t* number, const float* weight,
                       int each) {
    Vec3<F> sum;
    for (int k = 0; k < each; ++k, number += block_size, weight += block_size)
        sum = add_weighted(sum, load<F>(weight), colors_of<F>(points, number));
    return sum;
}

GLINT_FLATTEN static void blend_groups(const ColorRecord* points, const std::uint32_t* numbers,
                                       const float* weights, int each, ColorBlock* colors,
                                       std::size_t groups) {
    for (std::size_t i = 0; i < groups; ++i) {
        const std::size_t first = i * static_cast<std::size_t>(each) * block_size;
        for (std::size_t k = 0; k < block_size; k += GLINT_LANES)
            store_colors(colors[i], k,
                         blended_colors<Wide>(points, numbers + first + k, weights + first + k, each));
    }
}

GLINT_FLATTEN static void pick_groups(const ColorRecord* points, const std::uint32_t* numbers,
                                      ColorBlock* colors, std::size_t groups) {
    for (std::size_t i = 0; i < groups; ++i)
        for (std::size_t k = 0; k < block_size; k += GLINT_LANES)
            store_colors(colors[i], k, colors_of<Wide>(points, numbers + i * block_size + k));
}

#define GLINT_TEXT_(name) #name
#define GLINT_TEXT(name) GLINT_TEXT_(name)
extern const ColorKernels colors;
const ColorKernels colors{GLINT_TEXT(GLINT_ISA), {light, encode}, {find_lit, blend_groups, pick_groups}};

}  // namespace glint::inline GLINT_ISA
