#pragma once
// Part of stage 4: which pixels have to be coloured again, and which show already what they should.

#include "renderer/shade/lighting.h"

namespace glint {

/// What is to be done in 16 runs of pixels; bit i: run i. The others show what they should already.
struct RunsToDo {
    unsigned light = 0xFFFF;  // with the moving light, or with all
    unsigned leave_dark = 0;  // show the sum of the others: the moving light has just left them
};
/// Of runs 16 `batch` and on, and notes it as done. May be called for several batches at once.
RunsToDo runs_to_do(Lighting& lighting, const Surface& surface, std::size_t batch);

}  // namespace glint
