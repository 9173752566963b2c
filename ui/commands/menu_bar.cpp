#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>

#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/document/editor.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr std::array named_menus{std::pair{Menu::File, "File"},       std::pair{Menu::Edit, "Edit"},
                                 std::pair{Menu::View, "View"},       std::pair{Menu::Inspect, "Inspect"},
                                 std::pair{Menu::Compare, "Compare"}, std::pair{Menu::Lecture, "Lecture"},
                                 std::pair{Menu::Help, "Help"}};

/// The names of Undo and Redo include the name of the step.
std::string shown_name(const UiState& state, const WindowCommand& command) {
    const History& history = state.editor.history;
    if (command.id == CommandId::Undo && history.can_undo() && !awaits_mesh(state))
        return "Undo " + history.undo_name();
    if (command.id == CommandId::Redo && history.can_redo()) return "Redo " + history.redo_name();
    return command.name;
}

void menu_item(UiState& state, const WindowCommand& command) {
    const std::string refused = why_disabled(state, command);
    const std::string label = shown_name(state, command) + "##" + command.name;
    // The menu shows a command's first key, the shortcuts sheet all of them.
    const std::string keys = command.keys.empty() ? "" : text_of(command.keys[0]);
    if (ImGui::MenuItem(label.c_str(), keys.c_str(), is_on(state, command).value_or(false), refused.empty()))
        run_command(state, command);
    list_control(command.name, "", last_item());
    if (!refused.empty()) tooltip(command.name, refused.c_str());
}

void recent_menu(UiState& state) {
    const auto& recent = state.persistence.preferences.recent;
    const bool open = ImGui::BeginMenu("Open recent", !recent.empty());
    list_control("Open recent", "", last_item());
    if (!open) {
        if (recent.empty()) tooltip("Open recent", "No file has been opened yet");
        return;
    }
    std::string chosen;
    for (const std::string& path : recent) {
        const std::filesystem::path file(path);
        const std::string name = whole_label(file.filename().string());
        const std::string label = fmt::format("{}##{}", name, path);
        if (ImGui::MenuItem(label.c_str())) chosen = path;
        list_control(path.c_str(), "", last_item());
        tooltip(name.c_str(), file.parent_path().string().c_str());
    }
    ImGui::EndMenu();
    if (!chosen.empty()) ask_to_open(state, chosen);
}

void changed_menu(UiState& state) {
    const std::vector<ChangedScene>& list = state.get<RecentlyChanged>().list;
    const bool open = ImGui::BeginMenu("Recently changed", !list.empty());
    list_control("Recently changed", "", last_item());
    if (!open) return;
    const ChangedScene* chosen = nullptr;
    for (const ChangedScene& changed : list) {
        if (ImGui::MenuItem(whole_label(changed.title).c_str())) chosen = &changed;
        list_control(changed.title.c_str(), "", last_item());
    }
    ImGui::EndMenu();
    if (chosen != nullptr) reopen_changed(state, ChangedScene(*chosen));
}

/// Lists the newest steps; clicking one goes back or forward to it.
void history_menu(UiState& state) {
    constexpr std::size_t most = 25;
    const History& history = state.editor.history;
    const bool open = ImGui::BeginMenu("Undo list", history.size() > 1 && !awaits_mesh(state));
    list_control("Undo list", "", last_item());
    if (!open) return;
    std::optional<std::size_t> chosen;
    for (std::size_t i = history.size() > most ? history.size() - most : 0; i < history.size(); ++i) {
        const std::string name = i == 0 ? "As opened" : whole_label(history.name_of(i));
        if (ImGui::MenuItem(fmt::format("{}##{}", name, i).c_str(), "", i == history.at())) chosen = i;
        list_control(fmt::format("Step {}: {}", i, name).c_str(), "", last_item());
    }
    ImGui::EndMenu();
    if (!chosen) return;
    while (history.at() > *chosen) undo(state.editor);
    while (history.at() < *chosen) redo(state.editor);
}

void menu(UiState& state, Menu which, const char* name) {
    const bool open = ImGui::BeginMenu(name);
    list_control(name, "", last_item());
    if (!open) return;
    for (const WindowCommand& command : commands()) {
        if (menu_of(command.section) != which) continue;
        if (command.line_above) ImGui::Separator();
        menu_item(state, command);
        if (command.id == CommandId::Redo) history_menu(state);
        if (command.id != CommandId::Open) continue;
        recent_menu(state);
        changed_menu(state);
    }
    ImGui::EndMenu();
}

/// An action and how to perform it, or a heading if `how` is empty.
struct Line {
    std::string does, how;
    [[nodiscard]] bool is_heading() const { return how.empty(); }
};
using Lines = std::vector<Line>;

void add_mouse_lines(Lines& lines) {
    const Lines mouse{{"Mouse", ""},
                      {"Ask why a pixel has its colour", "Click"},
                      {"Select an object", "Double-click"},
                      {"Orbit", "Drag; on a light or highlight Alt+drag"},
                      {"Pan", "Shift+drag, right or middle drag"},
                      {"Move closer or away", "Wheel, Ctrl+drag"},
                      {"Pan or turn with two fingers", "Shift+scroll, Alt+scroll"},
                      {"Move a light", "Drag its handle or its highlight"},
                      {"Turn the selected light", "Drag its terminator"},
                      {"… in depth, or along an axis", "with Shift, with X Y Z"},
                      {"Open a cone, aim, resize a panel", "Drag the selected light's marks"},
                      {"Move, rotate, scale an object", "Select it, drag its gizmo (G R T)"},
                      {"… on a grid, cancel", "with Ctrl, Esc"},
                      {"Number: change, finely, in steps", "Drag, with Shift, with Ctrl"},
                      {"Number: type, copy or reset", "Click (2*pi, +0.1), right click"}};
    lines.insert(lines.end(), mouse.begin(), mouse.end());
}

/// Every command with a key, in table order, under the headings of the menus.
Lines all_lines() {
    Lines lines;
    const auto add = [&lines](Menu menu, const char* heading) {
        lines.push_back({heading, ""});
        for (const WindowCommand& command : commands())
            if (!command.keys.empty() && menu_of(command.section) == menu)
                lines.push_back({command.name, keys_of(command)});
    };
    for (const auto& [menu, name] : named_menus) add(menu, name);
    add(Menu::None, "Shading, terms, view directions, pixels");
    add_mouse_lines(lines);
    return lines;
}

float height_of(const Line& line) {
    return line.is_heading() ? px(8) + ImGui::GetTextLineHeightWithSpacing()
                             : ImGui::GetTextLineHeightWithSpacing();
}

/// Returns where each of `count` columns of about equal height ends: before a heading if one is near, never
/// right after one.
std::vector<std::size_t> column_ends(const Lines& lines, std::size_t count) {
    float all = 0, before = 0;
    for (const Line& line : lines) all += height_of(line);
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const float spared = lines[i].is_heading() ? 4 * ImGui::GetTextLineHeightWithSpacing() : 0;
        const bool full = before + spared >= all * float(ends.size() + 1) / float(count);
        if (full && i > 0 && !lines[i - 1].is_heading()) ends.push_back(i);
        before += height_of(lines[i]);
    }
    ends.resize(count, lines.size());
    ends.back() = lines.size();
    return ends;
}

/// Draws lines `from` to `to`: action and key, each in its column.
void sheet(const Lines& lines, std::size_t from, std::size_t to) {
    float widest = 0;
    for (std::size_t i = from; i < to; ++i)
        if (!lines[i].is_heading()) widest = std::max(widest, ImGui::CalcTextSize(lines[i].does.c_str()).x);
    ImGui::BeginGroup();
    for (std::size_t i = from; i < to; ++i) {
        if (lines[i].is_heading()) {
            if (i > from) ImGui::SetCursorPosY(ImGui::GetCursorPosY() + px(8));
            dim_text(lines[i].does.c_str());
            continue;
        }
        const float left = ImGui::GetCursorPosX();
        ImGui::TextUnformatted(lines[i].does.c_str());
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + widest +
                             px(14));  // SameLine(offset) is relative to the group, this call is not
        coloured(theme().accent, lines[i].how);
    }
    ImGui::EndGroup();
}

}  // namespace

void menu_bar(UiState& state) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(8), px(6)});
    for (const auto& [which, name] : named_menus) menu(state, which, name);
    ImGui::PopStyleVar();
}

void shortcuts_sheet(UiState& state) {
    if (!state.shows_shortcuts) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {window.x - px(20), window.y - px(20)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(18), px(14)});
    constexpr auto flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                           ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                           ImGuiWindowFlags_HorizontalScrollbar;
    if (ImGui::Begin("Keys and mouse", &state.shows_shortcuts, flags)) {
        ImGui::PushFont(fonts().small);
        const Lines lines = all_lines();
        const bool roomy = window.x > px(1180);
        // With only two columns, the columns are long, so their lines are closer together.
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(8), px(roomy ? 4 : 0)});
        std::size_t from = 0;
        for (const std::size_t end : column_ends(lines, roomy ? 3 : 2)) {
            if (from > 0) ImGui::SameLine(0, px(roomy ? 28 : 14));
            sheet(lines, from, end);
            from = end;
        }
        ImGui::PopStyleVar();
        ImGui::PopFont();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace glint
