#pragma once
// Mistakes in a student's OpenGL program: in the text of its shader, in the data passed to it, or in the
// treatment of colours. Independent of renderer/: each is written from the definition of the mistake.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/scene/scene.h"

namespace glint::oracle {

/// Replaces every `from` in all shaders with `to`.
struct TextChange {
    std::string from, to;
};

struct WrongProgram {
    std::string_view name;  // of the mistake, as in models/scene/mistakes.h
    std::vector<TextChange> text;
    /// Changes the scene before the program draws it. Returns false if the mistake does not apply to the
    /// scene or is not of this kind.
    std::function<bool(Scene& scene)> scene;
    /// Changes a channel in [0, 1], after transfer and before conversion to a byte.
    std::function<float(float shown)> shown;
};

[[nodiscard]] std::span<const WrongProgram> wrong_programs();

}  // namespace glint::oracle
