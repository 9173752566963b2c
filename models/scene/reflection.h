#pragma once
// What each reflection model is, one row a model: its words, its formula, which vectors and which numbers of
// the material it uses, and whether its factors are bounded. What it computes is in renderer/lighting, one
// file a model. The lighting kernels of every instruction set read the rows: as data, so that nothing of the
// standard library is compiled into them.

#include "models/fields/choice.h"

namespace glint {

enum class Reflection { None, Lambert, Phong, BlinnPhong, Retro, OrenNayar, CookTorrance };

/// The cosine that a model's highlight raises to the shininess.
enum class HighlightCosine { None, RV, NH, LV };

/// Where a smooth highlight is brightest: at the light mirrored at n, or back at the light itself.
enum class HighlightPeak { Mirror, Light };

struct ReflectionInfo {
    Choice choice;
    const char* highlight = "";        // S as text; the power stands as (a·b)^n
    const char* highlight_latex = "";  // the same, in LaTeX
    HighlightCosine cosine = HighlightCosine::None;
    bool is_lit = true;           // false: the mesh's own colours, no equation
    bool has_highlight = true;    // false: S is 0
    bool uses_h = false;          // the half vector
    bool uses_roughness = false;  // Material::roughness
    bool uses_f0 = false;         // Material::f0
    bool rough_diffuse = false;   // the diffuse term has a factor beside n·l
    HighlightPeak peak = HighlightPeak::Mirror;
    bool is_bounded =
        true;  // the diffuse factor stays within max_diffuse_factor, S within max_specular_factor

    [[nodiscard]] constexpr bool uses_shininess() const { return cosine != HighlightCosine::None; }
    [[nodiscard]] constexpr bool uses_r() const { return cosine == HighlightCosine::RV; }
};

/// Upper bounds of the factors of every model that is bounded, rounding included: Oren-Nayar's diffuse factor
/// stays below 1.45, the others' and every power of a cosine at or below 1. The grid to which shares are
/// rounded follows from them (renderer/lighting/rounding.h).
inline constexpr double max_diffuse_factor = 1.5, max_specular_factor = 1.01;

/// The rows, one case a model, so that the compiler names the enumerator that has none.
constexpr ReflectionInfo row_of(Reflection reflection) {
    switch (reflection) {
    case Reflection::None:
        return {.choice = {"none", "Unlit", "No lighting: the mesh's own corner colours"},
                .is_lit = false,
                .has_highlight = false,
                .is_bounded = false};
    case Reflection::Lambert:
        return {.choice = {"lambert", "Lambert", "Diffuse only: max(n·l, 0)"}, .has_highlight = false};
    case Reflection::Phong:
        return {.choice = {"phong", "Phong", "Highlight max(r·v, 0) to the shininess"},
                .highlight = "(r·v)",
                .highlight_latex = "r \\cdot v",
                .cosine = HighlightCosine::RV};
    case Reflection::BlinnPhong:
        return {.choice = {"blinn-phong", "Blinn", "Highlight max(n·h, 0) to the shininess"},
                .highlight = "(n·h)",
                .highlight_latex = "n \\cdot h",
                .cosine = HighlightCosine::NH,
                .uses_h = true};
    case Reflection::Retro:
        return {.choice = {"retro", "Retro", "Highlight back to the light: max(l·v, 0) to the shininess"},
                .highlight = "(l·v)",
                .highlight_latex = "l \\cdot v",
                .cosine = HighlightCosine::LV,
                .peak = HighlightPeak::Light};
    case Reflection::OrenNayar:
        return {.choice = {"oren-nayar", "Oren–Nayar", "Rough diffuse, by roughness"},
                .has_highlight = false,
                .uses_roughness = true,
                .rough_diffuse = true};
    case Reflection::CookTorrance:
        return {
            .choice = {"cook-torrance", "Cook–Torrance", "Microfacets: GGX, Schlick, by roughness and f0"},
            .highlight = "π D G F / 4(n·v)",
            .highlight_latex = "\\frac{\\pi D G F}{4 \\, n \\cdot v}",
            .uses_h = true,
            .uses_roughness = true,
            .uses_f0 = true,
            .is_bounded = false};
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

/// Precondition: an enumerator. Static, as the table: no weak name that the kernels of two sets share.
[[gnu::always_inline]] static constexpr const ReflectionInfo& info_of(Reflection reflection) {
    return reflection_table.rows[static_cast<int>(reflection)];
}

}  // namespace glint
