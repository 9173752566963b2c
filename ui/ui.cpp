#include "ui/ui.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/picture/draw_picture.h"
#include "ui/shell/columns.h"
#include "ui/shell/modal.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Dear ImGui 1.86 uses 0 segments for a corner with a radius below a millionth of a pixel, and divides by
/// that number. A moving progress bar eventually has such a width.
void give_tiny_corners_segments() {
    ImGui::GetDrawListSharedData()->CircleSegmentCounts[0] = IM_DRAWLIST_ARCFAST_SAMPLE_MAX;
}

/// Called after all edits of the scene, before it is drawn or recorded as a step. Does not change a number
/// that is being edited: "0" may become "0.5", and a drag may pass through 0.
void keep_scene_valid(UiState& state) {
    const std::optional<Problem> problem = take_back_invalid(state.editor);
    if (!problem) return;
    if (number_in_hand()) return refuse_edit(with_expected(problem->what, problem->expected));
    let_go_of_fields();
    state.notifications.add(Tone::Warning, "Not possible: " + problem->text());
}

/// Adds an undo step when editing has ended, or has begun in a different field.
void remember(UiState& state, bool in_hand) {
    const ImGuiID now = GImGui->ActiveId, before = std::exchange(state.active_before, now);
    const bool left_one = before != 0 && now != before;
    if (((in_hand || now != 0) && !left_one) || awaits_mesh(state)) return;
    remember_step(state.editor, state.viewport.wheel_goes_on);
}

/// Whether the contents of an auto-sized window have changed, so that it is resized in the next frame.
bool a_window_changes_size() {
    const ImVector<ImGuiWindow*>& all = ImGui::GetCurrentContext()->Windows;
    return std::any_of(all.begin(), all.end(), [](const ImGuiWindow* window) {
        const ImVec2 holds = window->DC.CursorMaxPos - window->DC.CursorStartPos;
        return window->Active && (window->Flags & ImGuiWindowFlags_AlwaysAutoResize) != 0 &&
               (IM_FLOOR(holds.x) != window->ContentSize.x || IM_FLOOR(holds.y) != window->ContentSize.y);
    });
}

UiRequests requests(UiState& state) {
    UiRequests wants;
    const bool has_file = !state.editor.document.path.empty() || state.editor.source.title.empty();
    wants.title = fmt::format("{}{} – Glint", state.editor.unsaved() ? "● " : "",
                              has_file ? state.editor.title() : state.editor.source.title);
    wants.sleep_s = next_redraw();
    OnScreen next;
    decide_shown(next, state);
    const OtherScene* other = next.drawn();
    if (!((other != nullptr ? other->scene : state.editor.scene()) == state.rendered_scene))
        wants.sleep_s = 0;  // the scene was edited or previewed after the picture was drawn
    if (ImGui::GetIO().WantTextInput) wants.sleep_s = std::min(wants.sleep_s, 0.3);  // the text cursor blinks
    wants.quit = std::exchange(state.quits, false);
    return wants;
}

/// Handles the request to close, and dropped files. During a drag they wait until it ends, because the drag
/// is not yet a step, and would continue behind a question. A light that follows the cursor is moved back.
void take_requests(UiState& state, const UiInput& input) {
    state.close_asked |= input.close_asked;
    if (!input.dropped.empty()) state.dropped = input.dropped;
    if (!state.close_asked && state.dropped.empty()) return;
    if (state.viewport.gesture == Gesture::Effect) (void)cancel_gesture(state.viewport, state.editor.scene());
    if (state.viewport.gesture != Gesture::None) return redraw_within(0);
    if (std::exchange(state.close_asked, false)) run_command(state, CommandId::Quit);
    take_dropped(state, std::exchange(state.dropped, {}));
}

/// In a narrow window, the panel of an item that `act` selects replaces WHY.
template <class Act> void show_selected(UiState& state, const Act& act) {
    const Selection before = state.editor.selection;
    act();
    const Selection& now = state.editor.selection;
    const bool is_item = now.kind == Selection::Kind::Light || now.kind == Selection::Kind::Object;
    if (is_item && !(now == before)) state.left_shows_inspector = false;
}

/// Calls a hook of each feature that implements it.
template <class Hook, class... Arguments> void each(Hook Feature::*hook, Arguments&&... arguments) {
    for (const Feature* feature : features())
        if (feature->*hook != nullptr) (feature->*hook)(arguments...);
}

UiRequests whole_frame(UiState& state, const UiInput& input) {
    give_tiny_corners_segments();
    reset_next_redraw();
    state.jobs.drop_ended();
    take_requests(state, input);
    run_keys(state, input);
    each(&Feature::begin, state, input);
    close_left_modal(state);
    // The scene may have changed arbitrarily since the last frame.
    state.editor.selection = valid_selection(state.editor.selection, state.editor.scene());
    follow_items(state);
    ImGui::PushFont(fonts().body);
    state.layout.lesson = open_column(state) != nullptr;
    const Layout layout = window_layout(state);
    if (!state.layout.hides_all) toolbar(state, layout.top);
    bool in_hand = false;
    show_selected(state, [&] { in_hand = picture_room(state, layout, input); });
    if (state.viewport.asked) state.left_shows_inspector = true;
    if (state.viewport.pressed_mark) state.left_shows_inspector = false;
    left_column(state, layout, picture_view(layout.centre, state));
    shortcuts_sheet(state);
    show_selected(state, [&] { palette(state, input); });
    keep_scene_valid(state);
    follow_items(state);
    each(&Feature::settle, state);
    const PictureView view = picture_view(layout.centre, state);
    draw_picture(state, view);
    each(&Feature::compose, state);
    each(&Feature::update, state);
    learn_pace(state);
    picture_overlay(state, layout);
    caption_line(state, layout);
    show_selected(state, [&] { inspector_columns(state, layout, view); });
    each(&Feature::draw, state, layout);
    column_edges(state.layout, layout, px(1));
    loading_panel(state, layout.centre);
    recovery_panel(state, layout.centre);
    if (!state.layout.hides_all) status_line(state, layout.status);
    dialogs(state, input);  // called after every window is drawn: see ui/shell/modal.h
    keep_scene_valid(state);
    for (const Said& said : take_said())
        state.notifications.add(said.refuses ? Tone::Warning : Tone::Done, said.line);
    remember(state, in_hand);
    each(&Feature::end, state);
    poll_persistence(state);
    ImGui::PopFont();
    if (a_window_changes_size()) redraw_within(0);
    return requests(state);
}

}  // namespace

UiRequests ui_frame(UiState& state, const UiInput& input) {
    try {
        return whole_frame(state, input);
    } catch (const std::exception& error) {
        give_up_frame(state, error);
    }
    redraw_within(0);
    return requests(state);
}

std::vector<PictureSheet*> sheets_of(UiState& state) {
    std::vector<PictureSheet*> sheets;
    for (const Feature* feature : features())
        if (feature->sheet != nullptr) sheets.push_back(feature->sheet(state));
    return sheets;
}

}  // namespace glint
