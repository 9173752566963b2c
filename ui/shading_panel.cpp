#include "ui/shading_panel.h"

#include "ui/choices.h"
#include "ui/widgets.h"

namespace glint {
namespace {

bool term_fields(Terms& terms) {
    section("Terms of the equation");
    bool edited = false;
    edited |= switch_field("Emission", terms.emission,
                           {"What the surface shines by itself (key E)", "/shading/terms/emission"});
    edited |= switch_field("Ambient", terms.ambient,
                           {"Light from everywhere, the lights' own too (key A)", "/shading/terms/ambient"});
    edited |=
        switch_field("Diffuse", terms.diffuse, {"Light reflected evenly (key D)", "/shading/terms/diffuse"});
    edited |= switch_field("Specular", terms.specular, {"The highlight (key S)", "/shading/terms/specular"});
    return edited;
}

/// 0 and 2 to 65536: one entry would be no table.
bool power_table_field(Shading& shading) {
    int entries = shading.power_table;
    if (!integer_field("cosⁿ table", entries, 0, 65536, 0,
                       {"Entries of a table of cosⁿ to look highlights up in; 0: none, cosⁿ is worked out",
                        "/shading/power_table"}))
        return false;
    shading.power_table = entries == 1 ? (shading.power_table == 0 ? 2 : 0) : entries;
    return true;
}

}  // namespace

bool shading_panel(Shading& shading, glm::vec3& global_ambient) {
    bool edited = false;
    edited |= choice_field("Mode", shading.mode, mode_choices,
                           {"Where the lighting equation is evaluated (keys 1 to 4)", "/shading/mode"});
    edited |= choice_field("Reflection", shading.reflection, reflection_choices,
                           {"The lighting equation's highlight", "/shading/reflection"});
    edited |= choice_field("Interpolate", shading.interpolation, interpolation_choices,
                           {"How values between corners are found", "/shading/interpolation"});
    edited |= choice_field("Flat point", shading.flat_point, flat_point_choices,
                           {"Which point of a polygon is lit under flat", "/shading/flat_point"});
    edited |= choice_field("Rules", shading.rules, rules_choices, {"Whose rules", "/shading/rules"});
    section("Sides and viewer");
    edited |= choice_field("Cull", shading.cull, cull_choices, {"Which side is left out", "/shading/cull"});
    edited |= switch_field("Two-sided", shading.two_sided,
                           {"Seen from behind, the normal is turned round", "/shading/two_sided"});
    edited |= switch_field("Local view", shading.local_viewer,
                           {"v points to the eye; off: the same v everywhere, as if seen from far away",
                            "/shading/local_viewer"});
    edited |= term_fields(shading.terms);
    edited |= power_table_field(shading);
    section("Scene");
    edited |= colour_field("Ambient", global_ambient, glm::vec3(0.1f),
                           {"Light from everywhere, apart from all lights", "/global_ambient"});
    return edited;
}

bool display_panel(Display& display) {
    bool edited = false;
    edited |= number_field(
        "Exposure", display.exposure,
        {.min = 1e-4f, .max = 1e6f, .initial = 1, .speed = 0.01f, .shown_max = 0, .logarithmic = true},
        {"Multiplies the linear colour before it is shown", "/display/exposure"});
    edited |= choice_field("Transfer", display.transfer, transfer_choices,
                           {"How linear light becomes the numbers of the display", "/display/transfer"});
    edited |= colour_field("Background", display.background, {0.1f, 0.1f, 0.12f},
                           {"Colour where no object shows", "/display/background"});
    return edited;
}

}  // namespace glint
