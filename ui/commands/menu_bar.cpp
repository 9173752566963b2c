#include <imgui.h>

#include <filesystem>

#include "ui/commands/command.h"
#include "ui/commands/menus.h"
#include "ui/document/document_actions.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Undo and redo say what they would undo.
std::string shown_name(const UiState& state, const WindowCommand& command) {
    const History& history = state.editor.history;
    if (command.id == CommandId::Undo && history.can_undo()) return "Undo " + history.undo_name();
    if (command.id == CommandId::Redo && history.can_redo()) return "Redo " + history.redo_name();
    return command.name;
}

void menu_item(UiState& state, const WindowCommand& command) {
    const std::string refused = why_disabled(state, command);
    const std::string label = shown_name(state, command) + "##" + command.name;
    // Of several keys the first; the sheet of shortcuts shows all.
    const std::string keys = command.keys.empty() ? "" : text_of(command.keys[0]);
    if (ImGui::MenuItem(label.c_str(), keys.c_str(), is_on(state, command).value_or(false), refused.empty()))
        run_command(state, command);
    if (!refused.empty()) tooltip(command.name, refused.c_str());
}

void recent_menu(UiState& state) {
    const auto& recent = state.persistence.recent;
    if (!ImGui::BeginMenu("Open recent", !recent.empty())) return;
    std::string chosen;
    for (const std::string& path : recent) {
        const std::filesystem::path file(path);
        const std::string label = file.filename().string() + "##" + path;
        if (ImGui::MenuItem(label.c_str())) chosen = path;
        tooltip(file.filename().string().c_str(), file.parent_path().string().c_str());
    }
    ImGui::EndMenu();
    if (!chosen.empty()) begin_pending(state, {Pending::What::Open, chosen, false});
}

void menu(UiState& state, Menu which, const char* name) {
    if (!ImGui::BeginMenu(name)) return;
    for (const WindowCommand& command : commands()) {
        if (command.menu != which) continue;
        if (command.line_above) ImGui::Separator();
        menu_item(state, command);
        if (command.id == CommandId::Open) recent_menu(state);
    }
    ImGui::EndMenu();
}

}  // namespace

void menu_bar(UiState& state) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(8), px(6)});
    menu(state, Menu::File, "File");
    menu(state, Menu::Edit, "Edit");
    menu(state, Menu::View, "View");
    menu(state, Menu::Lecture, "Lecture");
    menu(state, Menu::Help, "Help");
    ImGui::PopStyleVar();
}

}  // namespace glint
