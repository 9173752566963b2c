#include "ui/inspector/equation/parts.h"

#include <fmt/core.h>
#include <imgui.h>

#include "ui/inspector/equation/words.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/widgets.h"

namespace glint {

void coloured(Symbol symbol, const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme()[symbol]);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

void warning_text(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme().warning);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void wrapped_dim(const std::string& text) {
    ImGui::PushTextWrapPos(0);
    dim_text(text.c_str());
    ImGui::PopTextWrapPos();
}

void small_dim(const std::string& text) {
    ImGui::PushFont(fonts().small);
    wrapped_dim(text);
    ImGui::PopFont();
}

void vector_line(Symbol symbol, const char* name, glm::vec3 v) {
    coloured(symbol, name);
    ImGui::SameLine(px(112));
    mono_text(fmt::format("{} {} {}", shown_number(v.x), shown_number(v.y), shown_number(v.z)));
}

bool is_pointed_at() {
    return ImGui::IsItemHovered() && !ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive();
}

bool is_pointed_at(ImVec2 low, ImVec2 high) {
    constexpr bool clipped = false;  // a row of a table is wider than the cell drawn last
    return ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high, clipped) &&
           !ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive();
}

}  // namespace glint
