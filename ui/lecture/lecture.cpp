#include "ui/lecture/lecture.h"

#include "ui/ui.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"

namespace glint {

void frozen_badge(ImDrawList& list, const LectureState& lecture, const PictureView& view) {
    if (!lecture.frozen) return;
    const std::string text = "Frozen (" + keys_of(CommandId::Freeze) + ")";
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 low{view.origin.x + px(10), view.origin.y + px(10)};
    list.AddRectFilled(low, {low.x + size.x + px(16), low.y + size.y + px(8)}, packed(theme().window, 0.85f),
                       px(6));
    list.AddText({low.x + px(8), low.y + px(4)}, packed(theme().text), text.c_str());
}

}  // namespace glint
