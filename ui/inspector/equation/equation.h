#pragma once
// The lighting equation in letters, each in its symbol's colour.

#include "models/scene/scene.h"

namespace glint {

/// One line, as wide as the equation is long.
void equation(Reflection reflection);

}  // namespace glint
