// The commands of the View menu, except those for the camera and those of features.
#include <imgui.h>

#include "ui/commands/command.h"
#include "ui/picture/magnifier.h"
#include "ui/ui.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

void switch_magnifier(UiState& state) {
    zoom_about(state.get<MagnifierState>(), state.get<MagnifierState>().zoom > 1 ? 1 : usual_zoom,
               state.viewport.probe.value_or(glm::dvec2(0.5)));
}

/// An arrow key picks the pixel next to the picked one; with Shift, ten pixels away.
template <int right, int down> WindowCommand step_command(const char* name, Key key) {
    return {.name = name,
            .keys = {{key}, {key, !ctrl, shift}},
            .run =
                [](UiState& s) {
                    const int pixels = ImGui::GetIO().KeyShift ? 10 : 1;
                    step_probe(s.viewport, s.rendered->size, pixels * glm::ivec2(right, down));
                    s.left_shows_inspector = true;
                },
            .why_disabled =
                [](const UiState& s) {
                    const std::string refusal = s.on_screen.refusal();
                    return refusal.empty() ? unless_drawn(s.rendered) : refusal;
                },
            .words = "pick probe step"};
}

std::vector<WindowCommand> stepping_commands() {
    return {step_command<-1, 0>("Pick the pixel to the left", Key::Left),
            step_command<1, 0>("Pick the pixel to the right", Key::Right),
            step_command<0, -1>("Pick the pixel above", Key::Up),
            step_command<0, 1>("Pick the pixel below", Key::Down)};
}

std::vector<WindowCommand> looking_commands() {
    return {
        {.name = "Back to the point picked before",
         .keys = {{Key::V, !ctrl, shift}},
         .section = Section::InspectProbe,
         .run = [](UiState& s) { ask_as_before(s.viewport); },
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.viewport.probe_before.has_value(), "No other point was picked before");
             }},
        {.name = "Big pixels",
         .keys = {{Key::M}},
         .section = Section::InspectPixels,
         .run = switch_magnifier,
         .is_on = [](const UiState& s) { return s.get<MagnifierState>().zoom > 1; },
         .id = CommandId::Magnify,
         .changes_picture = true},
    };
}

bool is_narrow_now() { return is_narrow(ImGui::GetIO().DisplaySize, px(1)); }

// In a narrow window both columns are tabs of a single one: showing a column selects its tab.

bool shows_scene_column(const UiState& s) {
    return s.layout.left && !s.layout.hides_columns && !(is_narrow_now() && s.left_shows_inspector);
}
bool shows_why_column(const UiState& s) {
    return s.layout.right && !s.layout.hides_columns && (!is_narrow_now() || s.left_shows_inspector);
}

void switch_scene_column(UiState& s) {
    s.layout.left = !shows_scene_column(s);
    s.layout.hides_columns = false;
    s.left_shows_inspector = !s.layout.left;
}

void switch_why_column(UiState& s) {
    s.layout.right = !shows_why_column(s);
    s.layout.hides_columns = false;
    s.left_shows_inspector = s.layout.right;
}

std::vector<WindowCommand> layout_commands() {
    return {
        {.name = "Keys and mouse",
         .keys = {{Key::F1}, {Key::Question, !ctrl, shift}},
         .section = Section::Help,
         .run = [](UiState& s) { s.shows_shortcuts ^= true; },
         .is_on = [](const UiState& s) { return s.shows_shortcuts; },
         .words = "help shortcuts keyboard"},
        {.name = "Scene column",
         .section = Section::ViewWindow,
         .run = switch_scene_column,
         .is_on = shows_scene_column,
         .line_above = true},
        {.name = "Why column",
         .section = Section::ViewWindow,
         .run = switch_why_column,
         .is_on = shows_why_column},
        {.name = "Picture alone",
         .keys = {{Key::F11}},
         .section = Section::ViewWindow,
         .run = [](UiState& s) { s.layout.hides_columns ^= true; },
         .is_on = [](const UiState& s) { return s.layout.hides_columns; },
         .quiet = true,
         .words = "fullscreen columns"},
        {.name = "Caption of the scene",
         .section = Section::ViewWindow,
         .run = [](UiState& s) { s.layout.caption ^= true; },
         .is_on = [](const UiState& s) { return s.layout.caption; },
         .quiet = true},
        {.name = "Light theme",
         .section = Section::ViewWindow,
         .run = [](UiState& s) { s.dark ^= true; },
         .is_on = [](const UiState& s) { return !s.dark; },
         .line_above = true,
         .quiet = true,
         .words = "dark mode colours"},
        {.name = "Reset the window",
         .section = Section::ViewWindow,
         .run = reset_layout,
         .words = "layout columns default"},
    };
}

}  // namespace

std::vector<WindowCommand> view_commands() {
    std::vector<WindowCommand> all;
    for (const auto rows : {looking_commands, stepping_commands, layout_commands})
        for (WindowCommand& row : rows()) all.push_back(std::move(row));
    return all;
}

}  // namespace glint
