#pragma once
// The equation of one light is a product of named numbers: some are held by the scene, and a hand can drag
// them, the others follow. Their values are those of the renderer's explanation.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "models/fields/scene_numbers.h"
#include "models/scene/scene.h"
#include "renderer/inspect/explain/explanation.h"
#include "ui/widgets/theme.h"

namespace glint {

/// A number of the scene where it stands in the equation. Valid while the scene's lists do not change.
struct NumberHandle {
    SceneNumber number;  // with its place
    std::string name;    // "shininess of Teapot"
};
/// The number at `pointer` of the scene, named by its keys and its light's or object's name. Precondition: it
/// exists.
[[nodiscard]] NumberHandle number_handle(Scene& scene, const std::string& pointer);

/// One factor of a term.
struct Factor {
    Symbol symbol = Symbol::Diffuse;
    const char* letter = "";  // in the symbol's colour: "k"
    const char* index = "";   // its subscript
    float value = 1;
    std::optional<NumberHandle> number{};            // set: the value is the scene's
    std::optional<NumberHandle> exponent{};          // `value` is then a base, raised to this
    float clamped_from = 0;                          // below 0: what the value was before it was clamped to 0
    std::optional<std::pair<Symbol, Symbol>> dot{};  // set: the value is the cosine between these vectors
};

/// letter = product of the factors = result, in one channel.
struct TermLine {
    Symbol symbol = Symbol::Diffuse;
    const char* letter = "";
    bool on = true;
    std::vector<Factor> factors;
    float result = 0;
};

/// One light at one point, whose terms are asked for.
struct LightInEquation {
    Scene& scene;
    const Explanation& explanation;
    const ExplainedLight& light;
    int channel = 0;  // 0 red, 1 green, 2 blue
};

/// Ambient, diffuse and specular, in this order. For an area light, whose samples each have their own
/// factors, only the numbers of the scene are listed.
[[nodiscard]] std::vector<TermLine> term_lines(const LightInEquation& in);

/// The factor of all three terms of a light: intensity, falloff, spot factor.
[[nodiscard]] float share_of(const ExplainedLight& explained, const Light& light);

/// k_a · global ambient, and the emission: what there is without a light. Emission first.
[[nodiscard]] std::vector<TermLine> unlit_lines(Scene& scene, const Explanation& explanation,
                                                const ExplainedPoint& point, int channel);

}  // namespace glint
