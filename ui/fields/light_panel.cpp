#include <imgui.h>

#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"

namespace glint {
namespace {

bool cone_fields(SpotCone& spot, const std::string& pointer) {
    const float closed_deg = SpotCone{}.cutoff_deg, open_deg = 180;
    FieldPanel panel(spot, pointer);
    panel.draw({"direction"}).draw_as("cutoff_deg", [&](const Row& row, const Help& help, const auto& usual) {
        bool open = spot.cutoff_deg == open_deg;
        bool edited =
            switch_field("All round", open,
                         {"Shines in all directions, like a bulb: a cutoff of 180 degrees", help.pointer});
        if (edited) spot.cutoff_deg = open ? open_deg : closed_deg;
        (void)row;
        return open ? edited : usual() || edited;
    });
    panel.draw_as("inner_deg", [&](const Row&, const Help& help, const auto& usual) {
        if (spot.cutoff_deg == open_deg) return false;
        bool soft = spot.inner_deg < spot.cutoff_deg;
        const bool edited =
            switch_field("Soft edge", soft, {"Fades from an inner angle to the cutoff", help.pointer});
        if (edited) spot.inner_deg = soft ? 0.7f * spot.cutoff_deg : SpotCone{}.inner_deg;
        return soft ? usual() || edited : edited;
    });
    return panel.rest().edited();
}

bool area_fields(AreaShape& area, const std::string& pointer) {
    FieldPanel panel(area, pointer);
    panel.draw({"edge_u", "edge_v"}).draw_as("samples", [&](const Row&, const Help& help, const auto&) {
        int across = 1;
        while ((across + 1) * (across + 1) <= area.samples) ++across;
        if (!integer_field("Samples n", across, Count{1, 8}, 4, help)) return false;
        area.samples = across * across;
        return true;
    });
    return panel.rest().edited();
}

}  // namespace

bool light_panel(Light& light, const std::string& pointer, const Camera& camera, const Dome& dome,
                 const ScreenMap& map) {
    const Light before = light;
    FieldPanel panel(light, pointer);
    panel.draw({"name"});
    panel.draw_as("type", [&](const Row& row, const Help& help, const auto&) {
        LightKind kind = light.kind;
        if (!choice_field(row.label, kind, help)) return false;
        light = as_kind(light, kind, dome, map);
        return true;
    });
    panel.draw_as("space", [&](const Row& row, const Help& help, const auto&) {
        LightSpace space = light.space;
        const Help how{
            "Coordinate system of the position; changing it keeps the light where it is (with Alt: its "
            "numbers)",
            help.pointer};
        if (!segment_field(row.label, space, how)) return false;
        if (ImGui::GetIO().KeyAlt)
            light.space = space;
        else
            light = in_space(light, space, camera);
        return true;
    });
    panel.draw({"enabled", "position"})
        .heading("Light")
        .draw({"intensity", "diffuse", "specular", "ambient"});
    panel.group("falloff", light.falloff, field_rows<Falloff>);
    panel.group("spot", light.spot, cone_fields);
    panel.group("area", light.area, area_fields);
    return panel.rest().edited() && keep_valid(light, before);
}

}  // namespace glint
