#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "ui/feature.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/viewport.h"
#include "ui/ui.h"

namespace glint {

// The picked pixel, and the previously picked one.

void follow_shape(UiState& state, PictureSize size) {
    const PictureSize before = std::exchange(state.viewport.shares_of, size);
    if (before == size || before == PictureSize{0, 0}) return;
    // Converts fractions to positions in the plane at depth 1 and back. In that plane a point's position does
    // not depend on the picture's shape.
    const Projection& projection = state.editor.scene().camera.projection;
    const glm::dmat4 from = clip_from_view(projection, before), to = clip_from_view(projection, size);
    const glm::dvec2 scale(to[0][0] / from[0][0], to[1][1] / from[1][1]);
    const auto aspect = [](PictureSize of) { return double(of.width) / of.height; };
    const Reshape reshape{scale, {scale.x * aspect(size) / aspect(before), scale.y}};
    for (std::optional<glm::dvec2>* probe : {&state.viewport.probe, &state.viewport.probe_before})
        if (*probe) reshape.follow(**probe);
    for (const Feature* feature : features())
        if (feature->reshape != nullptr) feature->reshape(state, reshape);
}

void ask_about(ViewportState& state, std::optional<glm::dvec2> probe) {
    if (state.probe) state.probe_before = state.probe;
    state.probe = probe;
}

void ask_as_before(ViewportState& state) {
    const std::optional<glm::dvec2> before = state.probe_before;
    if (before) ask_about(state, before);
}

void step_probe(ViewportState& state, PictureSize size, glm::ivec2 step) {
    const std::optional<glm::ivec2> from = probe_pixel(state, size);
    const glm::ivec2 last(size.width - 1, size.height - 1);
    const glm::ivec2 to = from ? glm::clamp(*from + step, glm::ivec2(0), last) : (last + 1) / 2;
    const glm::dvec2 share = (glm::dvec2(to) + 0.5) / glm::dvec2(size.width, size.height);
    if (from)
        state.probe = share;  // stepping does not change which pixel was picked before
    else
        ask_about(state, share);
    state.touched = true;
}

std::optional<glm::ivec2> probe_pixel(const ViewportState& state, PictureSize size) {
    if (!state.probe || !is_inside(size, *state.probe * glm::dvec2(size.width, size.height))) return {};
    return nearest_pixel(size, *state.probe * glm::dvec2(size.width, size.height));
}

namespace {

bool forget_probe(UiState& state) {
    if (!state.viewport.probe) return false;
    ask_about(state.viewport, {});
    return true;
}

}  // namespace

extern const Feature probe_feature;
const Feature probe_feature{.escape = forget_probe};

// Moves a light so that its effect (ui/picture/handles/light_handles.h) follows the cursor, from a command
// until a click confirms it.

void find_main_light(ViewportState& state, const ViewportFrame& frame, glm::dvec2 cursor_px) {
    constexpr std::size_t most = 300;  // more lights cannot be distinguished, and would be slow
    state.main_light.reset();
    const std::size_t lights = frame.scene.lights.size();
    if (!state.hovered || state.gesture != Gesture::None || frame.renderer == nullptr || lights < 2 ||
        lights > most || !is_inside(frame.view.map.size, cursor_px))
        return;
    state.main_light = main_light(frame.renderer->explain(int(cursor_px.x), int(cursor_px.y)));
}

void begin_effect(ViewportState& state, Scene& scene, Selection& selection, LightEffect effect) {
    if (scene.lights.empty()) return;
    if (selection.kind != Selection::Kind::Light)
        selection = {Selection::Kind::Light, state.main_light ? state.main_light->light : 0};
    const int light = std::clamp(selection.index, 0, static_cast<int>(scene.lights.size()) - 1);
    state.gesture = Gesture::Effect;
    state.before = scene;
    state.effect = {effect, light, scene.lights[static_cast<std::size_t>(light)], false};
    state.touched = true;
}

void follow_effect(ViewportState& state, const ViewportFrame& frame, glm::dvec2 cursor_px) {
    HeldEffect& held = state.effect;
    const auto light = static_cast<std::size_t>(held.light);
    if (frame.renderer == nullptr || light >= frame.scene.lights.size()) return;
    const SurfaceView surface{frame.scene, *frame.renderer, frame.view.map, frame.view.dome};
    const auto moved = with_effect(held.effect, held.start, surface, cursor_px);
    held.no_solution = !moved;
    if (moved) frame.scene.lights[light] = *moved;
}

HandNote note_of(const HeldEffect& held, const Scene& scene) {
    const auto light = static_cast<std::size_t>(held.light);
    if (light >= scene.lights.size()) return {};
    return note_of(scene.lights[light], held.no_solution ? "does not move" : info_of(held.effect).done);
}

std::string hint_of(const HeldEffect& held) {
    const LightEffectInfo& info = info_of(held.effect);
    return fmt::format("{} · Click: keep it · Esc: move it back", held.no_solution ? info.waits : info.means);
}

}  // namespace glint
