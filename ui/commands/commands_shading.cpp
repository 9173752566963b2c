// The shading modes and the terms of the equation: they stand in the tool bar and in no menu.
#include "ui/commands/command_rows.h"
#include "ui/ui.h"

namespace glint {
namespace {

template <ShadingMode mode> WindowCommand mode_command(const char* name, Key key, const char* sets) {
    return {.name = name,
            .keys = {{key}},
            .run = [](UiState& s) { s.editor.scene().shading.mode = mode; },
            .is_on = [](const UiState& s) { return s.editor.scene().shading.mode == mode; },
            .sets = sets};
}

template <bool Terms::*term> WindowCommand term_command(const char* name, Key key, const char* sets) {
    return {.name = name,
            .keys = {{key}},
            .run = [](UiState& s) { s.editor.scene().shading.terms.*term ^= true; },
            .is_on = [](const UiState& s) { return s.editor.scene().shading.terms.*term; },
            .sets = sets};
}

}  // namespace

std::vector<WindowCommand> shading_commands() {
    return {
        mode_command<ShadingMode::Flat>("Flat shading", Key::Digit1, "/shading/mode = \"flat\""),
        mode_command<ShadingMode::Facet>("Facet shading", Key::Digit2, "/shading/mode = \"facet\""),
        mode_command<ShadingMode::Gouraud>("Gouraud shading", Key::Digit3, "/shading/mode = \"gouraud\""),
        mode_command<ShadingMode::Phong>("Phong shading", Key::Digit4, "/shading/mode = \"phong\""),
        term_command<&Terms::emission>("Emission on or off", Key::E, "/shading/terms/emission"),
        term_command<&Terms::ambient>("Ambient on or off", Key::A, "/shading/terms/ambient"),
        term_command<&Terms::diffuse>("Diffuse on or off", Key::D, "/shading/terms/diffuse"),
        term_command<&Terms::specular>("Specular on or off", Key::S, "/shading/terms/specular"),
    };
}

}  // namespace glint
