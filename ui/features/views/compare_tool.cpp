// The comparison in the window: its lines and labels under the mouse, and its controls in the row above the
// picture.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/features/views/compare_view.h"
#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double apart = 0.02;  // the smallest distance between lines, as a share of the width

/// The position of a line in the window: x, or y if the parts are stacked.
float line_at(const CompareChoice& choice, int wipe, const PictureView& view) {
    const int at = first_of(choice, wipe + 1, length_of(choice, view.map.size));
    const ImVec2 place = view.to_window({at, at});
    return choice.stacked ? place.y : place.x;
}

/// The part of the window that a part of the comparison covers.
Rect part_rect(const CompareChoice& choice, int part, const PictureView& view) {
    const PartRect rect = part_rect(choice, part, view.map.size);
    return {view.to_window(rect.low), view.to_window(rect.high)};
}

/// The position of a part's label: centred at the top of the part.
Rect label_rect(const CompareState& state, int part, const PictureView& view) {
    const Rect room = part_rect(state.choice, part, view);
    const float left = room.low.x, right = room.high.x;
    const std::string label = part_label(state, static_cast<std::size_t>(part));
    const ImVec2 text = fonts().small->CalcTextSizeA(small_text_height(), 1e9f, 0, label.c_str());
    const ImVec2 half{std::min(text.x / 2 + px(8), (right - left) / 2), text.y / 2 + px(4)};
    const ImVec2 middle{(left + right) / 2, room.low.y + px(8) + half.y};
    return {middle - half, middle + half};
}

void find_under(CompareState& state, const PictureView& view) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    for (int i = 0; i < static_cast<int>(state.choice.parts.size()); ++i)
        if (label_rect(state, i, view).holds(mouse)) state.label_under = i;
    if (state.label_under >= 0 || state.choice.difference) return;
    for (int i = 0; i < static_cast<int>(state.choice.wipes.size()); ++i)
        if (std::abs((state.choice.stacked ? mouse.y : mouse.x) - line_at(state.choice, i, view)) <=
            px(tool_line_reach))
            state.under = i;
}

void drag(CompareState& state, const PictureView& view) {
    std::vector<double>& wipes = state.choice.wipes;
    const auto i = static_cast<std::size_t>(state.dragged);
    const double low = i == 0 ? 0 : wipes[i - 1] + apart;
    const double high = i + 1 == wipes.size() ? 1 : wipes[i + 1] - apart;
    const glm::dvec2 at = view.to_pixel(ImGui::GetIO().MousePos);
    const double share = (state.choice.stacked ? at.y : at.x) / length_of(state.choice, view.map.size);
    wipes[i] = std::clamp(share, std::min(low, high), std::max(low, high));
}

void draw_wipe(ImDrawList& list, const CompareState& state, int wipe, const PictureView& view) {
    const bool stacked = state.choice.stacked;
    const Rect before = part_rect(state.choice, wipe, view);
    const ImVec2 end = before.high,
                 start = stacked ? ImVec2(before.low.x, end.y) : ImVec2(end.x, before.low.y);
    const ImVec2 middle = (start + end) / 2, way = stacked ? ImVec2(0, 1) : ImVec2(1, 0);
    const bool lit = state.under == wipe || state.dragged == wipe;
    const ImU32 white = to_u32({1, 1, 1, 1});
    cased_line(list, start, end, white, lit ? 1.8f : 1);
    rimmed_disc(list, middle, lit ? 8.5f : 6.5f, white);
    for (const float side : {-1.0f, 1.0f})  // the two directions in which the line can move
        arrow_head(list, middle + px(5) * side * way, side * way, 3.5f, 3.5f, to_u32({0.2f, 0.2f, 0.2f, 1}));
}

void draw_label(ImDrawList& list, const CompareState& state, int part, const PictureView& view) {
    const Rect rect = label_rect(state, part, view);
    badge_ground(list, rect, state.label_under == part);
    list.PushClipRect(rect.low, rect.high, true);
    const std::string label = part_label(state, static_cast<std::size_t>(part));
    list.AddText(fonts().small, small_text_height(), rect.low + px(1) * ImVec2(8, 4), to_u32(theme().text),
                 label.c_str());
    list.PopClipRect();
}

/// Draws a row of a list, disabled if `variant` has nothing to show. True when clicked.
bool variant_row(const CompareChoice& choice, const std::string& label, Variant variant, bool chosen) {
    const bool lacks_b = lacks_stored(choice, variant), lacks_mine = lacks_picture(choice, variant);
    const bool can = !lacks_b && !lacks_mine;
    const bool clicked = ImGui::Selectable(label.c_str(), chosen, can ? 0 : ImGuiSelectableFlags_Disabled);
    if (lacks_b) tooltip(label.c_str(), "Store a scene first", "", keys_of(CommandId::StoreB));
    if (lacks_mine) tooltip(label.c_str(), "Drop a picture on the window first");
    return clicked;
}

void settings_popup(CompareState& state) {
    if (state.asked >= static_cast<int>(state.choice.parts.size())) state.asked = -1;
    if (!ImGui::BeginPopup("##part")) return;
    if (state.asked < 0) ImGui::CloseCurrentPopup();
    Variant::Kind last = Variant::Kind::Edited;
    for (const Variant& setting : all_variants()) {
        if (state.asked < 0) break;
        Variant& part = state.choice.parts[static_cast<std::size_t>(state.asked)];
        if (setting.kind != last) ImGui::Separator();
        last = setting.kind;
        if (variant_row(state.choice, label_of(setting), setting, part == setting)) part = setting;
    }
    ImGui::EndPopup();
}

/// Finds what can be dragged (lines) or clicked (labels).
bool compare_hover(ToolFrame& frame) {
    CompareState& state = frame.state.get<CompareState>();
    state.under = state.label_under = -1;
    if (!state.choice.on || !frame.over) return false;
    find_under(state, frame.view);
    if (state.under >= 0)
        ImGui::SetMouseCursor(state.choice.stacked ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
    if (state.label_under >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return state.under >= 0 || state.label_under >= 0;
}

int compare_press(ToolFrame& frame) {
    CompareState& state = frame.state.get<CompareState>();
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return not_taken;
    state.dragged = state.under;
    if (state.label_under >= 0) {
        state.asked = state.label_under;
        ImGui::OpenPopup("##part");
    }
    return state.dragged >= 0 ? ImGuiMouseButton_Left : not_taken;
}

bool compare_drag(ToolFrame& frame) {
    CompareState& state = frame.state.get<CompareState>();
    if (!state.choice.on || state.dragged >= static_cast<int>(state.choice.wipes.size())) {
        state.dragged = -1;
        return false;
    }
    drag(state, frame.view);
    ImGui::SetMouseCursor(state.choice.stacked ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
    return true;
}

void compare_release(ToolFrame& frame) { frame.state.get<CompareState>().dragged = -1; }

std::string compare_hint(const UiState& ui) {
    const CompareState& state = ui.get<CompareState>();
    if (!state.choice.on) return {};
    if (state.under >= 0 || state.dragged >= 0) return "Drag the line";
    return state.label_under >= 0 ? "Click: what this part shows" : "";
}

/// Describes the picture, which may be entirely black.
void difference_caption(ImDrawList& list, const CompareState& state) {
    const CompareChoice& choice = state.choice;
    std::string what =
        fmt::format("|{} − {}|", part_label(state, 0), part_label(state, choice.parts.size() - 1));
    if (choice.gain > 1) what += fmt::format(" × {}", choice.gain);
    const std::string most = state.numbers.differing_pixels == 0
                                 ? "no pixel differs"
                                 : fmt::format("at most {} of 255", state.numbers.max_error);
    const char* const black = state.numbers.differing_pixels == 0 ? "" : ", black where they agree";
    ImGui::PushFont(fonts().small);
    // Shorter text over a narrow picture.
    const Rect area = clip_area(list);
    const float room = area.size().x - px(20);
    std::string text = most;
    for (const std::string& longer :
         {fmt::format("{}: {}{}", what, most, black), fmt::format("{}: {}", what, most)})
        if (ImGui::CalcTextSize(longer.c_str()).x <= room) {
            text = longer;
            break;
        }
    (void)badge(list, area.top() + ImVec2(0, px(8)), text, {0.5f, 0});
    ImGui::PopFont();
}

struct Preset {
    const char* label;
    std::vector<Variant> parts;
};

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all{
        {"Flat, Gouraud, Phong",
         {variant_of(ShadingMode::Flat), variant_of(ShadingMode::Gouraud), variant_of(ShadingMode::Phong)}},
        {"Gouraud, Phong", {variant_of(ShadingMode::Gouraud), variant_of(ShadingMode::Phong)}},
        {"Facet, Phong", {variant_of(ShadingMode::Facet), variant_of(ShadingMode::Phong)}},
        {"Phong, Blinn–Phong", {variant_of(Reflection::Phong), variant_of(Reflection::BlinnPhong)}},
        {"Local, with shadows, with bounces",
         {variant_of(TransportModel::Local), variant_of(TransportModel::Shadows),
          variant_of(TransportModel::Bounces)}},
        {"As edited, B", {{}, {Variant::Kind::Stored, 0}}},
        {"As edited, my picture", {{}, {Variant::Kind::Mine, 0}}}};
    return all;
}

void presets_popup(CompareChoice& choice) {
    if (small_button("Parts##presets")) ImGui::OpenPopup("##presets");
    tooltip("The compared variants", "Or click a label on the picture to choose one part");
    ImGui::SameLine(0, px(4));
    if (!ImGui::BeginPopup("##presets")) return;
    for (const Preset& preset : presets()) {
        if (variant_row(choice, preset.label, preset.parts.back(), choice.parts == preset.parts))
            set_parts(choice, preset.parts);
    }
    ImGui::EndPopup();
}

/// Not used by a difference.
void direction_button(CompareChoice& choice) {
    if (small_chosen_button("Stacked", choice.stacked)) choice.stacked ^= true;
    tooltip("Stacked", "The parts one above the other, not side by side");
}

void difference_controls(CompareState& state) {
    CompareChoice& choice = state.choice;
    if (small_button(fmt::format("×{}###gain", choice.gain).c_str())) double_gain(choice);
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) choice.gain = std::max(choice.gain / 2, 1);
    tooltip("Scale of the difference", "Click: double, after ×64 back to ×1 · Right click: halve");
    ImGui::SameLine(0, px(8));
    const Comparison& n = state.numbers;
    mono_text(fmt::format("max {}  mean {:.2f}", n.max_error, (n.mean[0] + n.mean[1] + n.mean[2]) / 3));
    tooltip(
        "How far apart", "Largest and mean difference of the first and the last part, in steps of 0 to 255",
        fmt::format("max {} {} {}\nmean {:.3f} {:.3f} {:.3f}\nroot of mean square {:.3f} {:.3f} {:.3f}\n{} "
                    "pixels differ",
                    n.max[0], n.max[1], n.max[2], n.mean[0], n.mean[1], n.mean[2], n.rmse[0], n.rmse[1],
                    n.rmse[2], n.differing_pixels));
    ImGui::SameLine(0, px(4));
}

}  // namespace

const Tool compare_tool{compare_hover, compare_press, compare_drag, compare_release, compare_hint};

void draw_compare(ImDrawList& list, UiState& ui, const PictureView& view) {
    CompareState& state = ui.get<CompareState>();
    if (!state.choice.on) return;
    if (!state.choice.difference) {
        for (int i = 0; i < static_cast<int>(state.choice.wipes.size()); ++i) draw_wipe(list, state, i, view);
        for (int i = 0; i < static_cast<int>(state.choice.parts.size()); ++i)
            draw_label(list, state, i, view);
    }
    ui.label_height = small_text_height() + px(10);
    if (state.choice.difference) difference_caption(list, state);
    settings_popup(state);
}

void compare_controls(CompareState& state) {
    CompareChoice& choice = state.choice;
    if (!choice.on) return;
    presets_popup(choice);
    if (small_chosen_button("Difference", choice.difference)) choice.difference = !choice.difference;
    tooltip("Difference",
            (part_label(state, 0) + " against " + part_label(state, choice.parts.size() - 1)).c_str(),
            "Red, green and blue separately, of the displayed picture");
    ImGui::SameLine(0, px(4));
    const auto rest = [&] { choice.difference ? difference_controls(state) : direction_button(choice); };
    overflow("##compare", px(choice.difference ? 190 : 60), rest);
}

}  // namespace glint
