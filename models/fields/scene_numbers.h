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
    std::string words;           // as its panel calls it, without its owner: "view angle", "diffuse red"
    double value = 0;            // what it is now
    double initial = 0;          // its default
    Real kind;                   // range, unit, step; of a count its range
    std::optional<Count> count;  // of a count: samples, the detail of a shape
    const char* help = "";       // its field's words
    bool moves_faces = true;     // false: it decides how a pixel is lit, never which face it shows
    bool applies = true;  // false: without effect at the moment, as the cone of a light that is not a spot
    bool is_w = false;    // of a position, which is divided by it at once: a field for it would not keep what
                          // is typed
    float* place = nullptr;  // where it stands, valid while the scene's lists do not change; null for a
                             // count, and where the scene was const
};

/// Lists all numbers in the order of the scene file.
[[nodiscard]] std::vector<SceneNumber> numbers_of(const Scene& scene);

/// The number at that pointer, if there is one.
[[nodiscard]] std::optional<SceneNumber> number_at(Scene& scene, const std::string& pointer);
[[nodiscard]] std::optional<SceneNumber> number_at(const Scene& scene, const std::string& pointer);

/// Sets the number at `pointer`, as `--set` would: a light's position is divided by a new w, an object whose
/// detail changes loses its mesh (load_meshes makes it again). Where there is no such number, or the value is
/// out of range or breaks a condition of scene_rules.h, the scene stays as it was and the problem, which
/// names no file, says why.
[[nodiscard]] std::optional<Problem> set_number(Scene& scene, const std::string& pointer, double value);

/// Returns SceneNumber::words of the number there; of a vector the same without the component ("eye"); else
/// the pointer's keys.
[[nodiscard]] std::string words_of_pointer(const Scene& scene, const std::string& pointer);

}  // namespace glint
