#include "ui/ui.h"

#include <fmt/core.h>

#include <algorithm>
#include <exception>

#include "ui/commands/command.h"
#include "ui/commands/menus.h"
#include "ui/document/document_actions.h"
#include "ui/export/animate.h"
#include "ui/picture/draw_picture.h"
#include "ui/shell/columns.h"
#include "ui/shell/modal.h"
#include "ui/views/views.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// One undo step when nothing has the scene in hand any more.
void remember(UiState& state, bool in_hand) {
    if (in_hand || ImGui::IsAnyItemActive() || awaits_mesh(state)) return;
    state.editor.history.commit(state.editor.scene(), state.viewport.wheel_goes_on);
}

UiRequests requests(UiState& state) {
    UiRequests wants;
    wants.quit = state.quits;
    state.quits = false;
    wants.title = fmt::format("{}{} – Glint", state.editor.unsaved() ? "● " : "", state.editor.title());
    wants.sleep_s = next_redraw();
    const std::optional<Scene> preview = preview_of(state);
    const Scene& next = preview ? *preview : state.editor.scene();
    if (!(next == state.rendered_scene))
        wants.sleep_s = 0;  // edited or previewed after the picture was drawn
    if (ImGui::GetIO().WantTextInput) wants.sleep_s = std::min(wants.sleep_s, 0.3);  // the text cursor blinks
    return wants;
}

UiRequests whole_frame(UiState& state, const UiInput& input) {
    reset_next_redraw();
    if (input.close_asked) run_command(state, CommandId::Quit);
    take_dropped(state, input);
    run_keys(state, input);
    follow_b_key(state, input.b_held);
    close_left_modal(state);
    ImGui::PushFont(fonts().body);
    begin_views(state);
    const Layout layout = lay_out(ImGui::GetIO().DisplaySize, state.layout, px(1));
    if (!state.layout.hides_all) toolbar(state, layout.top);
    const bool in_hand = picture_room(state, layout, input);
    state.left_shows_inspector |= state.viewport.asked;
    left_column(state, layout, picture_view(layout.centre, state));
    shortcuts_sheet(state);
    palette(state, input);
    const PictureView view = picture_view(layout.centre, state);
    draw_picture(state, view);
    update_views(state);
    learn_pace(state);
    picture_overlay(state, layout, picture_view(layout.centre, state));
    inspector_columns(state, layout, view);
    views_windows(state, layout);
    column_edges(state.layout, layout, px(1));
    loading_panel(state, layout.centre);
    recovery_panel(state, layout.centre);
    if (!state.layout.hides_all) status_line(state, layout.status);
    animate_panel(state);
    step_wedge(state.lecture.wedge);
    dialogs(state, input);  // after every window: ui/shell/modal.h
    remember(state, in_hand);
    poll_persistence(state);
    poll_animation(state);
    ImGui::PopFont();
    return requests(state);
}

}  // namespace

UiRequests ui_frame(UiState& state, const UiInput& input) {
    try {
        return whole_frame(state, input);
    } catch (const std::exception& error) {  // most of all, that there is no memory
        give_up_frame(state, error);
        redraw_within(0);
        return requests(state);
    }
}

}  // namespace glint
