#pragma once
// Places labels without overlaps, each as near to its preferred position as earlier labels allow. The most
// important labels come first.

#include <imgui.h>

#include <optional>
#include <vector>

#include "ui/widgets/area.h"

namespace glint {

class LabelRoom {
  public:
    LabelRoom() = default;
    /// Labels stay within `bounds` if they fit.
    explicit LabelRoom(const Rect& bounds) : bounds_(bounds) {}

    /// No label may cover `area`.
    void keep_free(const Rect& area) { taken_.push_back(area); }

    /// Finds a centre for a label of `size`, at most `reach` away from `wanted`, and reserves that area.
    /// Returns nothing and reserves nothing if there is not enough room.
    [[nodiscard]] std::optional<ImVec2> place(ImVec2 wanted, ImVec2 size, float reach);

    /// Returns place(), or `wanted` if there is not enough room.
    [[nodiscard]] ImVec2 place_anyhow(ImVec2 wanted, ImVec2 size, float reach);

  private:
    [[nodiscard]] bool is_free(const Rect& area) const;
    [[nodiscard]] ImVec2 inside(ImVec2 middle, ImVec2 size) const;
    std::optional<Rect> bounds_;
    std::vector<Rect> taken_;
};

}  // namespace glint
