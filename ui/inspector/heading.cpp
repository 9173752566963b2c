#include <fmt/core.h>
#include <imgui.h>

#include "ui/inspector/equation/parts.h"
#include "ui/inspector/tabs.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

namespace {

/// Where the heading's square of colour lies.
struct Square {
    ImVec2 low;
    float edge;
    [[nodiscard]] ImVec2 high() const { return {low.x + edge, low.y + edge}; }
};

void nothing_picked(const Square& square) {
    ImGui::GetWindowDrawList()->AddRect(square.low, square.high(), to_u32(theme().line), px(4));
    ImGui::Dummy({square.edge, square.edge});
    ImGui::SameLine(0, px(10));
    ImGui::BeginGroup();
    dim_text("no pixel picked");
    ImGui::PushFont(fonts().title);
    ImGui::TextUnformatted("Click the picture to ask why");
    ImGui::PopFont();
    ImGui::EndGroup();
}

void picked(UiState& state, const Explanation& explanation, const Square& square) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto [r, g, b] = explanation.byte;
    list.AddRectFilled(square.low, square.high(), IM_COL32(r, g, b, 255), px(4));
    list.AddRect(square.low, square.high(), to_u32(theme().line), px(4));
    ImGui::Dummy({square.edge, square.edge});
    tooltip("Colour", "As it is on the screen: red, green, blue from 0 to 255",
            fmt::format("{} {} {}   #{:02x}{:02x}{:02x}", r, g, b, r, g, b));
    ImGui::SameLine(0, px(10));
    ImGui::BeginGroup();
    mono_text(fmt::format("{} {}, {}   {} {} {}", ImGui::GetIO().KeyAlt ? "under" : "pixel", state.asked.x,
                          state.asked.y, r, g, b));
    if (explanation.hit) {
        if (ImGui::Selectable(fmt::format("{}, face {}", explanation.object, explanation.face).c_str(), false,
                              0, {ImGui::GetContentRegionAvail().x - px(26), 0}))
            state.editor.selection = {Selection::Kind::Object, explanation.object_index};
        tooltip("Object", "Click to show its panel");
    } else {
        dim_text("background");
    }
    ImGui::EndGroup();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::GetFrameHeight());
    ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, square.low.y});
    if (icon_button("##forget", Icon::Close)) state.viewport.probe.reset();
    tooltip("Forget this pixel", "Click the picture to pick another");
}

}  // namespace

void inspector_heading(UiState& state) {
    const Square square{ImGui::GetCursorScreenPos(), 2 * ImGui::GetTextLineHeight() + px(6)};
    if (state.explanation)
        picked(state, *state.explanation, square);
    else
        nothing_picked(square);
    ImGui::SetCursorScreenPos({square.low.x, square.high().y + px(8)});
}

void inspector_empty_state(const char* promise) {
    ImGui::Dummy({0, px(4)});
    wrapped_dim(promise);
    ImGui::Dummy({0, px(6)});
    wrapped_dim("The pixel stays picked while you drag lights and sliders, and the numbers follow.");
    ImGui::Dummy({0, px(6)});
    wrapped_dim("With Alt held, what is under the cursor is asked, without a click.");
}

}  // namespace glint
