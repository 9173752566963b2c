#pragma once
// Describes a picture that no mistake explains.

#include "diagnose/judged.h"

namespace glint {

/// Fills in the diagnosis of a picture that nothing fits: whether it can be compared at all, and where the
/// difference lives. `none`: the judgement without a mistake.
void say_what_is_unexplained(Diagnosis& diagnosis, Renderer& renderer, const Scene& scene,
                             const Exhibit& exhibit, const Judged& none);

}  // namespace glint
