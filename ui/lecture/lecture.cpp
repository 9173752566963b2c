#include "ui/lecture/lecture.h"

#include "ui/ui.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"

namespace glint {
bool leave_lecture_tool(UiState& state) {
    LectureState& lecture = state.lecture;
    if (lecture.wedge.open) return !(lecture.wedge.open = false);
    if (lecture.pen.on) return !(lecture.pen.on = false);
    if (state.layout.bare) return !(state.layout.bare = false);
    return false;
}

void keep_frozen(UiState& state) {
    const auto& frozen = state.lecture.frozen;
    if (!frozen) return;
    state.preview = *frozen;
}

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
