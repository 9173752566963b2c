#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "renderer/renderer.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

void cone_fields(SpotCone& spot, const std::string& pointer) {
    const float closed_deg = SpotCone{}.cutoff_deg, open_deg = 180;
    FieldPanel panel(spot, pointer);
    panel.draw({"direction"}).draw_as("cutoff_deg", [&](const Row&, const Help& help, const auto& usual) {
        bool open = spot.cutoff_deg == open_deg;
        if (switch_field("All round", open,
                         {"Shines in all directions, like a bulb: a cutoff of 180 degrees", help.pointer}))
            spot.cutoff_deg = open ? open_deg : closed_deg;
        if (!open) usual();
    });
    panel.draw_as("inner_deg", [&](const Row&, const Help& help, const auto& usual) {
        if (spot.cutoff_deg == open_deg) return;
        bool soft = spot.inner_deg < spot.cutoff_deg;
        if (switch_field("Soft edge", soft, {"Fades from an inner angle to the cutoff", help.pointer}))
            spot.inner_deg = soft ? 0.7f * spot.cutoff_deg : SpotCone{}.inner_deg;
        if (soft) usual();
    });
    panel.rest();
}

void area_fields(AreaShape& area, const std::string& pointer) {
    FieldPanel panel(area, pointer);
    panel.draw({"edge_u", "edge_v"}).draw_as("samples", [&](const Row&, const Help& help, const auto&) {
        int across = 1;
        while ((across + 1) * (across + 1) <= area.samples) ++across;
        if (integer_field("Samples n", across, Count{1, 8}, 4, help)) area.samples = across * across;
    });
    panel.rest();
}

}  // namespace

void light_panel(Light& light, const std::string& pointer, const Camera& camera, const Dome& dome,
                 const ScreenMap& map) {
    FieldPanel panel(light, pointer);
    panel.draw({"name"});
    panel.draw_as("type", [&](const Row& row, const Help& help, const auto&) {
        LightKind kind = light.kind;
        if (choice_field(row.label, kind, help)) light = as_kind(light, kind, dome, map);
    });
    panel.draw_as("space", [&](const Row& row, const Help& help, const auto&) {
        LightSpace space = light.space;
        const Help how{
            "Coordinate system of the position. Switching keeps the light in place; with Alt it keeps the "
            "coordinates",
            help.pointer};
        if (!segment_field(row.label, space, how)) return;
        if (ImGui::GetIO().KeyAlt)
            light.space = space;
        else
            light = in_space(light, space, camera);
    });
    panel.draw({"enabled", "position"})
        .heading("Light")
        .draw({"intensity", "diffuse", "specular", "ambient"});
    panel.group("falloff", light.falloff, field_rows<Falloff>);
    panel.group("spot", light.spot, cone_fields);
    panel.group("area", light.area, area_fields);
    panel.rest();
}

namespace {

constexpr double least_highlight =
    0.02;                         // as a fraction of the display's range; anything fainter does not count
constexpr double back = 0.95;     // above this fraction, the highlight looks complete
constexpr int shown_width = 320;  // width of the picture used for measuring

/// Returns the scene with only that object, and only the specular term.
Scene specular_alone(Scene scene, std::size_t object) {
    const Object kept = scene.objects[object];
    scene.objects = {kept};
    scene.global_ambient = glm::vec3(0);
    scene.display.background = glm::vec3(0);
    scene.npr = {};
    scene.transport = {};
    scene.shading.terms = {.emission = false, .ambient = false, .diffuse = false, .specular = true};
    return scene;
}

double brightest(Renderer& renderer, const Scene& scene, PictureSize size) {
    const Picture& picture = renderer.render(scene, size, true);
    const auto most = std::max_element(picture.linear.begin(), picture.linear.end());
    return most == picture.linear.end() ? 0 : double{*most};
}

}  // namespace

std::optional<double> highlight_share(const Scene& scene, std::size_t object, PictureSize size) {
    Renderer renderer(1);
    Scene alone = specular_alone(scene, object);
    const double kept = brightest(renderer, alone, size);
    alone.shading.mode = ShadingMode::Phong;
    const double whole = brightest(renderer, alone, size);
    if (whole < least_highlight) return std::nullopt;
    return kept / whole;
}

std::string highlight_words(HighlightShareState& state, const Scene& scene, std::size_t object,
                            PictureSize size) {
    const ShadingMode mode = scene.shading.mode;
    const bool lights_corners = mode == ShadingMode::Flat || mode == ShadingMode::Gouraud;
    if (!lights_corners || !scene.objects[object].mesh || !scene.objects[object].visible) return {};
    const int width = std::min(shown_width, size.width);
    const PictureSize small{width, std::max(1, width * size.height / size.width)};
    update_at_rest(state.share, {scene, object}, [&] { return highlight_share(scene, object, small); });
    const std::optional<double>* share = state.share.value();
    if (share == nullptr || !*share) return {};
    return fmt::format("Highlight: {:.2f} of what Phong shading shows{}", **share,
                       **share >= back ? ", nearly complete" : "");
}

}  // namespace glint
