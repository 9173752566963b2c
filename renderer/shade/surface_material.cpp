#include "renderer/shade/surface_material.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "renderer/simd/pow.h"

namespace glint {
namespace {

/// The sRGB encoding of a linear component of a colour, 0 and above; exact for 0 and 1, which srgb_encoded()
/// in floats misses by the last bit.
float srgb_of(float x) {
    if (x <= 0.0031308f) return 12.92f * x;
    return static_cast<float>(1.055 * static_cast<double>(power(x, 1 / 2.4f)) - 0.055);
}

}  // namespace

Material mistaken_material(const Mistakes& wrong, Material m) {
    if (wrong.lit_in_srgb)
        for (glm::vec3* color : {&m.ambient, &m.diffuse, &m.specular, &m.emission})
            for (int i = 0; i < 3; ++i) (*color)[i] = srgb_of((*color)[i]);
    if (wrong.coefficients_swapped) std::swap(m.diffuse, m.specular);
    if (wrong.highlight_tinted) m.specular *= m.diffuse;
    if (wrong.highlight_normalized) {
        constexpr float pi = 3.14159265f;
        const float n = m.shininess;
        m.specular *= wrong.highlight_form == 0   ? (n + 8) / (8 * pi)
                      : wrong.highlight_form == 1 ? (n + 2) / (2 * pi)
                                                  : (n + 2) / 8;
    }
    if (wrong.shininess_as_fraction) m.shininess /= 128;
    if (wrong.shininess_inverted && m.shininess > 0) m.shininess = std::min(1 / m.shininess, 1e30f);
    return m;
}

float min_cosine_squared(float shininess) {
    return shininess > 0 ? static_cast<float>(std::exp2(-48.0 / static_cast<double>(shininess)))
                         : std::numeric_limits<float>::lowest();  // anything to the power 0 is 1
}

SurfaceMaterial surface_material(const Material& m) {
    SurfaceMaterial s;
    s.k_a = to_float3(m.ambient);
    s.k_d = to_float3(m.diffuse);
    s.k_s = to_float3(m.specular);
    s.f0 = to_float3(m.f0);
    s.shininess = m.shininess;
    s.roughness = m.roughness;
    s.emission = to_float3(m.emission);
    s.min_cosine_squared = min_cosine_squared(m.shininess);
    return s;
}

}  // namespace glint
