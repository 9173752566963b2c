#include "ui/features/inspector/equation/copy_menu.h"

#include <imgui.h>

#include <string_view>

#include "ui/widgets/named_controls.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Formats a number for use in a program: without surrounding spaces, and with an ASCII minus.
std::string plain(std::string_view number) {
    constexpr std::string_view minus = "−";
    std::string text;
    while (!number.empty()) {
        const bool is_minus = number.starts_with(minus);
        if (is_minus || number.front() != ' ' || !text.empty()) text += is_minus ? '-' : number.front();
        number.remove_prefix(is_minus ? minus.size() : 1);
    }
    return text;
}

void copy_item(const char* label, const std::string& text) {
    if (ImGui::MenuItem(label)) {
        ImGui::SetClipboardText(text.c_str());
        say(text + " is on the clipboard");
    }
    list_control(label, "", last_item());
}

}  // namespace

void copy_menu(int id, const std::string& number, const std::string& line) {
    ImGui::PushID(id);
    tooltip("Right click: copy it", line.empty() ? "" : "alone, or its entire line");
    if (ImGui::BeginPopupContextItem("##copy")) {
        copy_item("Copy", plain(number));
        if (!line.empty()) copy_item("Copy line", line);
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

}  // namespace glint
