// The context menu of a number.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "models/problem.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/numbers/expression.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

bool item(const char* name, const std::string& about, bool possible = true) {
    const bool chosen = ImGui::MenuItem(name, about.c_str(), false, possible);
    list_control(name, "", last_item());
    return chosen;
}

void copy(const std::string& text) {
    ImGui::SetClipboardText(text.c_str());
    say(fmt::format("{} is on the clipboard", text));
}

/// True if the clipboard contained another number. If reading it failed, the window has reported that.
bool paste(float& value, const Range& range) {
    const char* text = ImGui::GetClipboardText();
    if (text == nullptr) return false;
    const Calculated found = calculated(text, double(value));
    if (!found.problem.empty()) {
        say_refused("The clipboard has no number: " + on_one_line(found.problem));
        return false;
    }
    const bool edited = assign(value, found.value, range);
    if (!range.contains(found.value)) say_out_of_range(found.value, range, value);
    return edited;
}

}  // namespace

bool number_menu(float& value, const NumberInput& input) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(8), px(6)});
    const bool open = ImGui::BeginPopup(number_menu_id);
    ImGui::PopStyleVar();
    if (!open) return false;
    ImGui::PushFont(fonts().body);
    ImGui::PushStyleColor(ImGuiCol_Text, theme().text);  // regardless of the number's own colour
    const float before = value;
    bool edited = false;
    if (item("Copy", exact_text(value))) copy(exact_text(value));
    if (item("Paste", "")) edited = paste(value, input.kind.range);
    const bool has_default = !std::isnan(input.initial);
    if (has_default && item("Reset to default", exact_text(input.initial), value != input.initial)) {
        value = input.initial;
        edited = true;
    }
    if (value == input.initial && !edited) tooltip("Reset to default", "It is already the default");
    if (!input.pointer.empty()) {
        ImGui::Separator();
        const bool advanced = ImGui::BeginMenu("Advanced");
        list_control("Advanced", "", last_item());
        if (advanced) {
            if (item("Copy pointer", input.pointer)) copy(input.pointer);
            ImGui::EndMenu();
        }
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::EndPopup();
    return edited && value != before;
}

}  // namespace glint
