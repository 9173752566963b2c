#pragma once
// The symbols of the lighting equation. The window, the text and the LaTeX output all use this table, so that
// each symbol has one meaning.

#include <array>
#include <cstddef>
#include <string>

namespace glint {

/// The meaning of a symbol.
enum class Quantity {
    Result,
    EmissionTerm,
    AmbientTerm,
    BouncedTerm,
    DiffuseTerm,
    SpecularTerm,
    MaterialEmission,
    MaterialAmbient,
    MaterialDiffuse,
    MaterialSpecular,
    GlobalAmbient,
    Bounced,
    LightAmbient,
    LightDiffuse,
    LightSpecular,
    Share,
    Intensity,
    Falloff,
    Spot,
    Form,
    Reach,
    Distance,
    N,
    L,
    V,
    R,
    H,
    P,
    Shadow,
    NL,
    RV,
    NH,
    LV,
    NV,
    Power,
    Highlight,
    QuarterPi,
    Facets,
    Masking,
    Fresnel,
    Rough,
    WarmShare,
    Cool,
    Warm,
    Mistake
};

struct QuantityRow {
    Quantity quantity;
    const char* letter;   // "k"; for a cosine, the two vectors with the dot, "n·l"
    const char* index;    // its subscript, or empty
    const char* latex;    // for LaTeX math mode
    const char* meaning;  // for a legend
};

inline constexpr std::array quantity_rows{
    QuantityRow{Quantity::Result, "I", "", "I", "Light that reaches the eye: the pixel before exposure"},
    QuantityRow{Quantity::EmissionTerm, "e", "", "I_e", "Emission term: light that the surface emits"},
    QuantityRow{Quantity::AmbientTerm, "a", "", "I_a", "Ambient term: light from all directions"},
    QuantityRow{Quantity::BouncedTerm, "b", "", "I_b",
                "Bounced term: light from other surfaces, in place of global ambient light"},
    QuantityRow{Quantity::DiffuseTerm, "d", "", "I_d", "Diffuse term: light reflected evenly"},
    QuantityRow{Quantity::SpecularTerm, "s", "", "I_s", "Specular term: the highlight"},
    QuantityRow{Quantity::MaterialEmission, "k", "e", "k_e", "Light that the material emits"},
    QuantityRow{Quantity::MaterialAmbient, "k", "a", "k_a",
                "Fraction of ambient light that the material reflects"},
    QuantityRow{Quantity::MaterialDiffuse, "k", "d", "k_d",
                "Fraction of light that the material reflects evenly"},
    QuantityRow{Quantity::MaterialSpecular, "k", "s", "k_s",
                "Fraction of light that goes into the material's highlight"},
    QuantityRow{Quantity::GlobalAmbient, "L", "g", "L_g",
                "Global ambient light of the scene, independent of the lights"},
    QuantityRow{Quantity::Bounced, "L", "b", "L_b",
                "Light from other surfaces: the mean of random paths, in place of global ambient light"},
    QuantityRow{Quantity::LightAmbient, "L", "a", "L_a", "The light's ambient colour"},
    QuantityRow{Quantity::LightDiffuse, "L", "d", "L_d", "The light's diffuse colour"},
    QuantityRow{Quantity::LightSpecular, "L", "s", "L_s", "The light's specular colour"},
    QuantityRow{Quantity::Share, "f", "", "f",
                "The light's factor in all its terms: intensity × falloff × spot"},
    QuantityRow{Quantity::Intensity, "intensity", "", "\\text{intensity}", "Multiplies the light's colours"},
    QuantityRow{Quantity::Falloff, "falloff", "", "\\text{falloff}",
                "Attenuation with distance: 1 / (c₀ + c₁ dist + c₂ dist²)"},
    QuantityRow{Quantity::Spot, "spot", "", "\\text{spot}",
                "Attenuation by the cone: the cosine from its axis, raised to its exponent, less in a soft "
                "edge; 0 outside"},
    QuantityRow{Quantity::Form, "form", "", "\\text{form}",
                "For an area light, in place of falloff: the sum of A cos θ′ / (π dist²) over its samples"},
    QuantityRow{Quantity::Reach, "reach", "", "\\text{reach}",
                "0 in a shadow, else 1; the form of an area light counts only samples that reach the point"},
    QuantityRow{Quantity::Distance, "dist", "", "\\text{dist}", "Distance to the light, scene units"},
    QuantityRow{Quantity::N, "n", "", "\\mathbf{n}", "The unit normal"},
    QuantityRow{Quantity::L, "l", "", "\\mathbf{l}", "Unit vector towards the light"},
    QuantityRow{Quantity::V, "v", "", "\\mathbf{v}", "Unit vector towards the eye"},
    QuantityRow{Quantity::R, "r", "", "\\mathbf{r}", "l mirrored about n, normalized"},
    QuantityRow{Quantity::H, "h", "", "\\mathbf{h}", "Halfway between l and v, normalized"},
    QuantityRow{Quantity::P, "p", "", "\\mathbf{p}", "The point that is lit"},
    QuantityRow{Quantity::Shadow, "q", "", "\\mathbf{q}", "The projection of l onto n: n (n·l)"},
    QuantityRow{Quantity::NL, "n·l", "", "\\mathbf{n} \\cdot \\mathbf{l}",
                "Cosine of the angle at which light arrives, 0 at 90° and beyond"},
    QuantityRow{Quantity::RV, "r·v", "", "\\mathbf{r} \\cdot \\mathbf{v}",
                "Cosine of the angle between the mirrored light and the eye"},
    QuantityRow{Quantity::NH, "n·h", "", "\\mathbf{n} \\cdot \\mathbf{h}",
                "Cosine of the angle between the normal and the halfway vector"},
    QuantityRow{Quantity::LV, "l·v", "", "\\mathbf{l} \\cdot \\mathbf{v}",
                "Cosine of the angle between light and eye"},
    QuantityRow{Quantity::NV, "n·v", "", "\\mathbf{n} \\cdot \\mathbf{v}",
                "Cosine of the angle between normal and eye"},
    QuantityRow{Quantity::Power, "ˢ", "", "s", "Shininess of the material, the exponent"},
    QuantityRow{Quantity::Highlight, "S", "", "S",
                "The highlight's factor; for an area light, the mean over its samples"},
    QuantityRow{Quantity::QuarterPi, "π/4", "", "\\tfrac{\\pi}{4}", "0.785398163"},
    QuantityRow{Quantity::Facets, "D", "", "D", "Density of microfacets that face halfway between l and v"},
    QuantityRow{Quantity::Masking, "G", "", "G", "Fraction of those facets that are not hidden by others"},
    QuantityRow{Quantity::Fresnel, "F", "", "F", "Fraction of light that such a facet reflects (Fresnel)"},
    QuantityRow{Quantity::Rough, "(A+B…)", "", "(A + B \\ldots)",
                "The effect of roughness on the cosine (Oren and Nayar): A + B max(cos Δφ, 0) sin α tan β"},
    QuantityRow{Quantity::WarmShare, "k", "w", "k_w", "Fraction of the warm tone: (1 + n·l) / 2"},
    QuantityRow{Quantity::Cool, "cool", "", "\\text{cool}", "Tone of surfaces that face away from the light"},
    QuantityRow{Quantity::Warm, "warm", "", "\\text{warm}", "Tone of surfaces that face the light"},
    QuantityRow{Quantity::Mistake, "mistake", "", "\\text{mistake}",
                "The effect of the scene's mistakes on the product of the others"},
};

[[nodiscard]] constexpr const QuantityRow& row_of(Quantity quantity) {
    return quantity_rows[static_cast<std::size_t>(quantity)];
}
/// Whether the quantity is the cosine between two vectors.
[[nodiscard]] constexpr bool is_cosine(Quantity quantity) {
    return quantity >= Quantity::NL && quantity <= Quantity::NV;
}
/// The symbol as text, such as "k_d".
[[nodiscard]] inline std::string text_of(Quantity quantity) {
    const QuantityRow& row = row_of(quantity);
    return *row.index == 0 ? row.letter : std::string(row.letter) + "_" + row.index;
}

}  // namespace glint
