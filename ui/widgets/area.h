#pragma once
// The window's fixed parts as ImGui windows: columns, bars, the picture's room.

#include <imgui.h>

namespace glint {

/// A rectangle of the window.
struct Rect {
    ImVec2 low, high;
    [[nodiscard]] ImVec2 size() const { return {high.x - low.x, high.y - low.y}; }
};

/// Without a ground of their own: the window is cleared to the colour of panels, which a graphics card of
/// software does far faster than it blends a rectangle of the same size.
inline constexpr ImGuiWindowFlags fixed_window =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoBackground;

/// Begins the part named `id` over `area`; ImGui::End() ends it.
inline void begin_area(const char* id, const Rect& area, ImGuiWindowFlags further = 0) {
    ImGui::SetNextWindowPos(area.low);
    ImGui::SetNextWindowSize(area.size());
    ImGui::Begin(id, nullptr, fixed_window | further);
}

/// Goes on with a part that was begun before in this frame.
inline void resume_area(const char* id) { ImGui::Begin(id, nullptr, fixed_window); }

}  // namespace glint
