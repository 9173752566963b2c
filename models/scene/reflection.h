#pragma once
// The reflection models, one row per model: its texts, its formula, the vectors and material numbers that it
// uses, and whether its factors are bounded. The code that computes the models is in renderer/lighting. The
// lighting kernels of every instruction set read the rows, which are plain data, so no standard library code
// is compiled into the kernels.

#include "models/numbers.h"

namespace glint {

enum class Reflection { None, Lambert, Phong, BlinnPhong, Retro, OrenNayar, CookTorrance };

/// The model of one material: the scene's, or its own, with the same value as in Reflection.
enum class OwnReflection { Scene, Lambert, Phong, BlinnPhong, Retro, OrenNayar, CookTorrance };

/// The cosine that a model's highlight raises to the shininess.
enum class HighlightCosine { None, RV, NH, LV };

/// The direction of a smooth highlight: that of the light mirrored about n, or back towards the light.
enum class HighlightPeak { Mirror, Light };

struct ReflectionInfo {
    Choice choice;
    const char* highlight = "";        // S as text, with (a·b)^n for the power
    const char* highlight_latex = "";  // the same, in LaTeX
    HighlightCosine cosine = HighlightCosine::None;
    bool is_lit = true;           // false: the mesh's own colours, no equation
    bool has_highlight = true;    // false: S is 0
    bool uses_h = false;          // the half vector
    bool uses_roughness = false;  // Material::roughness
    bool uses_f0 = false;         // Material::f0
    bool rough_diffuse = false;   // the diffuse term has a factor besides n·l
    HighlightPeak peak = HighlightPeak::Mirror;
    bool is_bounded =
        true;  // the diffuse factor stays within max_diffuse_factor, S within max_specular_factor
    const char* program = "";  // the formula for generated programs (programs/model_text.h)

    [[nodiscard]] constexpr bool uses_shininess() const { return cosine != HighlightCosine::None; }
    [[nodiscard]] constexpr bool uses_r() const { return cosine == HighlightCosine::RV; }
};

/// Upper bounds of the factors of every bounded model, rounding included: Oren-Nayar's diffuse factor stays
/// below 1.45, the others' and every power of a cosine at or below 1. They determine the grid to which
/// contributions are rounded (renderer/lighting/surface_point.h).
inline constexpr double max_diffuse_factor = 1.5, max_specular_factor = 1.01;

/// The rows, one case per model, so the compiler reports an enumerator without a row.
constexpr ReflectionInfo row_of(Reflection reflection) {
    switch (reflection) {
    case Reflection::None:
        return {.choice = {"none", "Unlit", "No lighting: the mesh's own corner colours"},
                .is_lit = false,
                .has_highlight = false,
                .is_bounded = false};
    case Reflection::Lambert:
        return {.choice = {"lambert", "Lambert", "Diffuse only: max(n·l, 0)"},
                .has_highlight = false,
                .program = "diffuse = max(n_l, 0.0)"};
    case Reflection::Phong:
        return {.choice = {"phong", "Phong", "Highlight: max(r·v, 0) raised to the shininess"},
                .highlight = "(r·v)",
                .highlight_latex = "r \\cdot v",
                .cosine = HighlightCosine::RV,
                .program =
                    "diffuse = max(n_l, 0.0)\n"
                    "vec3 r = 2.0 * n_l * n - l\n"
                    "S = power(dot(r, v), shininess)"};
    case Reflection::BlinnPhong:
        return {.choice = {"blinn-phong", "Blinn–Phong", "Highlight: max(n·h, 0) raised to the shininess"},
                .highlight = "(n·h)",
                .highlight_latex = "n \\cdot h",
                .cosine = HighlightCosine::NH,
                .uses_h = true,
                .program =
                    "diffuse = max(n_l, 0.0)\n"
                    "vec3 h = unit(l + v)\n"
                    "S = power(dot(n, h), shininess)"};
    case Reflection::Retro:
        return {
            .choice = {"retro", "Retro", "Highlight towards the light: max(l·v, 0) raised to the shininess"},
            .highlight = "(l·v)",
            .highlight_latex = "l \\cdot v",
            .cosine = HighlightCosine::LV,
            .peak = HighlightPeak::Light,
            .program =
                "diffuse = max(n_l, 0.0)\n"
                "S = power(l_v, shininess)"};
    case Reflection::OrenNayar:
        return {.choice = {"oren-nayar", "Oren–Nayar", "Rough diffuse surface, by roughness"},
                .has_highlight = false,
                .uses_roughness = true,
                .rough_diffuse = true,
                .program =
                    "sigma = roughness * 0.5 * pi\n"
                    "A = 1.0 - 0.5 * sigma * sigma / (sigma * sigma + 0.33)\n"
                    "B = 0.45 * sigma * sigma / (sigma * sigma + 0.09)\n"
                    "azimuth = l_v - n_l * n_v\n"
                    "rough = over(max(azimuth, 0.0), max(max(n_l, n_v), 0.0))\n"
                    "diffuse = max(n_l, 0.0) * (A + B * rough)"};
    case Reflection::CookTorrance:
        return {
            .choice = {"cook-torrance", "Cook–Torrance", "Microfacets: GGX, Schlick, by roughness and f0"},
            .highlight = "π D G F / 4(n·v)",
            .highlight_latex = "\\frac{\\pi D G F}{4 \\, n \\cdot v}",
            .uses_h = true,
            .uses_roughness = true,
            .uses_f0 = true,
            .is_bounded = false,
            .program =
                "diffuse = max(n_l, 0.0)\n"
                "a = max(roughness * roughness, 0.001)\n"
                "vec3 h = unit(l + v)\n"
                "n_h = max(dot(n, h), 0.0)\n"
                "vec3 sine = cross(n, h)\n"
                "t = n_h * n_h * a * a + dot(sine, sine)\n"
                "D = over(a * a, pi * t * t)\n"
                "tan2_l = max(over(1.0, n_l * n_l) - 1.0, 0.0)\n"
                "tan2_v = max(over(1.0, n_v * n_v) - 1.0, 0.0)\n"
                "G = 2.0 / (sqrt(1.0 + a * a * tan2_l) + sqrt(1.0 + a * a * tan2_v))\n"
                "vec3 F = f0 + pow(1.0 - max(dot(v, h), 0.0), 5.0) * (1.0 - f0)\n"
                "facing = above_zero(n_l) * above_zero(n_v)\n"
                "vec3 S = facing * over(pi * D * G, 4.0 * n_v) * F"};
    }
    return {};
}

inline constexpr int reflection_count = [] {
    int count = 0;
    while (!row_of(static_cast<Reflection>(count)).choice.word.empty()) ++count;
    return count;
}();

struct ReflectionTable {
    ReflectionInfo rows[reflection_count];
};
static constexpr ReflectionTable reflection_table = [] {
    ReflectionTable table;
    for (int i = 0; i < reflection_count; ++i) table.rows[i] = row_of(static_cast<Reflection>(i));
    return table;
}();

/// Precondition: a valid enumerator. Static, like the table, so that the kernels of two sets share no weak
/// symbol.
[[gnu::always_inline]] static constexpr const ReflectionInfo& info_of(Reflection reflection) {
    return reflection_table.rows[static_cast<int>(reflection)];
}

}  // namespace glint
