#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/commands/command.h"
#include "ui/document/loading.h"
#include "ui/features/export/animation.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/features/views/compare_view.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

Json json_of(const std::array<int, 3>& colour) {
    return {colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0};
}

/// A prediction concerns a colour in the edited scene, so this ends any comparison, animation, frozen picture
/// or view of B.
void show_edited_alone(UiState& state) {
    state.get<CompareState>().choice.on = state.get<CompareState>().choice.shows_stored = false;
    state.get<AnimateState>().playing = false;
    state.get<AnimateState>().frame.reset();
    state.get<LectureState>().frozen.reset();
}

/// Starts with the picked pixel, if it has a colour now; otherwise a pixel must be picked.
void begin_prediction(UiState& state) {
    show_edited_alone(state);
    state.get<PredictState>() = {};
    state.get<PredictState>().stage = PredictStage::Pick;
    redraw_within(0);  // poll_prediction() continues in the next frame
}

/// Precondition: the picked pixel's explanation is available, for the edited scene.
void stop_picture(UiState& state) {
    show_edited_alone(state);
    PredictState& predict = state.get<PredictState>();
    predict.stage = PredictStage::Change;
    predict.probe = state.viewport.probe;
    predict.before = state.on_screen.explanation->byte;
    freeze(state);
    state.get<LectureState>().frozen =
        as_made(state, state.editor.scene());  // not the preview of a hovered term
}

/// Shows the predicted pixel as it is now, even if something else was shown or picked in the meantime.
void reveal(UiState& state) {
    state.get<PredictState>().stage = PredictStage::Revealed;
    show_edited_alone(state);
    state.viewport.probe = state.get<PredictState>().probe;
    state.on_screen.explanation.reset();
    redraw_within(0);
}

void lock_in_colour(UiState& state) {
    PredictState& predict = state.get<PredictState>();
    if (predict.mine == Json()) predict.mine = json_of(predict.before);
    reveal(state);
}

void pick_panel() {
    prose_line("Click the pixel whose colour you want to predict.");
    small_dim("Then the picture is frozen. You change the scene, predict the colour, and check it.");
}

void change_panel(UiState& state) {
    PredictState& predict = state.get<PredictState>();
    prose_line("Change anything you like: the picture is frozen. What colour will the pixel have?");
    colour_row("It was", json_of(predict.before));
    ImGui::Dummy({0, px(4)});
    if (std::exchange(predict.takes_keys, false)) {
        ImGui::SetWindowFocus();
        ImGui::SetKeyboardFocusHere(2);  // the picker's square and its bar come before its numbers
    }
    if (predict.mine == Json()) {
        Json shown = json_of(predict.before);
        if (pick_colour("##predicted", shown)) predict.mine = shown;
    } else {
        (void)pick_colour("##predicted", predict.mine);
    }
    ImGui::Dummy({0, px(4)});
    if (main_button(predict.mine == Json() ? "It stays as it was" : "Lock it in")) lock_in_colour(state);
    tooltip("Lock the colour in", "Unfreezes the picture and shows the colour");
    ImGui::SameLine(0, px(12));
    if (ImGui::Button("Give up")) end_prediction(state);
    small_dim(predict.mine == Json() ? "Enter: type the colour  ·  Esc: give up"
                                     : "Enter: lock it in  ·  Esc: give up");
}

void revealed_panel(UiState& state) {
    const PredictState& predict = state.get<PredictState>();
    if (!predict.answer) return small_dim("Drawing the picture …");
    const Json answer = json_of(*predict.answer);
    colour_row("You said", predict.mine);
    const bool still = state.on_screen.explanation && state.on_screen.explanation->byte == *predict.answer;
    colour_row(still ? "It is" : "It was", answer);  // "was" after an additional edit
    const double off = 255 * how_far(PredictionKind::Colour, predict.mine, answer);
    constexpr double levels_hardly_seen = 8;
    const std::string words = fmt::format("Off by at most {:.0f} of 255 levels", off);
    if (off <= levels_hardly_seen)
        coloured(theme().accent, off < 0.5 ? "Exactly." : "Close enough. " + words + ".");
    else
        warning_text(words + ".");
    if (main_button("Again")) begin_prediction(state);
    tooltip("Predict again", "Freezes the picture for another change");
    ImGui::SameLine(0, px(12));
    if (ImGui::Button("Close")) end_prediction(state);
    small_dim("Enter: again  ·  Esc: close");
    ImGui::Separator();
}

}  // namespace

void switch_prediction(UiState& state) {
    if (state.get<PredictState>().stage != PredictStage::Off) return end_prediction(state);
    state.layout.right = state.left_shows_inspector = true;
    state.layout.hides_columns = false;
    begin_prediction(state);
}

void end_prediction(UiState& state) {
    if (state.get<PredictState>().stage == PredictStage::Change) state.get<LectureState>().frozen.reset();
    state.get<PredictState>() = {};
}

bool predict_by_key(UiState& state, KeyPress press) {
    PredictState& predict = state.get<PredictState>();
    if (!(press == KeyPress{Key::Enter})) return false;
    if (predict.stage == PredictStage::Revealed && predict.answer) {
        begin_prediction(state);
        return true;
    }
    if (predict.stage != PredictStage::Change) return false;
    if (predict.mine != Json()) {
        lock_in_colour(state);
        return true;
    }
    predict.mine = json_of(predict.before);
    predict.takes_keys = true;
    return true;
}

void poll_prediction(UiState& state) {
    PredictState& predict = state.get<PredictState>();
    if (predict.stage == PredictStage::Pick && state.viewport.probe) {
        if (is_explained(state))
            stop_picture(state);
        else if (state.on_screen
                     .is_out_of_hand())  // B or a frozen picture was clicked: show the edited scene first
            show_edited_alone(state);
    }
    if (predict.stage == PredictStage::Change && !state.get<LectureState>().frozen)
        end_prediction(state);  // unfrozen with F8
    if (predict.stage != PredictStage::Revealed || predict.answer) return;
    if (!state.viewport.probe) return end_prediction(state);
    const bool drawn = state.rendered_is_edited && state.rendered_scene == state.editor.scene();
    if (drawn && state.on_screen.explanation && is_explained(state))
        predict.answer = state.on_screen.explanation->byte;
    redraw_within(0);
}

bool predict_panel(UiState& state) {
    switch (state.get<PredictState>().stage) {
    case PredictStage::Off:
        return true;
    case PredictStage::Pick:
        pick_panel();
        return false;
    case PredictStage::Change:
        change_panel(state);
        return false;
    case PredictStage::Revealed:
        revealed_panel(state);
        return state.get<PredictState>().answer.has_value();
    }
    return true;  // not reached
}

}  // namespace glint
