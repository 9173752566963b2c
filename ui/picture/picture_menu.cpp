// The context menu of the picture.
#include <fmt/core.h>

#include <utility>

#include "ui/commands/command.h"
#include "ui/feature.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

struct PictureMenuState {
    glm::dvec2 pixel{0};  // the clicked pixel, in the drawn picture
};

/// Returns the light that the menu moves: the selected one, or else the one that contributes most at the
/// clicked pixel; -1: none.
int light_of(const UiState& state) {
    const int selected = selected_light(state.editor.selection);
    if (selected >= 0 || state.editor.scene().lights.empty()) return selected;
    return state.viewport.main_light ? state.viewport.main_light->light : 0;
}

bool item(const char* name, bool possible = true) {
    const bool chosen = ImGui::MenuItem(name, "", false, possible);
    list_control(name, "", last_item());
    return chosen;
}

void light_items(UiState& state, const PictureView& view, glm::dvec2 pixel) {
    const int index = light_of(state);
    const Renderer* const renderer = renderer_of_open_scene(state, view.map.size);
    Scene& scene = state.editor.scene();
    const bool possible = index >= 0 && renderer != nullptr && !state.on_screen.is_out_of_hand();
    if (!possible) return;
    Light& light = scene.lights[static_cast<std::size_t>(index)];
    const SurfaceView surface{scene, *renderer, view.map, view.dome};
    ImGui::Separator();
    const std::string name = whole_label(light.name);
    for (const auto& [label, effect] : {std::pair("Brightest here", LightEffect::Brightest),
                                        std::pair("Rim light here", LightEffect::Rim)}) {
        const std::optional<Light> moved = with_effect(effect, light, surface, pixel);
        if (item(fmt::format("{}: {}", label, name).c_str(), moved.has_value())) light = *moved;
    }
    const auto point = seen_at(*renderer, view.map.size, pixel);
    const bool has_aim = light.kind == LightKind::Spot || light.kind == LightKind::Area;
    if (item(fmt::format("Aim here: {}", name).c_str(), has_aim && point.has_value()))
        light = aimed_at(light, in_world(view.map, point->position, 1), {view.map, view.dome});
}

void copy_colour(UiState& state, glm::ivec2 at) {
    const Picture& shown = *state.displayed;
    const glm::ivec2 pixel = pixel_at_place(at, state.full_size, shown.size);
    const std::uint8_t* const bytes = &shown.rgba[4 * shown.pixel(pixel.x, pixel.y)];
    const std::string text = fmt::format("#{:02x}{:02x}{:02x}", bytes[0], bytes[1], bytes[2]);
    ImGui::SetClipboardText(text.c_str());
    state.notifications.tell(text + " is on the clipboard");
}

void draw_menu(ImDrawList&, UiState& state, const PictureView& view) {
    PictureMenuState& menu = state.get<PictureMenuState>();
    if (std::exchange(state.viewport.wants_menu, false) && state.on_screen.refusal().empty()) {
        menu.pixel = state.viewport.pressed_px;
        ImGui::OpenPopup("##picture menu");
    }
    if (!ImGui::BeginPopup("##picture menu")) return;
    const glm::ivec2 at = nearest_pixel(view.map.size, menu.pixel);
    if (item("Why this colour?")) {
        ask_about(state.viewport,
                  (glm::dvec2(at) + 0.5) / glm::dvec2(view.map.size.width, view.map.size.height));
        state.left_shows_inspector = state.layout.right = true;
    }
    if (item("Copy colour")) copy_colour(state, at);
    light_items(state, view, menu.pixel);
    ImGui::EndPopup();
}

}  // namespace

extern const Feature picture_menu_feature;
const Feature picture_menu_feature{.overlay = draw_menu};

}  // namespace glint
