#pragma once
// The input and output of the lighting kernels: plain numbers, shared by all instruction sets.

#include <cstddef>
#include <cstdint>

#include "models/scene/shading.h"
#include "renderer/simd/pow.h"
#include "renderer/simd/vec3.h"

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
/// of 64 samples of 4096 lights fits in a float.
inline constexpr float max_factor = 1e10f;

/// One light, or one sample of an area light: camera coordinates, colours times intensity.
/// Members as in LightAt (renderer/lighting/light_job.h).
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
    /// that arrives, weighted by the cosine of its angle with the normal.
    const ColorBlock* bounced = nullptr;

    /// The arrivals of block `first` and the following ones.
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
    bool clamp = false;        // clamps to 0..1 after the sum (OpenGL's rule for colours at vertices)
    bool any_mistake = false;  // also true if a table replaces the power
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
    /// start with the terms that need no light. It may be the same as `colors`. `arrivals`: the light that
    /// reaches these blocks; null: all lights do. It must not be null if job.bounced.
    void (*light)(const LightJob& job, const PointBlock* points, const ColorBlock* partial_sums,
                  const Arrivals* arrivals, ColorBlock* colors, std::size_t blocks);
    /// 16 pixels per block as bytes r, g, b, 255 in memory order.
    void (*encode)(const DisplayJob& job, const ColorBlock* colors, std::uint32_t* rgba, std::size_t blocks);
};

/// The kernels of the current instruction set (renderer/simd/isa/kernel_set.h).
const LightingKernels& lighting_kernels();

}  // namespace glint

namespace glint::inline GLINT_ISA {

// A light in the equation's form: camera coordinates, colours times intensity.
// Lecture: "Light Sources", "Light Source Falloff".

template <Number F> struct LightAt {
    Vec3<F> xyz;  // w = 0: unit direction towards the light; w = 1: its position
    F w{};        // 0 or 1, the same in all lanes
    // For mistakes: the position transformed as a direction, and as given in the scene.
    Vec3<F> as_direction, as_given;
    Vec3<F> ambient, diffuse, specular;    // linear RGB times intensity
    F constant{1}, linear{}, quadratic{};  // falloff 1 / (constant + linear r + quadratic r^2)
    Vec3<F> axis;          // unit vector: the direction of a spot, or the normal of an area light's patch
    F cos_cutoff{-1};      // for a spot
    Exponent<F> exponent;  // for a spot
    F soft_edge{};         // 1 / (cos inner - cos cutoff) of a spot with a soft edge; else 0
    F patch{};             // of an area light's sample: area / (pi * samples)
    bool has_falloff = false, has_cone = false, is_patch = false;
    bool has_soft_edge = false;
    bool has_ambient = true;  // false: its ambient colour is 0
};

/// False for a directional light.
template <Number F> bool is_positional(const LightAt<F>& light) { return lane(light.w, 0) > 0; }

/// From p to the light, not normalized; for a directional light, the unit direction itself.
template <Number F> Vec3<F> vector_to_light(const LightAt<F>& light, Vec3<F> p) {
    return is_positional(light) ? light.xyz - p : light.xyz;
}

/// constant + linear r + quadratic r^2. D: any number type.
template <class D> D falloff_polynomial(D constant, D linear, D quadratic, D r) {
    return constant + r * (linear + r * quadratic);
}

/// 1 / (constant + linear r + quadratic r^2) at the distance r >= 0, at most max_factor; 0 instead of a
/// division by zero. Lecture: "Light Source Falloff" (its a, b, c are quadratic, linear, constant).
template <Number F> F falloff(const LightAt<F>& light, F r) {
    const F divisor = falloff_polynomial(light.constant, light.linear, light.quadratic, r);
    return min(inverse_or_zero(divisor), F(max_factor));
}

/// |v| times the cosine of the angle between the spot's axis and the ray from the light to the point. v
/// points from the surface point to the light.
template <Number F> F along_axis(const LightAt<F>& light, Vec3<F> v) { return -dot(v, light.axis); }

/// cos(angle)^exponent between the spot's axis and the ray to the point, 0 outside the cone; the edge counts
/// as inside, as in may_be_inside(). A soft edge multiplies it by ((cos angle - cos cutoff) / (cos inner -
/// cos cutoff))^2, at most 1. l: the unit vector towards the light. Source: OpenGL 2.1, section 2.14.1;
/// KHR_lights_punctual, "Inner and Outer Cone Angles"; lecture: "point + direction + cutoff angle".
template <Number F> F spot_factor(const LightAt<F>& light, Vec3<F> l) {
    const F cos_angle = along_axis(light, l);
    const auto inside = cos_angle >= light.cos_cutoff;
    if (!any(inside)) return F(0);
    F factor = power(min(cos_angle, F(1)), light.exponent);
    if (light.has_soft_edge) {
        const F share = min((cos_angle - light.cos_cutoff) * light.soft_edge, F(1));
        factor = factor * share * share;
    }
    return select(inside, factor, F(0));
}

/// False if all lanes are certainly outside the cone. Compares signed squares of cosines times |to_light|^2,
/// so that no square root is taken, with a margin for rounding.
template <Number F> bool may_be_inside(const LightAt<F>& light, Vec3<F> to_light) {
    const F along = along_axis(light, to_light);
    const F least = light.cos_cutoff * abs(light.cos_cutoff) - F(1e-5f);
    return any(along * abs(along) >= least * dot(to_light, to_light));
}

/// The factor that replaces falloff for one sample of an area light: A |cos theta'| / (pi n^2 r^2), theta' at
/// the emitter; 0 at r = 0, at most max_factor. With all samples it tends to Lambert's polygon formula.
template <Number F> F patch_factor(const LightAt<F>& light, Vec3<F> l, F r) {
    return min(light.patch * abs(dot(l, light.axis)) * inverse_or_zero(r * r), F(max_factor));
}

}  // namespace glint::inline GLINT_ISA
