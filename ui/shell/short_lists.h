#pragma once
// What ImGui draws, in lists that any driver can draw. Its indices have 16 bits: where a window is full of
// marks and text, a command counts its vertices from a place further on in its list (ImDrawCmd::VtxOffset),
// which OpenGL knows from 3.2 on only.

#include <imgui.h>

#include <memory>
#include <vector>

namespace glint {

/// Lists that draw the triangles of `list` in the same order, with its clip rectangles and textures; every
/// command counts from the first vertex of its list.
[[nodiscard]] std::vector<std::unique_ptr<ImDrawList>> short_lists(const ImDrawList& list);

/// Whether the list is none of these itself.
[[nodiscard]] bool counts_from_further_on(const ImDrawList& list);

}  // namespace glint
