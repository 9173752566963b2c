#pragma once
// Finds where a difference lies that no mistake explains: on which objects, and in which term of the
// equation.

#include "renderer/diagnose/diagnose.h"

namespace glint {

/// Fills in the diagnosis's regions and terms. `renderer` has drawn the right picture last.
void describe_difference(Diagnosis& diagnosis, const Renderer& renderer, const Exhibit& exhibit,
                         const DisplayChange& change, const Display& display);

}  // namespace glint
