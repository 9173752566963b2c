#pragma once
// Labels do not cover one another: each stands as near to where it would like to be as those before it
// let it. The most important ones first.

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

    /// The middle of a label of `size` that would like its middle at `wanted`, at most `reach` away from
    /// there; its room is taken from now on. Nothing, and nothing taken, where there is no room.
    [[nodiscard]] std::optional<ImVec2> place(ImVec2 wanted, ImVec2 size, float reach);

    /// As place(), but where there is no room it returns `wanted`.
    [[nodiscard]] ImVec2 place_anyhow(ImVec2 wanted, ImVec2 size, float reach);

  private:
    [[nodiscard]] bool is_free(const Rect& area) const;
    [[nodiscard]] ImVec2 inside(ImVec2 middle, ImVec2 size) const;
    std::optional<Rect> bounds_;
    std::vector<Rect> taken_;
};

}  // namespace glint
