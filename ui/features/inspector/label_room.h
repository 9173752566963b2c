#pragma once
// Finds places for labels that do not cover one another: each lies as near to its wanted place as those
// before it let it. The most important labels come first.

#include <imgui.h>

#include <optional>
#include <vector>

#include "ui/widgets/area.h"

namespace glint {

class LabelRoom {
  public:
    LabelRoom() = default;
    /// Nothing is written outside `bounds`, as far as it fits in.
    explicit LabelRoom(const Rect& bounds) : bounds_(bounds) {}

    /// Nothing may be written over `area`.
    void keep_free(const Rect& area) { taken_.push_back(area); }

    /// Finds the middle for a label of `size`, at most `reach` away from `wanted`, and takes that room from
    /// now on. Returns nothing, and takes nothing, if there is no room.
    [[nodiscard]] std::optional<ImVec2> place(ImVec2 wanted, ImVec2 size, float reach);

    /// Returns place(), or `wanted` where there is no room.
    [[nodiscard]] ImVec2 place_anyhow(ImVec2 wanted, ImVec2 size, float reach);

  private:
    [[nodiscard]] bool is_free(const Rect& area) const;
    [[nodiscard]] ImVec2 inside(ImVec2 middle, ImVec2 size) const;
    std::optional<Rect> bounds_;
    std::vector<Rect> taken_;
};

}  // namespace glint
