#include "ui/why/heading.h"

#include <fmt/core.h>
#include <imgui.h>

#include "ui/fonts.h"
#include "ui/icons.h"
#include "ui/theme.h"
#include "ui/ui.h"
#include "ui/why/parts.h"
#include "ui/widgets.h"

namespace glint {

void why_heading(UiState& state, const Explanation& why) {
    const float edge = 2 * ImGui::GetTextLineHeight() + px(6);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto [r, g, b] = why.byte;
    list.AddRectFilled(low, {low.x + edge, low.y + edge}, IM_COL32(r, g, b, 255), px(4));
    list.AddRect(low, {low.x + edge, low.y + edge}, packed(theme().line), px(4));
    ImGui::Dummy({edge, edge});
    tooltip("Colour", "As it is on the screen: red, green, blue from 0 to 255",
            fmt::format("{} {} {}   #{:02x}{:02x}{:02x}", r, g, b, r, g, b));
    ImGui::SameLine(0, px(10));
    ImGui::BeginGroup();
    figures(fmt::format("{} {}, {}   {} {} {}", ImGui::GetIO().KeyAlt ? "under" : "pixel", why.x, why.y, r, g,
                        b));
    if (why.hit) {
        if (ImGui::Selectable(fmt::format("{}, face {}", why.object, why.face).c_str(), false, 0,
                              {ImGui::GetContentRegionAvail().x - px(26), 0}))
            state.editor.selection = {Selection::Kind::Object, why.object_index};
        tooltip("Object", "Click to show its panel");
    } else {
        dim_text("background");
    }
    ImGui::EndGroup();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::GetFrameHeight());
    ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, low.y});
    if (icon_button("##forget", Icon::Close)) state.viewport.probe.reset();
    tooltip("Forget this pixel", "Click the picture to pick another");
    ImGui::SetCursorScreenPos({low.x, low.y + edge + px(8)});
}

void why_empty_state(const char* promise) {
    ImGui::Dummy({0, px(10)});
    ImGui::PushFont(fonts().title);
    ImGui::TextUnformatted("Click the picture to ask why");
    ImGui::PopFont();
    wrapped_dim(promise);
    ImGui::Dummy({0, px(6)});
    wrapped_dim("The pixel stays picked while you drag lights and sliders, and the numbers follow.");
    ImGui::Dummy({0, px(6)});
    wrapped_dim("With Alt held, what is under the cursor is asked, without a click.");
}

}  // namespace glint
