#include "ui/shell/modal.h"

#include <imgui_internal.h>

#include "ui/ui.h"

namespace glint {

Modal modal_of(const UiState& state) {
    if (state.pending.asking) return Modal::Unsaved;
    if (state.asks_overwrite) return Modal::Changed;
    if (state.files.open) return Modal::Files;
    if (state.exporting.open) return Modal::Export;
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
        state.exporting.open = false;
        return;
    }
}

void close_left_modal(const UiState& state) {
    if (modal_of(state) == Modal::None && ImGui::GetTopMostPopupModal() != nullptr)
        ImGui::ClosePopupToLevel(0, true);
}

bool begin_modal(const char* id, bool* open, ImGuiWindowFlags flags) {
    if (!ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
    return ImGui::BeginPopupModal(id, open, flags | ImGuiWindowFlags_NoSavedSettings);
}

bool begin_question(const char* id) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    return begin_modal(id, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove);
}

}  // namespace glint
