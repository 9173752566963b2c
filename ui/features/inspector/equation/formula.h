#pragma once
// The equation in letters.

#include "models/scene/reflection.h"

namespace glint {

/// Draws it on one line, each letter in its symbol's colour; hovering over a letter explains it.
void formula(Reflection reflection);

}  // namespace glint
