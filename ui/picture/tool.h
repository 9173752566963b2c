#pragma once
// Tools on the picture: one at a time has the mouse. Each is a row of functions, and only picture_room.cpp
// decides which one.

#include <imgui.h>

#include <glm/vec2.hpp>
#include <string>

#include "ui/commands/keys.h"
#include "ui/picture/screen.h"

namespace glint {

/// Logical pixels within which a tool's line is taken.
inline constexpr float tool_line_reach = 6;

struct UiState;

/// The picture and the mouse, for one frame.
struct ToolFrame {
    UiState& state;
    const PictureView& view;
    const UiInput& input;
    bool over;         // the cursor is over the picture, and no tool before this one has it
    glm::dvec2 pixel;  // the cursor, in pixels of the picture
};

inline constexpr int not_taken = -1;

/// Functions that a tool does not need are null.
struct Tool {
    /// Called while no button holds a tool: finds what is under the cursor, and forgets it if the cursor is
    /// not `over`. True if this tool takes the cursor: then no tool after it is asked.
    bool (*hover)(ToolFrame&) = nullptr;
    /// Called when a button may have gone down on what hover() found. Returns the button that holds the tool
    /// from now on (ImGui's number), or not_taken.
    int (*press)(ToolFrame&) = nullptr;
    /// Called in every frame while it is held. False when there is nothing to drag any more.
    bool (*drag)(ToolFrame&) = nullptr;
    /// The button went up.
    void (*release)(ToolFrame&) = nullptr;
    /// Says for the status line what a drag or click does now; empty when the tool has not the mouse.
    std::string (*hint)(const UiState&) = nullptr;
};

/// The tool that a button holds.
struct ToolCapture {
    const Tool* tool = nullptr;
    int button = not_taken;
};

/// Says for the status line what the tool under the mouse would do.
[[nodiscard]] std::string tools_hint(const UiState& state);

/// Escape leaves the innermost thing: a drag, a dialog, a sheet, a tool, the picked pixel.
void escape(UiState& state);

extern const Tool hand_tool;  // the camera, and all handles: ui/picture/viewport.cpp
/// Draws the handles, of the scene that the picture shows.
void draw_hand(ImDrawList& list, UiState& state, const PictureView& view);

}  // namespace glint
