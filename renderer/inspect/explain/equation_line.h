#pragma once
// The lighting equation as it is written out: each term a product of named numbers, which the window, text
// and LaTeX all write. Values are those of the explanation, none is computed anew but the means of an area
// light's samples.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/inspect/explain/explanation.h"
#include "renderer/inspect/explain/quantity.h"

namespace glint {

/// The number to which a factor is raised.
struct EquationPower {
    double exponent = 1;
    std::string pointer{};  // of the scene's number; empty where rules hold it at another
};

/// One factor of a term, in red, green and blue.
struct EquationFactor {
    Quantity quantity = Quantity::MaterialDiffuse;
    glm::dvec3 value{1};
    std::string pointer{};  // of the scene's number, or of its colour; empty: the value follows from others
    bool is_colour = false;
    bool is_mean = false;                  // over an area light's samples, weighted by what arrives from each
    bool divides = false;                  // the product is divided by it
    double clamped_from = 0;               // below 0: what the value was before it was clamped to 0
    std::optional<EquationPower> power{};  // set: `value` is a base
};

/// Why a term is left out that the scene switches off.
inline constexpr const char* switched_off = "switched off";

/// term = product of the factors = result.
struct EquationLine {
    Quantity term = Quantity::DiffuseTerm;
    std::vector<EquationFactor> factors;
    glm::dvec3 result{0};
    /// Not empty: why the product of the factors is not the result, which is 0: "dropped: n·l < 0".
    std::string left_out{};
    /// Pointers to numbers by which factors came about: roughness, the reflectance f0.
    std::vector<std::string> made_by{};

    /// What the factors come to in one channel (0 red, 1 green, 2 blue).
    [[nodiscard]] double product(int channel) const;
};

/// One light at a point of the explained pixel.
struct LightOfEquation {
    const Scene& scene;
    const Explanation& explanation;
    const ExplainedLight& light;
};

/// f = intensity × falloff × spot; of an area light intensity × form.
[[nodiscard]] EquationLine share_line(const LightOfEquation& in);
/// Ambient, diffuse and, of a model with a highlight, specular, in this order; under cool-to-warm shading the
/// specular one alone.
[[nodiscard]] std::vector<EquationLine> light_lines(const LightOfEquation& in);
/// Emission, and the ambient light that is there without a light. Precondition: no cool-to-warm shading.
[[nodiscard]] std::vector<EquationLine> unlit_lines(const Scene& scene, const Explanation& explanation,
                                                    const ExplainedPoint& point);

/// How an area light's samples count in its means: what falloff makes of each, as shares of their sum, or 0
/// where nothing arrives.
[[nodiscard]] std::vector<double> sample_weights(const ExplainedLight& area);

}  // namespace glint
