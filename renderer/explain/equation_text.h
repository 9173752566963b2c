#pragma once
// Writes a line of the equation as one line of text, with as many digits as its result needs.

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/json/json.h"
#include "models/scene/scene.h"
#include "renderer/explain/explain.h"
#include "renderer/explain/quantity.h"

namespace glint {

// The lighting equation written out, with each term as a product of named numbers. Shared by the window, the
// text and the LaTeX output. Values come from the explanation; only the means over an area light's samples
// are computed here.

/// The exponent of a factor.
struct EquationPower {
    double exponent = 1;
    std::string pointer{};  // pointer to the scene's number; empty if a rule clamps it
};

/// One factor of a term, in red, green and blue.
struct EquationFactor {
    Quantity quantity = Quantity::MaterialDiffuse;
    glm::dvec3 value{1};
    std::string pointer{};  // pointer to the scene's number or colour; empty for a derived value
    bool is_colour = false;
    bool is_mean = false;     // a mean over an area light's samples, weighted by the light arriving from each
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

/// One light at one of the explained pixel's lit points.
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

/// Formats the result of a line; the digits of the factors follow from it.
using NumberText = std::string (*)(double);

/// The number of decimals of each number in a line.
struct LineDecimals {
    std::vector<int> value, exponent;  // one per factor
};

/// The number of decimals for which the factors yield the result as written by `as`, for one channel or for
/// all three.
[[nodiscard]] LineDecimals written_decimals(const EquationLine& line, std::optional<int> channel,
                                            NumberText as);

/// "f 1.5 · L_d 1 · k_d (0.8 0.1 0.1) · n·l 0.871", "(n·h 0.953)^32 = 0.2144, dropped: n·l < 0". Writes one
/// channel, or all three with factors in brackets if their channels differ.
[[nodiscard]] std::string written_product(const EquationLine& line, std::optional<int> channel,
                                          NumberText as);

// Phrases of an explanation, shared by the window and the text output.

/// The visible side of the surface, with the direction of the normal if it does not point towards the eye:
/// "front side", "back side", "back side, n turned towards the eye", "front side, n points away from the
/// eye". Precondition: hit.
[[nodiscard]] std::string side_words(const Explanation& explanation);
/// Whether the pixel looks as expected on a closed surface with outward normals: front side, n towards the
/// eye. Precondition: hit.
[[nodiscard]] bool is_plain_front(const Explanation& explanation);

/// "64 samples" of an area light; "4 of 64 samples so far" while the picture is being refined.
[[nodiscard]] std::string sample_count(const ExplainedLight& explained, const Light& area);

/// The rounding error of n·l for a light in the plane of a face: n·l counts as 0 up to this value.
inline constexpr float grazing_cosine = 1e-5f;

/// The main reason why this light contributes little or nothing at the point: "behind the surface: n·l < 0",
/// "in the shadow of Cube", "outside the cone by 4.2°", "hardly reaches: falloff 0.003". Empty if the light
/// reaches the point.
[[nodiscard]] std::string dark_reason(const ExplainedLight& explained, const Light& light);

// Writes an explanation as JSON, LaTeX and text.

// JSON; docs/explain.md documents each field.

/// The entire explanation; as text it ends with a newline.
[[nodiscard]] Json explanation_json(const Explanation& explanation);
[[nodiscard]] std::string explain_json(const Explanation& explanation);

// LaTeX: the lighting equation of one pixel with its numbers, ready for a slide or a paper.

/// Output for a document that loads amsmath; ends with a newline. One `align*` environment per lit point, one
/// row per term; red, green and blue form a column vector. Escapes names from the scene. Precondition: the
/// explanation describes a pixel of this scene.
[[nodiscard]] std::string explain_latex(const Explanation& explanation, const Scene& scene);

// Text: the lighting equation line by line, each line with its numbers and their result.

/// UTF-8, lines of at most 110 columns unless names are long, ends with a newline. `scene` is the explained
/// scene.
[[nodiscard]] std::string explain_text(const Explanation& explanation, const Scene& scene);

// Chooses the number of digits in an equation, so that the written numbers yield the written result.

/// The maximum number of decimals. A float does not have more.
inline constexpr int most_decimals = 9;

/// The printf format for x with this many decimals (0 to most_decimals): fixed, or scientific from 1e6 on and
/// below 1e-4.
[[nodiscard]] const char* decimal_format(double x, int decimals);
/// Formats x with that format.
[[nodiscard]] std::string decimal_text(double x, int decimals);
/// decimal_text() without trailing zeros: "0.5", "1".
[[nodiscard]] std::string short_text(double x, int decimals);

/// Formats x with this many decimals. Omits the sign of a number that rounds to 0.
[[nodiscard]] std::string fixed_text(double x, int decimals);
/// Returns the number of decimals that show two significant digits of an x between 0.0001 and 1, at least
/// `decimals`; returns `decimals` for any other x.
[[nodiscard]] int significant_decimals(double x, int decimals);
/// Formats x with `decimals` decimals, or more if needed for two significant digits: "0.00012", "1.2e-05".
[[nodiscard]] std::string significant_text(double x, int decimals);

/// One unit of the last digit of a formatted number: 0.001 of "0.713", 1e-7 of "3.21e-05".
[[nodiscard]] double last_digit_of(std::string_view number);

/// Returns the minimum number of decimals for each of `values`, at least its entry in `least`, for which the
/// formula of the rounded values differs by at most `tolerance` from the formula of the exact values. Returns
/// most_decimals if no number of decimals is sufficient.
[[nodiscard]] std::vector<int> decimals_for(std::span<const double> values, std::span<const int> least,
                                            const std::function<double(std::span<const double>)>& formula,
                                            double tolerance);

}  // namespace glint
