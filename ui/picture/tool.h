#pragma once
// Tools for the picture: only one at a time receives the mouse. Each is a row of functions, and only
// picture_room.cpp decides which one is active.

#include <imgui.h>

#include <glm/vec2.hpp>
#include <string>

#include "ui/commands/keys.h"
#include "ui/picture/screen.h"

namespace glint {

/// Distance in logical pixels at which a tool's line can be grabbed.
inline constexpr float tool_line_reach = 6;

struct UiState;

/// The picture and the mouse, for one frame.
struct ToolFrame {
    UiState& state;
    const PictureView& view;
    const UiInput& input;
    bool over;         // the cursor is over the picture, and no earlier tool has taken it
    glm::dvec2 pixel;  // the cursor, in pixels of the picture
};

inline constexpr int not_taken = -1;

/// Functions that a tool does not need are null.
struct Tool {
    /// Called while no button drags a tool: finds the item under the cursor, and clears it if the cursor is
    /// not `over`. True if this tool takes the cursor, so that later tools are skipped.
    bool (*hover)(ToolFrame&) = nullptr;
    /// Called when a button may have been pressed on the item that hover() found. Returns the button that
    /// drags the tool from now on (ImGui's number), or not_taken.
    int (*press)(ToolFrame&) = nullptr;
    /// Called in every frame of a drag. Returns false when there is nothing left to drag.
    bool (*drag)(ToolFrame&) = nullptr;
    /// Called when the button is released.
    void (*release)(ToolFrame&) = nullptr;
    /// Returns what a drag or click does now, for the status line; empty if the tool does not have the mouse.
    std::string (*hint)(const UiState&) = nullptr;
};

/// The tool that a button drags.
struct ToolCapture {
    const Tool* tool = nullptr;
    int button = not_taken;
};

/// Returns what the tool under the mouse would do, for the status line.
[[nodiscard]] std::string tools_hint(const UiState& state);

/// Escape ends the innermost active item: a drag, a dialog, a sheet, a tool, the picked pixel.
void escape(UiState& state);

extern const Tool hand_tool;  // the camera, and all handles: ui/picture/viewport.cpp
/// Draws the handles of the scene in the picture.
void draw_hand(ImDrawList& list, UiState& state, const PictureView& view);

}  // namespace glint
