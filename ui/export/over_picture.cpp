#include "ui/export/over_picture.h"

#include <imgui.h>

#include <algorithm>

#include "ui/widgets/theme.h"

namespace glint {

float begin_over_picture(const char* id, float widest, const Rect& picture, int more) {
    const float width = std::min(widest, ImGui::GetIO().DisplaySize.x - px(20));
    const float middle = std::max((picture.low.x + picture.high.x) / 2, width / 2);
    ImGui::SetNextWindowPos({middle, picture.low.y + px(14)}, ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing | more);
    return width;
}

void end_over_picture() {
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace glint
