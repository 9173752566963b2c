#pragma once
// Mistakes as a student's OpenGL program has them: in the text of its shader, in what it hands to it, or in
// what it does with the colours. Independent of renderer/: each is written from what the mistake is.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/scene/scene.h"

namespace glint::oracle {

/// Replaces every `from` in all shaders by `to`.
struct TextChange {
    std::string from, to;
};

struct WrongProgram {
    std::string_view name;  // of the mistake, models/scene/mistakes.h
    std::vector<TextChange> text;
    /// What the program makes of the scene before it draws; false where the mistake has no part in it, or is
    /// not this one.
    std::function<bool(Scene& scene)> scene;
    /// A channel of 0 to 1, after transfer, as it goes on to the byte.
    std::function<float(float shown)> shown;
};

[[nodiscard]] std::span<const WrongProgram> wrong_programs();

}  // namespace glint::oracle
