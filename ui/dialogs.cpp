#include "ui/dialogs.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "models/file.h"
#include "models/mesh_file.h"
#include "renderer/image_file.h"
#include "ui/actions.h"
#include "ui/fonts.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace glint {
namespace {

bool pressed(const UiInput& input, Key key) {
    return std::any_of(input.presses.begin(), input.presses.end(),
                       [key](const KeyPress& p) { return p.key == key; });
}

void unsaved_question(UiState& state, bool enter) {
    static constexpr const char* id = "Unsaved changes##question";
    if (!state.pending.asking) return;
    if (!ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal(
            id, nullptr,
            ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove))
        return;
    ImGui::TextUnformatted(fmt::format("{} has changes that are not saved.", state.editor.title()).c_str());
    ImGui::Dummy({px(380), px(6)});
    if (ImGui::Button("Save", {px(110), 0}) || enter) {
        state.pending.asking = false;
        if (save(state)) finish_pending(state);
    }
    ImGui::SameLine();
    if (ImGui::Button("Don't save", {px(110), 0})) finish_pending(state);
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {px(110), 0})) state.pending = {};
    if (!state.pending.asking) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void save_picture(UiState& state, const std::string& path) {
    const std::string bytes = png_bytes(*state.picture, scene_text(state.drawn));
    const Result<std::monostate> written = write_file(path, bytes);
    if (const Problem* problem = problem_of(written)) return state.notifications.add(*problem);
    state.notifications.add(Tone::Done,
                            fmt::format("Saved {}", std::filesystem::path(path).filename().string()));
}

/// A mesh file for the object that asked, or for a new one. The path is kept absolute: saving makes it
/// relative.
void use_mesh(UiState& state, const std::string& path) {
    Editor& editor = state.editor;
    const MeshFile source{std::filesystem::absolute(path).string()};
    if (state.mesh_for_object >= 0 &&
        static_cast<std::size_t>(state.mesh_for_object) < editor.scene().objects.size()) {
        Object& object = editor.scene().objects[static_cast<std::size_t>(state.mesh_for_object)];
        object.source = source;
        object.mesh = nullptr;
    } else if (const auto index = add_object(editor.scene(), source)) {
        editor.selection = {Selection::Kind::Object, *index};
    }
    state.mesh_for_object = -1;
    if (const auto problem = settle(editor)) state.notifications.add(*problem);
}

void use_file(UiState& state, const std::string& path) {
    switch (state.files.purpose) {
    case FilePurpose::OpenScene:
        return begin_pending(state, {Pending::What::Open, path, false});
    case FilePurpose::OpenMesh:
        return use_mesh(state, path);
    case FilePurpose::SavePicture:
        return save_picture(state, path);
    case FilePurpose::SaveScene:
        if (const auto problem = save_file(state.editor, path)) {
            state.pending = {};
            return state.notifications.add(*problem);
        }
        state.notifications.add(Tone::Done, fmt::format("Saved {}", state.editor.title()));
        return finish_pending(state);
    }
}

struct MouseLine {
    const char *does, *how;
};
constexpr std::array mouse_lines{
    MouseLine{"Ask why a pixel has its colour", "Click"},
    MouseLine{"Select an object", "Double-click"},
    MouseLine{"Orbit", "Drag"},
    MouseLine{"Pan", "Shift+drag, right or middle drag"},
    MouseLine{"Closer, away", "Wheel, Ctrl+drag"},
    MouseLine{"Move a light", "Drag its handle"},
    MouseLine{"… in depth, along an axis", "with Shift, with X Y Z"},
    MouseLine{"… on a grid, cancel", "with Ctrl, Esc"},
    MouseLine{"Number: finer, type, default", "Shift, Ctrl+click, double-click"},
};

using Lines = std::vector<std::pair<std::string, std::string>>;

Lines mouse_words() {
    Lines lines;
    for (const MouseLine& line : mouse_lines) lines.emplace_back(line.does, line.how);
    return lines;
}

/// The keys of an action that has several stand in one line.
Lines key_words() {
    Lines lines;
    for (const ActionInfo& info : actions()) {
        if (*info.keys == 0) continue;
        if (!lines.empty() && lines.back().first == info.name)
            lines.back().second.append(" or ").append(info.keys);
        else
            lines.emplace_back(info.name, info.keys);
    }
    return lines;
}

/// What is done, and how, in two columns.
void sheet(const Lines& lines) {
    float widest = 0;
    for (const auto& [does, how] : lines) widest = std::max(widest, ImGui::CalcTextSize(does.c_str()).x);
    ImGui::BeginGroup();
    for (const auto& [does, how] : lines) {
        const float left = ImGui::GetCursorPosX();
        ImGui::TextUnformatted(does.c_str());
        ImGui::SameLine(left + widest + px(16));
        dim_text(how.c_str());
    }
    ImGui::EndGroup();
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
                           ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("Keys and mouse", &state.shows_shortcuts, flags)) {
        sheet(mouse_words());
        ImGui::SameLine(0, px(36));
        sheet(key_words());
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace

void dialogs(UiState& state, const UiInput& input) {
    const bool enter = pressed(input, Key::Enter);
    unsaved_question(state, enter);
    if (const auto path = draw_file_dialog(state.files, enter)) use_file(state, *path);
    if (!state.files.open && !state.pending.asking) state.pending = {};  // the name was not given
    shortcuts_sheet(state);
}

void take_dropped(UiState& state, const UiInput& input) {
    if (input.dropped.empty()) return;
    begin_pending(state, {Pending::What::Open, input.dropped.front(), false});
    if (input.dropped.size() > 1)
        state.notifications.add(Tone::Warning, "Several files were dropped; the first was opened");
}

}  // namespace glint
