#pragma once
// The lighting equation in symbols.

#include "models/scene/reflection.h"
#include "models/scene/transport.h"

namespace glint {

/// Draws it on one line, each symbol in its colour; hovering over a symbol explains it.
void formula(Reflection reflection, TransportModel transport);

}  // namespace glint
