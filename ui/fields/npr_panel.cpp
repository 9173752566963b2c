#include "ui/fields/npr_panel.h"

#include "ui/fields/field_panel.h"

namespace glint {

bool npr_panel(Npr& npr) {
    FieldPanel panel(npr, "/npr");
    panel.heading("Cool to warm").draw({"cool_to_warm", "cool", "warm", "alpha", "beta"});
    return panel.heading("Strokes").rest().edited();
}

}  // namespace glint
