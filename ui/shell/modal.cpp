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

/// Draws a line that lists the key of each answer, below the buttons.
void key_words(const char* words) {
    ImGui::Dummy({0, px(2)});
    small_dim(words);
}

void unsaved_question(UiState& state, const UiInput& input) {
    const bool enter = pressed(input, Key::Enter);
    if (!begin_question("Unsaved changes##question")) return;
    ImGui::TextUnformatted(fmt::format("{} has unsaved changes.", state.editor.title()).c_str());
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

/// Enter chooses nothing here, because each answer but Cancel discards something or needs a name.
void changed_question(UiState& state, const UiInput& input) {
    if (!begin_question("Changed by another program##question")) return;
    const std::string title = state.editor.title();
    ImGui::TextUnformatted(
        fmt::format("{} has been changed by another program since it was opened here.", title).c_str());
    ImGui::Dummy({px(460), px(6)});
    const auto answer = [&](const char* name, const char* what, Key key) {
        const bool chosen = ImGui::Button(name, {px(110), 0}) || enter_answers(pressed(input, key));
        tooltip(name, what);
        state.asks_overwrite = state.asks_overwrite && !chosen;
        return chosen;
    };
    if (answer("Overwrite", "Discards the other program's changes", Key::O) && save_over(state))
        finish_pending(state);
    ImGui::SameLine();
    if (answer("Save as…", "Saves under another name and keeps both", Key::S))
        state.files.ask(save_purpose, offered_name(state, ".json"));
    ImGui::SameLine();
    if (answer("Reload", "Discards your changes since the last save", Key::R)) reload(state);
    ImGui::SameLine();
    if (answer("Cancel", "Nothing is saved", Key::Escape)) state.pending = {};
    key_words("O: overwrite  ·  S: save as  ·  R: reload  ·  Esc: cancel");
    if (!state.asks_overwrite) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void files_dialog_frame(UiState& state, const UiInput& input) {
    const FilePurpose& purpose = *state.files.purpose;
    if (const auto path = draw_file_dialog(state.files, pressed(input, Key::Enter)))
        purpose.use(state, *path);
}

}  // namespace

const Dialog unsaved_dialog{[](const UiState& s) { return s.pending.asking; },
                            [](UiState& s) { s.pending = {}; }, unsaved_question};
const Dialog changed_dialog{[](const UiState& s) { return s.asks_overwrite; },
                            [](UiState& s) {
                                s.asks_overwrite = false;
                                s.pending = {};
                            },
                            changed_question};
const Dialog files_dialog{[](const UiState& s) { return s.files.open; },
                          [](UiState& s) {
                              s.files.open = false;
                              s.pending = {};
                          },
                          files_dialog_frame};

const Dialog* open_dialog(const UiState& state) {
    for (const Dialog* dialog : {&unsaved_dialog, &changed_dialog, &files_dialog})
        if (dialog->is_open(state)) return dialog;
    for (const Feature* feature : features())
        if (feature->dialog.is_open != nullptr && feature->dialog.is_open(state)) return &feature->dialog;
    return nullptr;
}

void leave_modal(UiState& state) {
    if (const Dialog* dialog = open_dialog(state)) dialog->close(state);
}

void leave_dialogs_of_scene(UiState& state) {
    bool left = std::exchange(state.asks_overwrite, false);
    if (state.files.open && state.files.purpose->is_about_scene) left = !(state.files.open = false);
    for (const Feature* feature : features())
        if (const Dialog& dialog = feature->dialog; dialog.is_about_scene && dialog.is_open(state)) {
            dialog.close(state);
            left = true;
        }
    if (left)
        state.notifications.add(Tone::Warning, fmt::format("Closed a dialog about {}", state.editor.title()));
}

void close_left_modal(const UiState& state) {
    if (open_dialog(state) == nullptr && ImGui::GetTopMostPopupModal() != nullptr)
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
    const Dialog* dialog = open_dialog(state);
    constexpr double late = 0.3;  // seconds
    if (dialog != nullptr) {
        dialog->draw(state, input);
        state.letters_from = ImGui::GetTime() + late;
    }
    if (open_dialog(state) != dialog) redraw_within(0);  // to draw the next dialog, or the one below
    // The file dialog was cancelled, or the question was closed without an answer.
    if (!state.files.open && !state.asks_overwrite && !state.pending.asking) state.pending = {};
}

void take_dropped(UiState& state, const std::vector<std::string>& paths) {
    if (paths.empty()) return;
    const std::string& path = paths.front();
    const std::size_t left_out = paths.size() - 1;
    for (const Feature* feature : features())
        if (feature->drop != nullptr && feature->drop(state, path)) {
            if (left_out > 0) state.notifications.add(Tone::Warning, only_first_of_several);
            return;
        }
    ask_to_open(state, path, left_out);
}

}  // namespace glint
