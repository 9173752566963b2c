#pragma once
// How the picture is looked at: none of it is the scene's.

#include "ui/views/scope.h"

namespace glint {

struct ViewsState {
    ScopeState scope;
};

}  // namespace glint
