#include "ui/fields/field_panel.h"

namespace glint {

bool shading_panel(Shading& shading, glm::vec3& global_ambient) {
    FieldPanel panel(shading, "/shading");
    panel.draw({"mode", "reflection", "interpolation", "flat_point", "rules"});
    panel.heading("Sides and viewer").draw({"cull", "two_sided", "local_viewer"});
    panel.group("terms", shading.terms, field_rows<Terms>);
    bool edited = panel.rest().edited();
    section_heading("Scene");
    edited |= colour_field("Ambient", global_ambient, Scene{}.global_ambient,
                           {"Light from everywhere, apart from all lights", "/global_ambient"});
    return edited;
}

bool display_panel(Display& display) {
    return FieldPanel(display, "/display").draw({"exposure", "transfer"}).rest().edited();
}

bool npr_panel(Npr& npr) {
    FieldPanel panel(npr, "/npr");
    panel.heading("Cool to warm").draw({"cool_to_warm", "cool", "warm", "alpha", "beta"});
    return panel.heading("Strokes").rest().edited();
}

}  // namespace glint
