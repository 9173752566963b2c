#pragma once
// How the picture is looked at: none of it is the scene's.

#include <cstdint>

#include "ui/picture/magnifier.h"
#include "ui/plots/plots_tab.h"
#include "ui/views/compare_view.h"
#include "ui/views/debug_view_controls.h"
#include "ui/views/lit_dots.h"
#include "ui/views/scope.h"
#include "ui/views/term_grid.h"

namespace glint {

/// What the shown picture is made from, beside the drawn one: as long as it stays, so does the picture.
struct ShownFrom {
    CompareChoice compare;
    DebugViewSet debug_view;
    bool linear = false;
    bool operator==(const ShownFrom&) const = default;
};

struct ViewsState {
    ScopeState scope;
    CompareState compare;
    DebugViewState debug_view;
    PlotsState plots;
    MagnifierState magnifier;
    LitDotsState lit;
    TermGridState grid;
    int threads = 0;  // of further renderers
    // What the shown picture was made from:
    ShownFrom shown_from;
    std::uint64_t shown_serial = 0;  // UiState::picture_serial then
};

}  // namespace glint
