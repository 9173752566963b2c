#pragma once
// The lighting equation written out, with each term as a product of named numbers. Shared by the window, the
// text and the LaTeX output. Values come from the explanation; only the means over an area light's samples
// are computed here.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/explain/explain.h"
#include "renderer/explain/quantity.h"

namespace glint {

/// The exponent of a factor.
struct EquationPower {
    double exponent = 1;
    std::string pointer{};  // of the scene's number; empty if a rule clamps it
};

/// One factor of a term, in red, green and blue.
struct EquationFactor {
    Quantity quantity = Quantity::MaterialDiffuse;
    glm::dvec3 value{1};
    std::string pointer{};  // of the scene's number or colour; empty if the value is derived from others
    bool is_colour = false;
    bool is_mean = false;     // over an area light's samples, weighted by the light arriving from each
    bool divides = false;     // a divisor of the product
    double clamped_from = 0;  // if negative, the value before clamping to 0
    std::optional<EquationPower> power{};  // if set, `value` is the base
};

/// The reason for omitting a term that the scene switches off.
inline constexpr const char* switched_off = "switched off";

/// One line of the equation: term = product of the factors = result.
struct EquationLine {
    Quantity term = Quantity::DiffuseTerm;
    std::vector<EquationFactor> factors;
    glm::dvec3 result{0};
    /// If not empty, the reason why the result is 0 instead of the product of the factors: "dropped: n·l <
    /// 0".
    std::string left_out{};
    /// JSON pointers to the numbers from which the factors were computed, such as roughness and the
    /// reflectance f0.
    std::vector<std::string> made_by{};

    /// The product of the factors in one channel (0 red, 1 green, 2 blue).
    [[nodiscard]] double product(int channel) const;
};

/// One light at a point of the explained pixel.
struct LightOfEquation {
    const Scene& scene;
    const Explanation& explanation;
    const ExplainedLight& light;
};

/// Returns the line f = intensity × falloff × spot; for an area light, f = intensity × form.
[[nodiscard]] EquationLine share_line(const LightOfEquation& in);
/// Ambient, diffuse, and specular if the model has a highlight, in this order. With cool-to-warm shading,
/// specular only.
[[nodiscard]] std::vector<EquationLine> light_lines(const LightOfEquation& in);
/// Returns the lines for emission and global ambient light. Precondition: no cool-to-warm shading.
[[nodiscard]] std::vector<EquationLine> unlit_lines(const Scene& scene, const Explanation& explanation,
                                                    const ExplainedPoint& point);

/// Returns a light's contribution to the sum; for an area light, the sum over its samples.
[[nodiscard]] glm::vec3 counted_share(const ExplainedLight& light);
/// Returns whether a mistake clamps the light's contribution below the sum of its terms.
[[nodiscard]] bool is_clamped(const LightOfEquation& in);

/// The weights of an area light's samples in its means: the falloff of each divided by their sum, or 0 if no
/// light arrives.
[[nodiscard]] std::vector<double> sample_weights(const ExplainedLight& area);

}  // namespace glint
