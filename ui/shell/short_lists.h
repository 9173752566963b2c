#pragma once
// Splits what ImGui draws into lists that any driver can draw. ImGui's indices have 16 bits. If a window is
// full of marks and text, a command counts its vertices from an offset into its list (ImDrawCmd::VtxOffset),
// which OpenGL supports only from 3.2 on.

#include <imgui.h>

#include <memory>
#include <vector>

namespace glint {

/// Lists that draw the triangles of `list` in the same order, with its clip rectangles and textures; every
/// command counts from the first vertex of its list.
[[nodiscard]] std::vector<std::unique_ptr<ImDrawList>> short_lists(const ImDrawList& list);

/// Whether the list has to be split: a command counts from an offset above 0.
[[nodiscard]] bool counts_from_further_on(const ImDrawList& list);

}  // namespace glint
