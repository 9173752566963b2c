#pragma once
// The input and output of the lighting kernels: plain numbers, shared by all instruction sets.

#include <cstddef>
#include <cstdint>

#include "models/scene/shading.h"

namespace glint {

inline constexpr std::size_t block_size = 16;  // points per block; a multiple of every SIMD width
inline constexpr std::size_t batch_size = 16;  // blocks that stay in the L1 cache between two steps

/// Three numbers: a position, a direction or a linear RGB colour.
struct Float3 {
    float x = 0, y = 0, z = 0;
    bool operator==(const Float3&) const = default;
};

/// The maximum of falloff and of unbounded highlight factors, which grow without limit near a light. The
/// numbers of a scene are at most 1e7 (models/numbers.h), so a term is at most 1e31, and the sum of the terms
/// of 64 samples of 4096 lights fits a float.
inline constexpr float max_factor = 1e10f;

/// One light, or one sample of an area light: camera coordinates, colours times intensity.
/// Members as in LightAt (renderer/lighting/light_source.h).
struct LightSource {
    Float3 xyz;
    float w = 0;
    Float3 as_direction, as_given;  // see LightAt
    Float3 ambient, diffuse, specular;
    float constant = 1, linear = 0, quadratic = 0;
    Float3 axis;
    float cos_cutoff = -1, exponent = 0, soft_edge = 0;
    float patch = 0;
    bool has_falloff = false, has_cone = false, is_patch = false;
    int light = 0;  // index in Scene::lights
    bool operator==(const LightSource&) const = default;
};

/// One object's material for the equation.
struct SurfaceMaterial {
    Float3 k_a, k_d, k_s, f0;
    float shininess = 0, roughness = 0;
    float min_cosine_squared = 0;     // see MaterialAt
    Float3 emission, global_ambient;  // k_e and k_a I_a: the terms that need no light
};

/// Points to be lit, as a structure of arrays; entries past the last are zero.
struct alignas(64) PointBlock {
    float x[block_size], y[block_size], z[block_size];     // position, camera coordinates
    float nx[block_size], ny[block_size], nz[block_size];  // unit normal, or zero
};
/// Colours of a block of points: linear RGB, not clamped.
struct alignas(64) ColorBlock {
    float r[block_size], g[block_size], b[block_size];
};

/// The light that reaches the points of some blocks, if the scene's transport model lets objects block it. A
/// null pointer to it means that every light reaches every point.
struct Arrivals {
    /// Bit i of reached[l * stride + b]: light l of the job reaches point i of block b.
    const std::uint16_t* reached = nullptr;
    std::size_t stride = 0;
    /// Light from other surfaces at each point, if LightJob::bounced: linear RGB, the mean of the radiance
    /// that arrives, weighted by its cosine to the normal.
    const ColorBlock* bounced = nullptr;

    /// The same, starting at block `first`.
    [[nodiscard]] Arrivals from(std::size_t first) const {
        return {reached + first, stride, bounced ? bounced + first : nullptr};
    }
};

/// Cool-to-warm shading (renderer/lighting/reflection.h) in place of emission, ambient and diffuse.
struct CoolToWarm {
    bool on = false;
    Float3 cool, warm;
    float alpha = 0, beta = 0;
    /// The first enabled light, camera coordinates: position (light_w = 1) or unit direction (0). All zeros
    /// without a light, which gives n.l = 0.
    Float3 light;
    float light_w = 0;
};

struct LightJob {
    const LightSource* lights = nullptr;
    std::size_t light_count = 0;
    SurfaceMaterial material;
    Reflection model = Reflection::Phong;
    Terms terms;
    CoolToWarm tone;
    Float3 eye;                    // the target of v: the origin of camera coordinates
    bool infinite_viewer = false;  // v = (0, 0, 1) instead of from the point to the eye
    bool bounced = false;          // light from other surfaces (Arrivals), times k_d, replaces k_a I_a
    float grid = 0;  // lights' contributions are rounded to multiples of this power of two; 0: not rounded
    bool clamp = false;        // to 0..1 after the sum (OpenGL's rule for colours at vertices)
    bool any_mistake = false;  // or a table in place of the power
    Mistakes mistakes;
    int power_table = 0;  // Shading::power_table
    /// From camera to clip coordinates, for the mistake of lighting after projection.
    struct Projection {
        float x = 1, x_per_z = 0, x_plus = 0, y = 1, y_per_z = 0, y_plus = 0;
        float z = 1, z_plus = 0, w_per_z = -1, w = 0;
    };
    Projection projection;
};

/// The conversion of linear colours to bytes.
struct DisplayJob {
    float exposure = 1;
    bool srgb = false;
    bool encoded_twice = false, wraps = false;  // mistakes (models/scene/mistakes.h)
    bool operator==(const DisplayJob&) const = default;
    [[nodiscard]] bool any_mistake() const { return encoded_twice || wraps; }
};

/// The kernels of one instruction set.
struct LightingKernels {
    /// Lights blocks of points. `partial_sums`: sums to which the job's lights are added; if null, the sums
    /// start with the terms that need no light. It may be the same as `colors`. `arrivals`: what reaches
    /// these blocks; null: everything. It must not be null if job.bounced.
    void (*light)(const LightJob& job, const PointBlock* points, const ColorBlock* partial_sums,
                  const Arrivals* arrivals, ColorBlock* colors, std::size_t blocks);
    /// 16 pixels per block as bytes r, g, b, 255 in memory order.
    void (*encode)(const DisplayJob& job, const ColorBlock* colors, std::uint32_t* rgba, std::size_t blocks);
};

/// The kernels of the current instruction set (renderer/simd/isa/kernel_set.h).
const LightingKernels& lighting_kernels();

}  // namespace glint
