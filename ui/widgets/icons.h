#pragma once
// Icons are drawn, so no icon font is needed, and a light's icon can have the light's own colour.

#include <imgui.h>

#include "models/scene/scene.h"

namespace glint {

enum class Icon {
    Bulb,
    Sun,
    Spot,
    Area,
    Camera,
    Object,
    Shading,
    Display,
    Eye,
    EyeOff,
    Plus,
    Undo,
    Redo,
    Close,
    More,
    Folder,
    File,
    Up
};

/// Draws the icon inside the square with edges of length `size` round `centre`, in ImGui's units.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour);

[[nodiscard]] Icon icon_of(LightKind kind);

/// Returns the light's colour at full brightness, for icons and handles; grey for a black light.
[[nodiscard]] ImVec4 colour_of(const Light& light);

/// Returns a light's colour, darkened until it is visible on the theme's panels, for lists.
[[nodiscard]] ImVec4 legible(ImVec4 colour);

/// Draws a square button with an icon, as high as a line of widgets. `on` draws it as chosen.
[[nodiscard]] bool icon_button(const char* id, Icon icon, bool on = false);

}  // namespace glint
