#pragma once
// Window positions, rectangles, and the fixed parts of the window, which are ImGui windows: columns, bars,
// the picture's area.

#include <imgui.h>

#include <cmath>

namespace glint {

// Vectors in the window, in ImGui's units, y down.
[[nodiscard]] inline ImVec2 operator+(ImVec2 a, ImVec2 b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] inline ImVec2 operator-(ImVec2 a, ImVec2 b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] inline ImVec2 operator*(float s, ImVec2 a) { return {s * a.x, s * a.y}; }
[[nodiscard]] inline ImVec2 operator/(ImVec2 a, float s) { return {a.x / s, a.y / s}; }

[[nodiscard]] inline float length_of(ImVec2 a) { return std::sqrt(a.x * a.x + a.y * a.y); }

/// A rectangle in the window.
struct Rect {
    ImVec2 low, high;
    bool operator==(const Rect& o) const {
        return low.x == o.low.x && low.y == o.low.y && high.x == o.high.x && high.y == o.high.y;
    }
    [[nodiscard]] ImVec2 size() const { return high - low; }
    [[nodiscard]] ImVec2 middle() const { return (low + high) / 2; }
    /// Returns the midpoint of the upper edge.
    [[nodiscard]] ImVec2 top() const { return {middle().x, low.y}; }
    /// Returns whether a point is inside. The left and upper edges are inside, the right and lower ones are
    /// not.
    [[nodiscard]] bool holds(ImVec2 at) const {
        return at.x >= low.x && at.x < high.x && at.y >= low.y && at.y < high.y;
    }
};

/// Whether two rectangles intersect; touching edges do not count.
[[nodiscard]] inline bool overlap(const Rect& a, const Rect& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// Returns a draw list's clip rectangle: for a magnified picture, the part that the columns do not cover.
[[nodiscard]] inline Rect clip_area(const ImDrawList& list) {
    return {list.GetClipRectMin(), list.GetClipRectMax()};
}

/// Returns the rectangle of the item drawn last.
[[nodiscard]] inline Rect last_item() { return {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()}; }

/// The window's parts draw no background: the window is cleared to the colour of panels, which software
/// rendering does far faster than blending a rectangle of the same size.
inline constexpr ImGuiWindowFlags fixed_window =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoBackground;

/// Begins the part named `id` over `area`; ImGui::End() ends it.
inline void begin_area(const char* id, const Rect& area, ImGuiWindowFlags further = 0) {
    ImGui::SetNextWindowPos(area.low);
    ImGui::SetNextWindowSize(area.size());
    ImGui::Begin(id, nullptr, fixed_window | further);
}

/// Continues a part that was begun earlier in this frame.
inline void resume_area(const char* id) { ImGui::Begin(id, nullptr, fixed_window); }

}  // namespace glint
