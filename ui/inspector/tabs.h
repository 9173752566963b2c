#pragma once
// The WHY column: the picked pixel, and tabs that each look at it in another way. Its tabs are a closed list.

#include <span>

#include "ui/inspector/state.h"

namespace glint {

struct UiState;
struct PictureView;

/// A tab: what it is called, what its tooltip says, and what draws it below the tab bar.
struct WhyTabInfo {
    WhyTab tab;
    const char* label;
    const char* what;
    void (*draw)(UiState&, const PictureView&);
};

/// All tabs, from left to right. To add one: a name in WhyTab, its line here in tabs.cpp, its own file.
[[nodiscard]] std::span<const WhyTabInfo> why_tabs();

/// Draws heading, tab bar and the chosen tab into the current window. After the picture, so that numbers are
/// of what is on the screen.
void why_column(UiState& state, const PictureView& view);

}  // namespace glint
