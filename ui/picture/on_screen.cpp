#include "ui/picture/on_screen.h"

#include <imgui.h>

#include <algorithm>
#include <glm/common.hpp>

#include "ui/feature.h"
#include "ui/ui.h"

namespace glint {
namespace {

/// Returns the first scene shown by one of these features; previews count only if `previews` is true.
std::optional<OtherScene> first_shown(std::span<const Feature* const> from, const UiState& state,
                                      bool previews) {
    for (const Feature* feature : from)
        if (feature->shows != nullptr)
            if (std::optional<OtherScene> shown = feature->shows(state);
                shown && (previews || !shown->passes)) {
                shown->by = feature;
                return shown;
            }
    return {};
}

std::size_t place_of(const Feature& feature) {
    return static_cast<std::size_t>(std::find(features().begin(), features().end(), &feature) -
                                    features().begin());
}

/// Returns the pixel to explain: the picked one or the one under the cursor; nullopt if there is none.
std::optional<glm::ivec2> asked_pixel(const UiState& state, const PictureView& view) {
    const PictureSize size = view.map.size;
    if (!asks_at_cursor(state)) return probe_pixel(state.viewport, size);
    return nearest_pixel(size, view.to_pixel(ImGui::GetIO().MousePos));
}

}  // namespace

void decide_shown(OnScreen& shown, const UiState& state) {
    shown.resting = first_shown(features(), state, true);
    shown.passing.reset();
    if (!shown.resting || !shown.resting->passes) return;
    shown.passing = std::move(shown.resting);
    shown.resting = first_shown(features(), state, false);
}

std::optional<OtherScene> resting_below(const UiState& state, const Feature& feature) {
    return first_shown(features().subspan(place_of(feature) + 1), state, false);
}

bool has_turn(const UiState& state, const Feature& feature) {
    return !first_shown(features().first(place_of(feature)), state, true);
}

const Scene& shown_scene(const UiState& state) {
    return state.on_screen.resting ? state.on_screen.resting->scene : state.editor.scene();
}

const Scene& explained_scene(const UiState& state) {
    return state.on_screen.explained_other ? state.on_screen.explained_other->scene : state.editor.scene();
}

Scene* editable_scene(UiState& state) {
    return state.on_screen.explained_other ? nullptr : &state.editor.scene();
}

bool is_explained(const UiState& state) {
    const OnScreen& shown = state.on_screen;
    return shown.explanation && !shown.explained_other &&
           item_counts(state.edited_drawn) == item_counts(state.editor.scene());
}

void explain_picked(UiState& state, const PictureView& view) {
    OnScreen& shown = state.on_screen;
    shown.explanation.reset();
    shown.explained_by = nullptr;
    shown.explained_other = shown.resting;
    const auto asked = asked_pixel(state, view);
    if (!asked) return;
    const PictureSize whole = view.map.size, drawn = state.rendered->size;
    const glm::ivec2 at = pixel_at_place(*asked, whole, drawn);
    shown.explained_by = state.renderer.get();
    shown.explanation = shown.explained_by->explain(at.x, at.y);
    shown.explanation->spaces.pixel *=
        glm::vec2(whole.width, whole.height) / glm::vec2(drawn.width, drawn.height);
    shown.pixel = *asked;
    shown.explained_size = whole;
    shown.explained_drawn = drawn;
}

bool asks_at_cursor(const UiState& state) {
    return ImGui::GetIO().KeyAlt && state.viewport.hovered && state.viewport.gesture == Gesture::None;
}

}  // namespace glint
