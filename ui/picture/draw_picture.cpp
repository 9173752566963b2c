#include "ui/picture/draw_picture.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include "ui/document/document_actions.h"
#include "ui/features/export/animation.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/views.h"
#include "ui/ui.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Whether what is shown is the picture, or such pictures side by side: not measured, not false colours.
bool shows_pictures(const UiState& state) {
    if (state.displayed == nullptr || state.displayed == state.rendered) return true;
    const ShownFrom& from = state.get<ViewsState>().shown_from;
    return from.compare.on && !from.compare.difference && from.debug_view == DebugViewSet{};
}

/// Whether a smaller picture may stand for the whole one for a moment: no numbers of many pixels are shown.
bool may_be_small(const UiState& state, bool previewed) {
    const bool camera = state.viewport.gesture == Gesture::Orbit || state.viewport.gesture == Gesture::Pan ||
                        state.viewport.gesture == Gesture::Dolly;
    const bool light =
        state.viewport.gesture == Gesture::Hand && state.viewport.held.grip.kind == GripKind::Light;
    const bool field = state.viewport.gesture == Gesture::None && ImGui::IsAnyItemActive();
    return (camera || light || field) && !previewed && !views_need_linear(state) &&
           !(state.get<MagnifierState>().zoom > 1) && shows_pictures(state);
}

/// The size of the next picture of a scene that differs (`changed`) from the last one or does not.
PictureSize paced_size(UiState& state, PictureSize full, bool changed, bool small_will_do) {
    FramePace& pace = state.pace;
    const bool small_now = state.rendered != nullptr && !(state.rendered->size == full);
    if (!small_will_do) {
        end_of_motion(pace);
        return full;
    }
    if (changed) {
        pace.rests_since = ImGui::GetTime();
        return divided(full, pace.divisor);
    }
    const double rest = pace.rests_since + rest_before_full - ImGui::GetTime();
    if (!small_now || rest <= 0) return full;
    redraw_within(rest);
    return state.rendered->size;
}

/// Explains the pixel at the asked place: in a smaller picture a larger pixel, whose colour is the one on the
/// screen.
void explain_asked(UiState& state, const PictureView& view) {
    state.explanation.reset();
    state.asked_other = state.resting;
    state.asked_part = {};
    const auto asked = asked_pixel(state, view);
    if (!asked) return;
    const PictureSize whole = view.map.size, drawn = state.rendered->size;
    const glm::ivec2 shown = pixel_at_place(*asked, whole, drawn);
    state.explanation = state.renderer->explain(shown.x, shown.y);
    state.explanation->spaces.pixel *=
        glm::vec2(whole.width, whole.height) / glm::vec2(drawn.width, drawn.height);
    state.asked = *asked;
    state.asked_size = whole;
    state.explained_size = drawn;
    state.explained = item_counts(state.rendered_scene);
}

/// What shows in place of the edited scene, apart from what the column shows.
enum class Resting { Nothing, Frozen, Moment, Stored };

Resting resting_of(const UiState& state) {
    if (state.get<LectureState>().frozen) return Resting::Frozen;
    if (state.get<AnimateState>().frame) return Resting::Moment;
    return state.get<CompareState>().choice.shows_stored ? Resting::Stored : Resting::Nothing;
}

/// What shows until the user ends it, whatever is edited.
std::optional<OtherScene> resting_scene(const UiState& state) {
    if (column_has_turn(state) && state.get<InspectorState>().instead &&
        state.get<InspectorState>().instead_rests)
        return OtherScene{*state.get<InspectorState>().instead, "the cells that are shown",
                          "The cells that are shown"};
    return resting_below_cells(state);
}

/// Whether the scene that `explanation` is about has the lights and objects that it names by index.
bool is_of_its_scene(const UiState& state) {
    return state.explanation && state.explained == item_counts(asked_scene(state));
}

/// During a short preview the explanation stays that of the picture before. A preview of another size may
/// lack the explained pixel: then there is no explanation until the preview ends.
void follow_size(UiState& state, const PictureView& view) {
    const bool same = state.asked_size == view.map.size && state.explained_size == state.rendered->size;
    if (!same) state.explanation.reset();
}

}  // namespace

void end_of_motion(FramePace& pace) {
    pace.divisor = 1;
    pace.in_vain = false;
}

void picture_took(FramePace& pace, int divisor, double ms) {
    const double pixels_fewer = double(divisor) * divisor;
    if (divisor == 1) {
        pace.full_ms = ms;
    } else if (ms > 0.8 * pace.full_ms) {
        pace.in_vain = true;
    } else if (ms * pixels_fewer > pace.full_ms || ms * pixels_fewer < wanted_picture_ms / 2) {
        // The estimate was too low, or the small picture was very cheap: its fixed costs do not shrink, so
        // times in between tell nothing about a full picture.
        pace.full_ms = ms * pixels_fewer;
    }
    if (pace.in_vain || pace.full_ms <= pace.slow_ms) {
        pace.divisor = 1;
        return;
    }
    const double wanted = std::ceil(std::sqrt(pace.full_ms / wanted_picture_ms));
    // Within a motion it only gets coarser: a picture that changes its grain is worse than a coarse one.
    pace.divisor =
        static_cast<int>(std::clamp(std::max(wanted, double(divisor)), 2.0, double(largest_divisor)));
}

PictureSize divided(PictureSize full, int divisor) {
    return {std::max(full.width / divisor, 1), std::max(full.height / divisor, 1), full.keeps_width};
}

bool same_surfaces(const Scene& a, const Scene& b) {
    const auto same = [](const Object& one, const Object& other) {
        return one.mesh == other.mesh && one.transform == other.transform && one.visible == other.visible &&
               one.normals == other.normals;
    };
    return a.camera == b.camera &&
           std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(), same);
}

const Renderer* renderer_of_open_scene(const UiState& state, PictureSize size) {
    const bool tells = state.rendered != nullptr && state.rendered->size == size &&
                       same_surfaces(state.rendered_scene, state.editor.scene());
    return tells ? state.renderer.get() : nullptr;
}

std::string it_is_frozen() {
    return "The picture is frozen: " + keys_of(CommandId::Freeze) + " lets it go on";
}

void freeze(UiState& state) {
    // Of B, or of what plays, nothing is selected.
    state.get<LectureState>().frozen_selection =
        is_out_of_hand(state) ? Selection{} : valid_selection(state.editor.selection, state.rendered_scene);
    state.get<LectureState>().frozen = as_made(state, state.rendered_scene);
}

std::optional<Scene> preview_of(const UiState& state) {
    // A preview under the mouse waits until an edit has been drawn and explained: the numbers beside it are
    // those of the edited scene.
    const bool explains_shown =
        state.get<InspectorState>().instead_rests || state.edited_drawn == state.editor.scene();
    if (column_has_turn(state) && state.get<InspectorState>().instead && explains_shown)
        return state.get<InspectorState>().instead;
    std::optional<OtherScene> resting = resting_scene(state);
    return resting ? std::optional(std::move(resting->scene)) : std::nullopt;
}

bool is_explained(const UiState& state) { return !state.asked_other && is_of_its_scene(state); }

const Scene& asked_scene(const UiState& state) {
    return state.asked_other ? state.asked_other->scene : state.editor.scene();
}

Scene* editable_scene(UiState& state) { return state.asked_other ? nullptr : &state.editor.scene(); }

std::optional<OtherScene> resting_below_cells(const UiState& state) {
    switch (resting_of(state)) {
    case Resting::Frozen:
        return OtherScene{*state.get<LectureState>().frozen, "the frozen picture", "Frozen"};
    case Resting::Moment:
        return OtherScene{*state.get<AnimateState>().frame, "the animation at this moment", "Animated"};
    case Resting::Stored:
        return OtherScene{scene_under({Variant::Kind::Stored, 0}, state.editor.scene(),
                                      state.get<CompareState>().choice.stored.get()),
                          name_of_stored, label_of({Variant::Kind::Stored, 0})};
    case Resting::Nothing:
        break;
    }
    return {};
}

bool column_has_turn(const UiState& state) {
    const Resting resting = resting_of(state);
    return resting == Resting::Nothing || resting == Resting::Stored;
}

bool is_out_of_hand(const UiState& state) { return resting_of(state) != Resting::Nothing; }

const Scene& shown_scene(const UiState& state) {
    return state.resting ? state.resting->scene : state.editor.scene();
}

void draw_picture(UiState& state, const PictureView& view) {
    poll_loads(state);
    state.full_size = view.map.size;
    state.resting = resting_scene(state);
    const std::optional<Scene> preview = preview_of(state);
    const Scene& shown = preview ? *preview : state.editor.scene();
    const bool moves = may_be_small(state, preview.has_value());
    state.pace.drawn_at = 0;
    const bool changed = !(state.rendered_scene == shown);
    if (state.editor.before) state.failed_size = {0, 0};  // another document may be a smaller one
    const bool failed = state.rendered != nullptr && view.map.size == state.failed_size;
    const PictureSize size = failed ? state.rendered->size : paced_size(state, view.map.size, changed, moves);
    const bool same_size = state.rendered != nullptr && state.rendered->size == size;
    const bool linear = views_need_linear(state);
    const bool has_linear = state.rendered != nullptr && !state.rendered->linear.empty();
    if (!same_size || changed || (linear && !has_linear)) {
        try {
            state.rendered = &state.renderer->render(shown, size, linear);
        } catch (const std::exception&) {
            state.failed_size = changed ? PictureSize{0, 0} : size;
            draw_scene_before(state, preview.has_value());
            throw;
        }
        state.rendered_scene = shown;
        ++state.picture_serial;
        if (moves && changed) state.pace.drawn_at = size == view.map.size ? 1 : state.pace.divisor;
    }
    // What was frozen may be the edited scene, too: then it is not drawn again.
    if (changed || !same_size || !preview) state.rendered_is_edited = !preview && !awaits_mesh(state);
    if (!is_of_its_scene(state)) state.explanation.reset();
    const bool passes = preview && !(state.resting && state.resting->scene == *preview);
    if (passes) return follow_size(state, view);
    if (!preview) state.editor.before.reset();
    if (!preview && !(state.edited_drawn == shown)) state.edited_drawn = shown;
    explain_asked(state, view);
}

void learn_pace(UiState& state) {
    if (state.pace.drawn_at == 0) return;
    const CompareState& compare = state.get<CompareState>();
    const double parts_ms = compare.choice.on ? compare.ms : 0;
    picture_took(state.pace, state.pace.drawn_at, state.renderer->stats().total_ms + parts_ms);
}

}  // namespace glint
