#include "ui/features/inspector/blocks_in_sight.h"

#include <imgui.h>

namespace glint {

void BlocksInSight::begin(int count) {
    heights_.resize(static_cast<std::size_t>(count));
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    const float low = list.GetClipRectMin().y, high = list.GetClipRectMax().y;
    // A margin on both sides lets the Tab key find the next field and scroll to it.
    low_ = low - (high - low) / 2, high_ = high + (high - low) / 2;
    top_ = ImGui::GetCursorScreenPos().y;
}

bool BlocksInSight::begin_block(int index, bool is_wanted) {
    const float height = heights_[static_cast<std::size_t>(index)];
    const float room = height > 0 ? height : lines_ * ImGui::GetTextLineHeightWithSpacing();
    const bool is_near = top_ <= high_ && top_ + room >= low_;
    if (!is_near && !is_wanted && index != held_) {
        top_ += room;
        return false;
    }
    ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, top_});
    ImGui::BeginGroup();
    return true;
}

void BlocksInSight::end_block(int index) {
    ImGui::EndGroup();
    if (ImGui::IsItemActive())
        held_ = index;
    else if (held_ == index)
        held_ = -1;
    const float below = ImGui::GetCursorScreenPos().y;
    heights_[static_cast<std::size_t>(index)] = below - top_;
    top_ = below;
}

void BlocksInSight::end() { ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, top_}); }

}  // namespace glint
