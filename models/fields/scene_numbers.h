#pragma once
// Lists every number of a scene by its JSON pointer, to animate it, to differentiate a pixel by it, or to
// drag it in the equation. It is a visitor of scene_fields.h; nothing else enumerates numbers.

#include <optional>
#include <string>
#include <vector>

#include "models/fields/field_kinds.h"
#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

/// One number of a scene.
struct SceneNumber {
    std::string pointer;         // RFC 6901: "/lights/0/falloff/linear", "/camera/eye/2"
    std::string words;           // its text in a panel, without its owner: "view angle", "diffuse red"
    double value = 0;            // the current value
    double initial = 0;          // its default
    Real kind;                   // range, unit, step; for a count, only its range
    std::optional<Count> count;  // for a count: samples, the detail of a shape
    const char* help = "";       // the help of its field
    bool moves_faces = true;     // false: it affects how a pixel is lit, but never which face is visible
    bool applies = true;  // false: no effect at the moment, such as the cone of a light that is not a spot
    bool is_w = false;    // w of a position; the position is divided by it at once, so an input field would
                          // lose the typed value
    float* place = nullptr;  // its address, valid until the scene's lists change; null for a count and for a
                             // const scene
};

/// Lists all numbers in the order of the scene file.
[[nodiscard]] std::vector<SceneNumber> numbers_of(const Scene& scene);

/// The number at that pointer, if there is one.
[[nodiscard]] std::optional<SceneNumber> number_at(Scene& scene, const std::string& pointer);
[[nodiscard]] std::optional<SceneNumber> number_at(const Scene& scene, const std::string& pointer);

/// Sets the number at `pointer`, like `--set`: a light's position is divided by a new w, and an object whose
/// detail changes loses its mesh (load_meshes makes a new one). If the number does not exist, or the value is
/// out of range or breaks a condition of scene_rules.h, the scene stays unchanged and the function returns a
/// problem without a file.
[[nodiscard]] std::optional<Problem> set_number(Scene& scene, const std::string& pointer, double value);

/// Returns SceneNumber::words of that number; for a vector the same without the component ("eye"); else the
/// pointer's keys.
[[nodiscard]] std::string words_of_pointer(const Scene& scene, const std::string& pointer);

}  // namespace glint
