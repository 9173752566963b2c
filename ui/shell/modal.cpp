#include "ui/shell/modal.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "models/io/file.h"
#include "renderer/image/image_file.h"
#include "ui/document/document_actions.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/export/animation.h"
#include "ui/features/export/export_picture.h"
#include "ui/features/games/quiz.h"
#include "ui/features/lecture/examples.h"
#include "ui/features/lessons/lessons_dialog.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

bool pressed(const UiInput& input, Key key) {
    return std::any_of(input.presses.begin(), input.presses.end(),
                       [key](const KeyPress& p) { return p.key == key; });
}

/// What keys answer, below the buttons.
void key_words(const char* words) {
    ImGui::Dummy({0, px(2)});
    small_dim(words);
}

void unsaved_question(UiState& state, const UiInput& input) {
    const bool enter = pressed(input, Key::Enter);
    if (!begin_question("Unsaved changes##question")) return;
    ImGui::TextUnformatted(fmt::format("{} has changes that are not saved.", state.editor.title()).c_str());
    ImGui::Dummy({px(380), px(6)});
    if (ImGui::Button("Save", {px(110), 0}) || enter_answers(enter)) {
        state.pending.asking = false;
        if (save(state)) finish_pending(state);
    }
    ImGui::SameLine();
    if (ImGui::Button("Don't save", {px(110), 0}) || enter_answers(pressed(input, Key::D)))
        finish_pending(state);
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {px(110), 0})) state.pending = {};
    key_words("Enter: save  ·  D: don't save  ·  Esc: cancel");
    if (!state.pending.asking) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

/// Enter chooses nothing here: every answer but Cancel gives something up or needs a name.
void changed_question(UiState& state, const UiInput& input) {
    if (!begin_question("Changed by another##question")) return;
    const std::string title = state.editor.title();
    ImGui::TextUnformatted(
        fmt::format("{} was changed by another program since it was opened here.", title).c_str());
    ImGui::Dummy({px(460), px(6)});
    const auto answer = [&](const char* name, const char* what, Key key) {
        const bool chosen = ImGui::Button(name, {px(110), 0}) || enter_answers(pressed(input, key));
        tooltip(name, what);
        state.asks_overwrite = state.asks_overwrite && !chosen;
        return chosen;
    };
    if (answer("Overwrite", "What the other program wrote is lost", Key::O) && save_over(state))
        finish_pending(state);
    ImGui::SameLine();
    if (answer("Save as…", "Under another name: both are kept", Key::S))
        state.files.ask(FilePurpose::SaveScene, offered_name(state, ".json"));
    ImGui::SameLine();
    if (answer("Reload", "What was changed here since the last saving is lost", Key::R)) reload(state);
    ImGui::SameLine();
    if (answer("Cancel", "Nothing is saved", Key::Escape)) state.pending = {};
    key_words("O: overwrite  ·  S: save as  ·  R: reload  ·  Esc: cancel");
    if (!state.asks_overwrite) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

/// The path is kept absolute: saving makes it relative.
void use_mesh(UiState& state, const std::string& path) {
    const int object = std::exchange(state.mesh_for_object, -1);
    std::error_code failed;
    const std::filesystem::path whole = std::filesystem::absolute(path, failed);
    if (failed)  // the folder that the program was started in is gone
        return state.notifications.add(
            Problem{path, "", "cannot be made absolute: " + failed.message(), "a path from the root"});
    begin_mesh(state, MeshFile{whole.string()}, object);
}

void use_file(UiState& state, const std::string& path) {
    switch (state.files.purpose) {
    case FilePurpose::OpenScene:
        return begin_pending(state, Pending::What::Open, path);
    case FilePurpose::OpenMesh:
        return use_mesh(state, path);
    case FilePurpose::MyPicture:
        return bring_picture(state, path);
    case FilePurpose::SavePicture:
        return begin_export(state, {state.full_size, 1}, path);
    case FilePurpose::SaveAnswers:
        return save_answers(state, path);
    case FilePurpose::SaveFrames:
        return begin_frames(state, path, state.get<ExportState>().options.size,
                            state.get<ExportState>().options.samples);
    case FilePurpose::ExportPicture:
        return begin_export(state, state.get<ExportState>().options, path);
    case FilePurpose::SaveScene:
        if (is_among_shipped(state, path)) {
            state.files.ask(FilePurpose::SaveScene, std::filesystem::path(path).filename().string());
            return state.notifications.add(
                Problem{path, "", "is in the folder of Glint's examples", "a folder of your own"});
        }
        if (save_as(state, path)) finish_pending(state);
        return;
    }
}

}  // namespace

Modal modal_of(const UiState& state) {
    if (state.pending.asking) return Modal::Unsaved;
    if (state.asks_overwrite) return Modal::Changed;
    if (state.files.open) return Modal::Files;
    if (state.get<ExportState>().open) return Modal::Export;
    if (state.get<ExamplesState>().open) return Modal::Examples;
    if (state.get<LessonListState>().open) return Modal::Lessons;
    if (state.get<QuizState>().open) return Modal::Quiz;
    return Modal::None;
}

void leave_modal(UiState& state) {
    switch (modal_of(state)) {
    case Modal::None:
        return;
    case Modal::Unsaved:
        state.pending = {};
        return;
    case Modal::Changed:
        state.asks_overwrite = false;
        state.pending = {};
        return;
    case Modal::Files:
        state.files.open = false;
        state.pending = {};
        return;
    case Modal::Export:
        state.get<ExportState>().open = false;
        return;
    case Modal::Examples:
        state.get<ExamplesState>().open = false;
        return;
    case Modal::Lessons:
        state.get<LessonListState>().open = false;
        return;
    case Modal::Quiz:
        state.get<QuizState>().open = false;
        return;
    }
}

void leave_dialogs_of_scene(UiState& state) {
    const bool files = state.files.open && is_about_scene(state.files.purpose);
    if (!files && !state.get<ExportState>().open && !state.asks_overwrite) return;
    if (files) state.files.open = false;
    state.get<ExportState>().open = state.asks_overwrite = false;
    state.notifications.add(Tone::Warning,
                            fmt::format("The dialog was closed: it was about {}", state.editor.title()));
}

void close_left_modal(const UiState& state) {
    if (modal_of(state) == Modal::None && ImGui::GetTopMostPopupModal() != nullptr)
        ImGui::ClosePopupToLevel(0, true);
}

bool begin_modal(const char* id, bool* open, ImGuiWindowFlags flags) {
    if (!ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(8));
    const bool drawn = ImGui::BeginPopupModal(id, open, flags | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    return drawn;
}

bool enter_answers(bool enter) { return enter && !ImGui::IsWindowAppearing(); }

bool begin_question(const char* id) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    return begin_modal(id, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove);
}

void dialogs(UiState& state, const UiInput& input) {
    const bool enter = pressed(input, Key::Enter);
    const Modal modal = modal_of(state);
    switch (modal) {
    case Modal::None:
        break;
    case Modal::Unsaved:
        unsaved_question(state, input);
        break;
    case Modal::Changed:
        changed_question(state, input);
        break;
    case Modal::Files:
        if (const auto path = draw_file_dialog(state.files, enter)) use_file(state, *path);
        break;
    case Modal::Export:
        export_dialog(state, input);
        break;
    case Modal::Examples:
        examples_dialog(state, input);
        break;
    case Modal::Lessons:
        lessons_dialog(state, input);
        break;
    case Modal::Quiz:
        quiz_dialog(state, input);
        break;
    }
    if (modal_of(state) != modal) redraw_within(0);  // the next one, or what lay below
    // The name was not given, or the question not answered.
    if (!state.files.open && !state.asks_overwrite && !state.pending.asking) state.pending = {};
    poll_export(state);
}

void take_dropped(UiState& state, const std::vector<std::string>& paths) {
    if (paths.empty()) return;
    const std::string& path = paths.front();
    const std::size_t left_out = paths.size() - 1;
    if (!is_bare_picture(path)) return begin_pending(state, Pending::What::Open, path, left_out);
    bring_picture(state, path);
    if (left_out > 0) state.notifications.add(Tone::Warning, only_first_of_several);
}

}  // namespace glint
