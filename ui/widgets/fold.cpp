#include "ui/widgets/fold.h"

#include <imgui.h>
#include <imgui_internal.h>

#include "ui/widgets/fonts.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

bool fold(const char* title, bool open_at_first, bool opens) {
    ImGui::PushID(title);
    bool* const open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("##open"), open_at_first);
    *open |= opens;
    const float height = ImGui::GetTextLineHeight() + px(6);
    if (hit_area("##fold", {ImGui::GetContentRegionAvail().x, height})) *open = !*open;
    const Rect row = last_item();
    list_control(title, "", row);
    const ImVec4& ink = ImGui::IsItemHovered() ? theme().text : theme().dim_text;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 middle{row.low.x + px(5), row.middle().y};
    const float r = px(4);
    if (*open)
        list.AddTriangleFilled(middle + ImVec2(-r, -r / 2), middle + ImVec2(r, -r / 2),
                               middle + ImVec2(0, r * 0.7f), to_u32(ink));
    else
        list.AddTriangleFilled(middle + ImVec2(-r / 2, -r), middle + ImVec2(r * 0.7f, 0),
                               middle + ImVec2(-r / 2, r), to_u32(ink));
    list.AddText({row.low.x + px(14), row.low.y + px(3)}, to_u32(ink), title,
                 ImGui::FindRenderedTextEnd(title));
    ImGui::PopID();
    return *open;
}

}  // namespace glint
