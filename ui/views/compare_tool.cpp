// The comparison under the hand: its lines and labels.
#include <algorithm>
#include <cmath>

#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/views/compare_view.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float line_reach = 6;  // units of the design within which a line is taken
constexpr double apart = 0.02;   // of the width: lines never come nearer to one another

/// Where a line lies in the window: its x, or stacked its y.
float line_at(const CompareChoice& choice, int wipe, const PictureView& view) {
    const int at = first_of(choice, wipe + 1, length_of(choice, view.map.size));
    const ImVec2 place = view.to_window({at, at});
    return choice.stacked ? place.y : place.x;
}

/// The part of the window that a part of the comparison covers.
Rect part_rect(const CompareChoice& choice, int part, const PictureView& view) {
    const PictureSize size = view.map.size;
    const int length = length_of(choice, size);
    const int first = first_of(choice, part, length), end = first_of(choice, part + 1, length);
    return choice.stacked ? Rect{view.to_window({0, first}), view.to_window({size.width, end})}
                          : Rect{view.to_window({first, 0}), view.to_window({end, size.height})};
}

/// Where a part's label lies: at the top of its part, in its middle.
Rect label_rect(const CompareChoice& choice, int part, const PictureView& view) {
    const Rect room = part_rect(choice, part, view);
    const float left = room.low.x, right = room.high.x;
    const ImVec2 text = fonts().small->CalcTextSizeA(
        small_text_height(), 1e9f, 0, label_of(choice.parts[static_cast<std::size_t>(part)]).c_str());
    const ImVec2 half{std::min(text.x / 2 + px(8), (right - left) / 2), text.y / 2 + px(4)};
    const ImVec2 middle{(left + right) / 2, room.low.y + px(8) + half.y};
    return {{middle.x - half.x, middle.y - half.y}, {middle.x + half.x, middle.y + half.y}};
}

bool holds(const Rect& rect, ImVec2 at) {
    return at.x >= rect.low.x && at.x < rect.high.x && at.y >= rect.low.y && at.y < rect.high.y;
}

void find_under(CompareState& state, const PictureView& view) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    for (int i = 0; i < static_cast<int>(state.choice.parts.size()); ++i)
        if (holds(label_rect(state.choice, i, view), mouse)) state.label_under = i;
    if (state.label_under >= 0 || state.choice.difference) return;
    for (int i = 0; i < static_cast<int>(state.choice.wipes.size()); ++i)
        if (std::abs((state.choice.stacked ? mouse.y : mouse.x) - line_at(state.choice, i, view)) <=
            px(line_reach))
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
    const ImVec2 middle{(start.x + end.x) / 2, (start.y + end.y) / 2};
    const bool lit = state.under == wipe || state.dragged == wipe;
    list.AddLine(start, end, to_u32({0, 0, 0, 1}, 0.6f), px(3));
    list.AddLine(start, end, to_u32({1, 1, 1, 1}), px(lit ? 1.8f : 1));
    list.AddCircleFilled(middle, px(lit ? 10 : 8), to_u32({0, 0, 0, 1}, 0.6f));
    list.AddCircleFilled(middle, px(lit ? 8.5f : 6.5f), to_u32({1, 1, 1, 1}));
    const ImU32 ink = to_u32({0.2f, 0.2f, 0.2f, 1});
    // `along` the way the line can go, `across` it.
    const auto at = [&](float along, float across) {
        return stacked ? ImVec2(middle.x + px(across), middle.y + px(along))
                       : ImVec2(middle.x + px(along), middle.y + px(across));
    };
    for (const float side : {-1.0f, 1.0f})
        list.AddTriangleFilled(at(side * 5, 0), at(side * 1.5f, -3.5f), at(side * 1.5f, 3.5f), ink);
}

void draw_label(ImDrawList& list, const CompareState& state, int part, const PictureView& view) {
    const Rect rect = label_rect(state.choice, part, view);
    const bool lit = state.label_under == part;
    list.AddRectFilled(rect.low, rect.high, to_u32(lit ? theme().field_active : theme().window, 0.88f),
                       px(6));
    list.PushClipRect(rect.low, rect.high, true);
    list.AddText(fonts().small, small_text_height(), {rect.low.x + px(8), rect.low.y + px(4)},
                 to_u32(theme().text), label_of(state.choice.parts[static_cast<std::size_t>(part)]).c_str());
    list.PopClipRect();
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
        const bool can = setting.kind != Variant::Kind::Stored || state.choice.stored != nullptr;
        const auto flags = can ? 0 : ImGuiSelectableFlags_Disabled;
        if (ImGui::Selectable(label_of(setting).c_str(), part == setting, flags)) part = setting;
        if (!can) tooltip("B, stored", "Store a scene first", "", keys_of(CommandId::StoreB));
    }
    ImGui::EndPopup();
}

/// Lines are dragged, labels clicked. The scope's line that is about to be drawn may begin on either.
bool compare_hover(ToolFrame& frame) {
    CompareState& state = frame.state.views.compare;
    state.under = state.label_under = -1;
    if (!state.choice.on || !frame.over || frame.state.views.scope.armed) return false;
    find_under(state, frame.view);
    if (state.under >= 0)
        ImGui::SetMouseCursor(state.choice.stacked ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
    if (state.label_under >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return state.under >= 0 || state.label_under >= 0;
}

int compare_press(ToolFrame& frame) {
    CompareState& state = frame.state.views.compare;
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return not_taken;
    state.dragged = state.under;
    if (state.label_under >= 0) {
        state.asked = state.label_under;
        ImGui::OpenPopup("##part");
    }
    return state.dragged >= 0 ? ImGuiMouseButton_Left : not_taken;
}

bool compare_drag(ToolFrame& frame) {
    CompareState& state = frame.state.views.compare;
    if (!state.choice.on || state.dragged >= static_cast<int>(state.choice.wipes.size())) {
        state.dragged = -1;
        return false;
    }
    drag(state, frame.view);
    ImGui::SetMouseCursor(state.choice.stacked ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
    return true;
}

void compare_release(ToolFrame& frame) { frame.state.views.compare.dragged = -1; }

std::string compare_hint(const UiState& ui) {
    const CompareState& state = ui.views.compare;
    if (!state.choice.on) return {};
    if (state.under >= 0 || state.dragged >= 0) return "Drag the line";
    return state.label_under >= 0 ? "Click: what this part shows" : "";
}

/// Lines and labels; the list of a part's settings once its label was clicked.
void draw_compare(ImDrawList& list, UiState& ui, const PictureView& view) {
    CompareState& state = ui.views.compare;
    if (!state.choice.on) return;
    if (!state.choice.difference) {
        for (int i = 0; i < static_cast<int>(state.choice.wipes.size()); ++i) draw_wipe(list, state, i, view);
        for (int i = 0; i < static_cast<int>(state.choice.parts.size()); ++i)
            draw_label(list, state, i, view);
    }
    settings_popup(state);
}

}  // namespace

const Tool compare_tool{compare_hover, compare_press, compare_drag, compare_release,
                        nullptr,       compare_hint,  draw_compare};

}  // namespace glint
