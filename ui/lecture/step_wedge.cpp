#include "ui/lecture/step_wedge.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

ImU32 grey(int value) { return IM_COL32(value, value, value, 255); }

/// The row's patches over the whole width, each to be clicked.
void patches(WedgeRow& row, float height) {
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + height}, grey(row.ground));
    const auto count = wedge_steps.size();
    const float cell = width / static_cast<float>(count), size = std::min(0.6f * cell, 0.55f * height);
    for (std::size_t i = 0; i < count; ++i) {
        const float x = low.x + (static_cast<float>(i) + 0.5f) * cell, y = low.y + 0.45f * height;
        const int value = row.ground + row.sign * wedge_steps[i];
        list.AddRectFilled({x - size / 2, y - size / 2}, {x + size / 2, y + size / 2}, grey(value));
        ImGui::SetCursorScreenPos({x - cell / 2, low.y});
        ImGui::PushID(static_cast<int>(i));
        if (hit_area("##patch", {cell, height})) row.seen = static_cast<int>(i);
        const bool chosen = row.seen == static_cast<int>(i);
        const ImU32 ink = row.ground < 128 ? grey(150) : grey(row.ground == 255 ? 110 : 20);
        if (chosen || ImGui::IsItemHovered())
            list.AddRect({x - cell / 2 + px(3), low.y + px(3)},
                         {x + cell / 2 - px(3), low.y + height - px(3)}, ink, px(4), 0,
                         px(chosen ? 2.0f : 1.0f));
        const std::string label = std::to_string(wedge_steps[i]);
        const ImVec2 text = ImGui::CalcTextSize(label.c_str());
        list.AddText({x - text.x / 2, low.y + height - text.y - px(7)}, ink, label.c_str());
        ImGui::PopID();
    }
    ImGui::SetCursorScreenPos({low.x, low.y + height + px(4)});
}

}  // namespace

std::string wedge_words(const WedgeRow& row) {
    if (row.seen < 0)
        return fmt::format("On {}: click the first patch that the last row of the room can see", row.name);
    if (row.seen == 0) return fmt::format("On {} every step is seen", row.name);
    const auto seen = std::min(static_cast<std::size_t>(row.seen), wedge_steps.size() - 1);
    return fmt::format("On {} this projector swallows steps below {}/255: colours {:.3f} apart look the same",
                       row.name, wedge_steps[seen], double(wedge_steps[seen - 1]) / 255);
}

void step_wedge(WedgeState& wedge) {
    if (!wedge.open) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(window);
    ImGui::Begin("##wedge", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushFont(fonts().title);
    ImGui::TextUnformatted("Step wedge");
    ImGui::PopFont();
    ImGui::SameLine(0, px(12));
    dim_text("Each patch differs from its ground by so many of 255 steps");
    ImGui::SameLine(window.x - px(100));
    if (ImGui::Button("Close", {px(88), 0})) wedge.open = false;
    const float words = ImGui::GetTextLineHeightWithSpacing() + px(10);
    const float height = ImGui::GetContentRegionAvail().y / float(wedge.rows.size()) - words;
    for (WedgeRow& row : wedge.rows) {
        ImGui::PushID(row.name);
        patches(row, std::max(height, px(20)));
        ImGui::TextUnformatted(wedge_words(row).c_str());
        ImGui::Dummy({0, px(2)});
        ImGui::PopID();
    }
    ImGui::End();
}

}  // namespace glint
