// A light that follows the cursor by its effect there (ui/picture/handles/light_effects.h), from a command
// until a click confirms it.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "ui/picture/viewport.h"

namespace glint {

void find_main_light(ViewportState& state, const ViewportFrame& frame, glm::dvec2 cursor_px) {
    constexpr std::size_t most = 300;  // more cannot be distinguished, and take time
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
    return note_of(scene.lights[light], held.no_solution ? "waits" : info_of(held.effect).done);
}

std::string hint_of(const HeldEffect& held) {
    const LightEffectInfo& info = info_of(held.effect);
    return fmt::format("{} · Click: keep it · Esc: put it back", held.no_solution ? info.waits : info.means);
}

}  // namespace glint
