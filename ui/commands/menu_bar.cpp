#include "ui/commands/menu_bar.h"

#include <imgui.h>

#include <filesystem>

#include "ui/commands/actions.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Undo and redo say what they would undo.
std::string shown_name(const UiState& state, const ActionInfo& info) {
    const History& history = state.editor.history;
    if (info.action == Action::Undo && history.can_undo()) return "Undo " + history.undo_name();
    if (info.action == Action::Redo && history.can_redo()) return "Redo " + history.redo_name();
    return *info.menu_name != 0 ? info.menu_name : info.name;
}

void menu_item(UiState& state, const ActionInfo& info) {
    const std::string refused = why_not(state, info.action);
    const std::string label = shown_name(state, info) + "##" + info.name;
    if (ImGui::MenuItem(label.c_str(), info.keys, is_on(state, info.action).value_or(false), refused.empty()))
        run_action(state, info.action);
    if (!refused.empty()) tooltip(info.name, refused.c_str());
}

void recent_menu(UiState& state) {
    const auto& recent = state.memory.recent;
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
    for (const ActionInfo& info : actions()) {
        if (info.menu != which) continue;
        if (info.after_line) ImGui::Separator();
        menu_item(state, info);
        if (info.action == Action::Open) recent_menu(state);
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
