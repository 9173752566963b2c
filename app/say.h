#pragma once
// A line on standard error for people.

#include "models/problem.h"

namespace glint {

/// "glint: KIND: the problem": one line of at most 4096 bytes, with control characters escaped. When standard
/// error is gone nobody is told.
void say(const char* kind, Problem problem);

/// Says, in the same form, what was tolerated.
void say_warning(const std::string& warning);

}  // namespace glint
