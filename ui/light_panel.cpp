#include "ui/light_panel.h"

#include <imgui.h>

#include <array>

#include "ui/choices.h"
#include "ui/limits.h"
#include "ui/scene_numbers.h"

namespace glint {
namespace {

bool position_field(Light& light, const std::string& pointer) {
    glm::vec3 place(light.position);
    const bool direction = light.kind == LightKind::Directional;
    const Number number{.speed = direction ? 0.005f : 0.01f, .format = "%.2f"};
    const bool edited = vector_field(direction ? "Towards" : "Position", place, number, {0, 2, 2},
                                     {direction ? "Direction from the scene to the light (w = 0), any length"
                                                : "Where the light is, scene units, in its own coordinates",
                                      pointer + "/position"});
    if (edited) {
        // A place with another w than 1 is divided by it; what is edited is what the numbers say.
        light.position = {place, light.position.w};
    }
    return edited;
}

bool falloff_fields(Falloff& falloff, const std::string& pointer) {
    section("Falloff  1 / (c + l·r + q·r²)");
    bool edited = false;
    const auto field = [&](const char* label, float& value, const NumberSpec& spec, const char* key) {
        edited |= number_field(label, value, spec.number, {spec.what, pointer + "/falloff/" + key});
    };
    field("Constant", falloff.constant, falloff_constant_spec, "constant");
    field("Linear", falloff.linear, falloff_linear_spec, "linear");
    field("Quadratic", falloff.quadratic, falloff_quadratic_spec, "quadratic");
    return edited;
}

bool cone_fields(SpotCone& spot, const std::string& pointer) {
    section("Cone");
    bool edited = vector_field("Aim", spot.direction, {.speed = 0.005f, .format = "%.2f"}, {0, -1, 0},
                               {"Where the cone's axis points, any length", pointer + "/spot/direction"});
    bool open = spot.cutoff_deg > 90;
    if (switch_field("No cone", open, {"180 degrees: shines all round", pointer + "/spot/cutoff_deg"})) {
        spot.cutoff_deg = open ? 180.0f : 30.0f;
        edited = true;
    }
    if (!open)
        edited |= number_field("Cutoff", spot.cutoff_deg, cutoff_spec.number,
                               {cutoff_spec.what, pointer + "/spot/cutoff_deg"});
    edited |= number_field("Exponent", spot.exponent, spot_exponent_spec.number,
                           {spot_exponent_spec.what, pointer + "/spot/exponent"});
    return edited;
}

bool area_fields(AreaShape& area, const std::string& pointer) {
    section("Area");
    const Number edge{.speed = 0.005f, .format = "%.2f"};
    bool edited = false;
    edited |= vector_field("Edge u", area.edge_u, edge, {0.5f, 0, 0},
                           {"Half-edge of the parallelogram", pointer + "/area/edge_u"});
    edited |= vector_field("Edge v", area.edge_v, edge, {0, 0, 0.5f},
                           {"Half-edge of the parallelogram", pointer + "/area/edge_v"});
    int across = 1;
    while ((across + 1) * (across + 1) <= area.samples) ++across;
    if (integer_field("Samples n", across, 1, 8, 4,
                      {"n × n point samples stand for the area", pointer + "/area/samples"})) {
        area.samples = across * across;
        edited = true;
    }
    return edited;
}

bool colour_fields(Light& light, const std::string& pointer) {
    section("Light");
    bool edited = false;
    edited |= number_field("Intensity", light.intensity, intensity_spec.number,
                           {intensity_spec.what, pointer + "/intensity"});
    edited |= colour_field("Diffuse", light.diffuse, glm::vec3(1),
                           {"Colour for the diffuse term", pointer + "/diffuse"});
    edited |= colour_field("Specular", light.specular, glm::vec3(1),
                           {"Colour for the highlight", pointer + "/specular"});
    edited |= colour_field("Ambient", light.ambient, glm::vec3(0),
                           {"Colour for the ambient term", pointer + "/ambient"});
    return edited;
}

}  // namespace

bool light_panel(Light& light, const std::string& pointer, const Camera& camera, const Dome& dome,
                 const ScreenMap& map) {
    const Light before = light;
    bool edited = name_field("Name", light.name, {"What the light is called", pointer + "/name"});
    LightKind kind = light.kind;
    if (choice_field("Type", kind, light_kind_choices, {"Kind of light", pointer + "/type"})) {
        light = as_kind(light, kind, dome, map);
        edited = true;
    }
    LightSpace space = light.space;
    if (segment_field("Space", space, space_choices,
                      {"Coordinates in which it stands; changing it keeps the light where it is (with Alt: "
                       "its numbers)",
                       pointer + "/space"})) {
        if (ImGui::GetIO().KeyAlt)
            light.space = space;
        else
            light = in_space(light, space, camera);
        edited = true;
    }
    edited |= switch_field("On", light.enabled, {"Whether it shines", pointer + "/enabled"});
    edited |= position_field(light, pointer);
    edited |= colour_fields(light, pointer);
    if (light.kind == LightKind::Point || light.kind == LightKind::Spot)
        edited |= falloff_fields(light.falloff, pointer);
    if (light.kind == LightKind::Spot) edited |= cone_fields(light.spot, pointer);
    if (light.kind == LightKind::Area) edited |= area_fields(light.area, pointer);
    return edited && keep_valid(light, before);
}

}  // namespace glint
