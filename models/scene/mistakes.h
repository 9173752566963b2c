#pragma once
// The list of mistakes: what each is called in the scene file (`/shading/mistakes/NAME`), and how it is
// recognised.

#include <span>
#include <string_view>

#include "models/scene/shading.h"

namespace glint {

struct MistakeName {
    std::string_view name;
    bool Mistakes::*flag;
    std::string_view what;  // what is done wrong, and what it looks like: for tooltips and documents
};

/// All of them, in the order of struct Mistakes.
[[nodiscard]] std::span<const MistakeName> mistake_names();

}  // namespace glint
