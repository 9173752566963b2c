// Solo and mute: the picture shows one light alone, or leaves some out. The scene does not change.
#include "ui/commands/command.h"
#include "ui/feature.h"
#include "ui/fields/panels.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/ui.h"

namespace glint {
namespace {

void end_focus(UiState& state) { state.get<LightFocus>() = {}; }

/// Describes the focus: "Solo: Bulb", "Muted: Sun, Bulb".
std::string note_of(const LightFocus& focus, const Scene& scene) {
    const auto name = [&](int light) { return scene.lights[static_cast<std::size_t>(light)].name; };
    if (focus.solo >= 0) return "Solo: " + name(focus.solo);
    std::string text;
    for (const int light : focus.muted) text += (text.empty() ? "Muted: " : ", ") + name(light);
    return text;
}

std::optional<OtherScene> show_focus(const UiState& state) {
    const LightFocus& focus = state.get<LightFocus>();
    const Scene& edited = state.editor.scene();
    if (!focus.is_on() || focus.lights != edited.lights.size()) return {};
    Scene scene = edited;
    for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i)
        if (!focus.shows(i)) scene.lights[static_cast<std::size_t>(i)].enabled = false;
    if (focus.solo >= 0) {  // also hide light that does not come from a light source
        scene.global_ambient = glm::vec3(0);
        for (Object& object : scene.objects) object.material.emission = glm::vec3(0);
    }
    return OtherScene{.scene = std::move(scene),
                      .name = "the lights that are shown",
                      .label = note_of(focus, edited),
                      .note = note_of(focus, edited),
                      .end = end_focus,
                      .is_partial = true,
                      .of_edited = true};
}

/// Whether a light shines from below `ground`.
bool is_below_ground(const Light& light, const Scene& scene, double ground) {
    const glm::dvec4 own(light.position);
    const glm::dvec4 world = light.space == LightSpace::World ? own : world_from_view(scene.camera) * own;
    return world.y < (light.kind == LightKind::Directional ? 0 : ground);
}

std::vector<std::string> warnings_of(const UiState& state) {
    const Scene& scene = state.editor.scene();
    std::vector<std::string> warnings(scene.lights.size());
    const double ground = ground_height(scene);
    for (std::size_t i = 0; i < warnings.size(); ++i)
        if (scene.lights[i].enabled && is_below_ground(scene.lights[i], scene, ground))
            warnings[i] = "This light shines from below the ground";
    if (!is_explained(state) || !state.on_screen.explanation->hit) return warnings;
    for (const ExplainedLight& light : state.on_screen.explanation->at.lights) {
        const auto i = static_cast<std::size_t>(light.index);
        if (i < warnings.size() && warnings[i].empty() && light.n_dot_l < 0 && light.samples.empty())
            warnings[i] = "This light is behind the surface at the picked pixel";
    }
    return warnings;
}

/// S and M act on the row under the mouse.
bool focus_by_key(UiState& state, KeyPress press) {
    LightFocus& focus = state.get<LightFocus>();
    if (focus.hovered < 0 || !press.is_alone()) return false;
    if (press.key == Key::S) focus.toggle_solo(focus.hovered);
    if (press.key == Key::M) focus.toggle_muted(focus.hovered);
    return press.key == Key::S || press.key == Key::M;
}

std::string unless_light(const UiState& state) {
    return unless(selected_light(state.editor.selection) >= 0, "No light is selected");
}

std::vector<WindowCommand> focus_commands() {
    return {{.name = "Solo the selected light",
             .run = [](UiState& s) { s.get<LightFocus>().toggle_solo(s.editor.selection.index); },
             .why_disabled = unless_light,
             .changes_picture = true,
             .words = "alone only"},
            {.name = "Mute the selected light",
             .run = [](UiState& s) { s.get<LightFocus>().toggle_muted(s.editor.selection.index); },
             .why_disabled = unless_light,
             .changes_picture = true,
             .words = "off without hide"}};
}

}  // namespace

extern const Feature light_focus_feature;
const Feature light_focus_feature{.begin =
                                      [](UiState& s, const UiInput&) {
                                          LightFocus& focus = s.get<LightFocus>();
                                          focus.hovered = -1;
                                          const std::size_t lights = s.editor.scene().lights.size();
                                          if (focus.lights != lights) focus = {};
                                          focus.lights = lights;
                                          focus.warnings = warnings_of(s);
                                      },
                                  .shows = show_focus,
                                  .commands = focus_commands,
                                  .key = focus_by_key,
                                  .leave_document = [](UiState& s, const SceneDocument&) { end_focus(s); },
                                  .put_away = end_focus};

}  // namespace glint
