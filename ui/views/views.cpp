#include "ui/views/views.h"

#include "ui/views/scope_panel.h"
#include "ui/views/views_bar.h"

namespace glint {
namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

void begin_window(const char* id, const Rect& area) {
    ImGui::SetNextWindowPos(area.low);
    ImGui::SetNextWindowSize(area.size());
    ImGui::Begin(id, nullptr, fixed | ImGuiWindowFlags_NoScrollWithMouse);
}

void copy_profile_command(UiState& state) {
    const std::string& path = state.editor.document.path;
    ImGui::SetClipboardText(profile_command_line(state.views.scope, path, state.picture->size).c_str());
    const bool saved = !path.empty() && !state.editor.unsaved();
    state.notifications.add(Tone::Done, saved ? "Copied the command of this scan line"
                                              : "Copied. The command reads the scene's file: save it first");
}

}  // namespace

void begin_views(UiState& state) { state.layout.scope = state.views.scope.open; }

bool views_hand(UiState& state, const PictureView& view) { return scope_hand(state.views.scope, view); }

bool views_need_linear(const ViewsState& views) { return views.scope.open; }

void update_views(UiState& state) { update_scope(state.views.scope, *state.renderer, *state.picture); }

void draw_views_overlay(ImDrawList& list, const UiState& state, const PictureView& view) {
    draw_scope_line(list, state.views.scope, view);
}

void views_windows(UiState& state, const Layout& layout) {
    if (layout.has_views) {
        begin_window("##views", layout.views);
        views_bar(state);
        ImGui::End();
    }
    if (layout.has_scope && state.picture != nullptr) {
        begin_window("##scope", layout.scope);
        if (scope_panel(state.views.scope, layout.scope, state.picture->size).copy)
            copy_profile_command(state);
        ImGui::End();
    }
}

std::string views_hint(const ViewsState& views) {
    using Hand = ScopeState::Hand;
    const ScopeState& scope = views.scope;
    if (!scope.open) return {};
    switch (scope.hand != Hand::None ? scope.hand : scope.under) {
    case Hand::None:
        return {};
    case Hand::New:
        return "Drag a line over the picture · Click: the whole scan line · Shift: level or upright · Esc: "
               "not now";
    case Hand::From:
    case Hand::To:
        return "Drag the end of the line · Shift: level or upright";
    case Hand::Line:
        return "Drag the line";
    case Hand::Card:
        return "Drag the card over one side of an edge: the band beside it goes";
    }
    return {};  // not reached
}

void run_views_action(UiState& state, Action action) {
    if (action == Action::Scope) toggle_scope(state.views.scope);
}

std::optional<bool> views_is_on(const UiState& state, Action action) {
    if (action == Action::Scope) return state.views.scope.open;
    return {};
}

bool leave_view_tool(ViewsState& views) {
    if (!views.scope.armed) return false;
    views.scope.armed = false;
    return true;
}

}  // namespace glint
