#pragma once
// The window's fixed parts as ImGui windows: columns, bars, the picture's room.

#include <imgui.h>

#include "ui/layout.h"

namespace glint {

inline constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                                 ImGuiWindowFlags_NoSavedSettings |
                                                 ImGuiWindowFlags_NoBringToFrontOnFocus;

/// Begins the part named `id` over `area`; ImGui::End() ends it.
inline void begin_area(const char* id, const Rect& area, ImGuiWindowFlags further = 0) {
    ImGui::SetNextWindowPos(area.low);
    ImGui::SetNextWindowSize(area.size());
    ImGui::Begin(id, nullptr, fixed_window | further);
}

/// Goes on with a part that was begun before in this frame.
inline void resume_area(const char* id) { ImGui::Begin(id, nullptr, fixed_window); }

}  // namespace glint
