#pragma once
// The equation in letters.

#include "models/scene/reflection.h"

namespace glint {

/// Draws it on one line, each letter in its symbol's colour; resting on a letter tells what it stands for.
void formula(Reflection reflection);

}  // namespace glint
