#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/mistake_row.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// The size of the thumbnails: aspect ratio 4:3, at most a third of the column wide.
PictureSize small_size(float room, bool keeps_width) {
    const int width = static_cast<int>(std::clamp(std::min(px(96), room / 3), 8.0f, 192.0f));
    return {width, width * 3 / 4, keeps_width};
}

/// The picture to compare with, above the list, which scrolls below it.
void right_row(UiState& state, const SmallLook& look) {
    Mistakes& mistakes = state.editor.scene().shading.mistakes;
    ImGui::SetCursorScreenPos(ImGui::GetCursorScreenPos() + ImVec2(small_inset(), small_inset()));
    draw_small(look, 0, ImGui::GetCursorScreenPos());
    ImGui::Dummy(look.extent());
    tooltip("Without mistakes", "The open scene without mistakes, to compare with");
    ImGui::SameLine(0, px(8));
    ImGui::BeginGroup();
    ImGui::TextUnformatted("Without mistakes");
    if (!look.pictures.problem.empty()) {
        warning_text(look.pictures.problem);
    } else if (mistakes_on(mistakes) == 0) {
        small_dim("Hover over a row to preview it; click to switch it on.");
    } else {
        warning_text(mistakes_text(mistakes));
        if (ImGui::Button("All off")) mistakes = {};
        tooltip("All off", "The correct equation");
    }
    ImGui::EndGroup();
    ImGui::Separator();
}

/// Draws the rows below the headings of their groups, and scrolls to `wanted` if it is not null. Returns the
/// hovered one.
const MistakeName* mistake_rows(Mistakes& mistakes, const SmallLook& look, const MistakeName* wanted) {
    const MistakeName* pointed = nullptr;
    std::optional<SeenAs> group;
    int index = 0;
    for (const std::size_t place : mistakes_as_seen()) {
        const MistakeName& mistake = mistake_names()[place];
        if (group != mistake.seen_as) section_heading(std::string(heading_of(mistake.seen_as)).c_str());
        group = mistake.seen_as;
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() - px(2));  // the rows have their own margins
        if (mistake_row(mistake, mistakes.*mistake.flag, look, ++index)) pointed = &mistake;
        if (&mistake == wanted) ImGui::SetScrollHereY(0.3f);
    }
    return pointed;
}

/// The mistakes that are on, in the tab's order.
std::vector<const MistakeName*> names_on(const Mistakes& mistakes) {
    std::vector<const MistakeName*> on;
    for (const std::size_t place : mistakes_as_seen())
        if (mistakes.*mistake_names()[place].flag) on.push_back(&mistake_names()[place]);
    return on;
}

}  // namespace

int mistakes_on(const Mistakes& mistakes) { return static_cast<int>(names_on(mistakes).size()); }

std::string mistakes_text(const Mistakes& mistakes) {
    constexpr std::size_t max_named = 2;
    const std::vector<const MistakeName*> on = names_on(mistakes);
    if (on.empty()) return {};
    std::string text = on.size() == 1 ? "Mistake: " : fmt::format("{} mistakes: ", on.size());
    for (std::size_t i = 0; i < std::min(on.size(), max_named); ++i)
        text.append(i == 0 ? "" : ", ").append(title_of(*on[i]));
    return on.size() > max_named ? text + ", …" : text;
}

void show_mistake(UiState& state, const MistakeName* mistake) {
    const auto on = names_on(state.editor.scene().shading.mistakes);
    state.get<InspectorState>().wanted_mistake = mistake == nullptr && !on.empty() ? on.front() : mistake;
    state.get<InspectorState>().tab = InspectorTab::Mistakes;
    state.layout.right = state.left_shows_inspector = true;
}

void mistakes_tab(UiState& state, const PictureView& view) {
    const PictureSize size = small_size(ImGui::GetContentRegionAvail().x, view.map.size.keeps_width);
    look_at_mistake_pictures(state, size);
    const SmallLook look{state.get<MistakePictures>().pictures, size};
    // In a short window it scrolls with the list, which would otherwise have no room.
    const bool stays = ImGui::GetContentRegionAvail().y > 4 * look.extent().y;
    if (stays) right_row(state, look);
    ImGui::BeginChild("##rows");
    if (!stays) right_row(state, look);
    Mistakes& mistakes = state.editor.scene().shading.mistakes;
    const MistakeName* const pointed =
        mistake_rows(mistakes, look, std::exchange(state.get<InspectorState>().wanted_mistake, nullptr));
    ImGui::EndChild();
    if (pointed == nullptr) return;
    const bool on = mistakes.*pointed->flag;
    Scene other = state.editor.scene();
    other.shading.mistakes.*pointed->flag = !on;
    show_instead(state, other, on ? "without: " + title_of(*pointed) : title_of(*pointed));
}

}  // namespace glint
