// The offer to take up the work that a crash interrupted.
#include <fmt/core.h>
#include <imgui.h>

#include <filesystem>

#include "ui/document/document_actions.h"
#include "ui/export/export_picture.h"
#include "ui/ui.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

void recovery_panel(UiState& state, const Rect& picture) {
    auto& left = state.persistence.orphans;
    if (left.empty() || state.pending.asking) return;
    const float width = begin_over_picture("##recovery", px(470), picture);
    ImGui::PushTextWrapPos(width - px(14));
    ImGui::TextUnformatted(
        fmt::format("Glint ended while {} had changes that were not saved. A copy of {} was kept.",
                    left.front().title, left.front().when)
            .c_str());
    ImGui::PopTextWrapPos();
    const bool open = ImGui::Button("Recover", {px(110), 0});
    tooltip("Recover", "Opens the copy; what is in the file stays until it is saved");
    ImGui::SameLine();
    const bool discard = ImGui::Button("Discard", {px(110), 0});
    tooltip("Discard", "Deletes the copy");
    ImGui::SameLine();
    const bool later = ImGui::Button("Not now", {px(110), 0});
    tooltip("Not now", "Asks again at the next start");
    end_over_picture();
    std::error_code failed;
    if (discard) std::filesystem::remove(left.front().lock.path(), failed);
    if (discard || later) left.erase(left.begin());
    if (open) begin_pending(state, {Pending::What::Recover, left.front().lock.path(), false});
}

void recover_autosave(UiState& state, const std::string& path) {
    Persistence& memory = state.persistence;
    const auto copy =
        std::find_if(memory.orphans.begin(), memory.orphans.end(),
                     [&path](const OrphanedAutosave& left) { return left.lock.path() == path; });
    Result<SceneDocument> opened = open_autosave(path);
    if (const Problem* problem = problem_of(opened)) return state.notifications.add(*problem);
    cancel_loads(state);
    drop_autosave(state);
    take_scene(state, std::get<SceneDocument>(std::move(opened)));
    // What is in the file, which the copy is newer than.
    const Result<SceneDocument> in_file = open_document(state.editor.document.path);
    const auto* document = std::get_if<SceneDocument>(&in_file);
    state.editor.saved = document != nullptr ? document->scene : Scene();
    if (copy == memory.orphans.end()) return;
    memory.autosave = std::move(copy->lock);  // from now on it is this window's own
    memory.autosaved_scene = state.editor.scene();
    memory.orphans.erase(copy);
}

}  // namespace glint
