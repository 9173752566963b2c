// The commands of the menu View, but for the camera's and those that compare.
#include <imgui.h>

#include "ui/commands/command_rows.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/debug_view_controls.h"
#include "ui/features/views/scope.h"
#include "ui/features/views/views.h"
#include "ui/ui.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

void switch_magnifier(UiState& state) {
    zoom_about(state.get<MagnifierState>(), state.get<MagnifierState>().zoom > 1 ? 1 : usual_zoom,
               state.viewport.probe.value_or(glm::dvec2(0.5)));
}

void step_debug_view(UiState& state, int steps) {
    const DebugView shown = debug_view_after(state.get<DebugViewState>().set.choice.view, steps);
    show_quantity(state, shown);
    const std::string what = shown == DebugView::Picture
                                 ? "The picture again"
                                 : std::string(info_of(shown).label) + " in place of the picture";
    state.notifications.tell(what + " (" + keys_of(CommandId::NextDebugView) + ")");
}

bool shows_orientation(const UiState& state) {
    return state.get<DebugViewState>().set.choice.view == DebugView::Orientation;
}

void switch_over_range(UiState& state) {
    DebugViewSet& set = state.get<DebugViewState>().set;
    set.over_range = !set.over_range;
    if (set.over_range) show_quantity(state, DebugView::Picture, state.get<CompareState>().choice.on);
}

/// An arrow key asks about the pixel beside the picked one; with Shift it goes ten times as far.
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
                    return s.get<LectureState>().frozen ? it_is_frozen() : unless_drawn(s.rendered);
                },
            .words = "pick probe step"};
}

std::vector<WindowCommand> stepping_commands() {
    return {step_command<-1, 0>("Ask about the pixel to the left", Key::Left),
            step_command<1, 0>("Ask about the pixel to the right", Key::Right),
            step_command<0, -1>("Ask about the pixel above", Key::Up),
            step_command<0, 1>("Ask about the pixel below", Key::Down)};
}

std::string unless_scope(const UiState& state) {
    return unless(state.get<ScopeState>().open && state.rendered != nullptr, "The scope is not open");
}

std::vector<WindowCommand> scope_commands() {
    return {
        {.name = "Scope: red, green and blue",
         .run = [](UiState& s) { s.get<ScopeState>().channels ^= true; },
         .is_on = [](const UiState& s) { return s.get<ScopeState>().channels; },
         .why_disabled = unless_scope},
        {.name = "Scope: what the eye makes of it",
         .run = [](UiState& s) { s.get<ScopeState>().eye ^= true; },
         .is_on = [](const UiState& s) { return s.get<ScopeState>().eye; },
         .why_disabled = unless_scope,
         .words = "mach bands"},
        {.name = "Scope: the grey card",
         .run = [](UiState& s) { switch_card(s.get<ScopeState>(), s.rendered->size); },
         .is_on = [](const UiState& s) { return s.get<ScopeState>().card; },
         .why_disabled = unless_scope,
         .words = "mach bands"},
        {.name = "Scope: copy as command",
         .run = copy_profile_command,
         .why_disabled = unless_scope,
         .words = "clipboard profile"},
    };
}

std::vector<WindowCommand> looking_commands() {
    return {
        {.name = "Scan-line scope",
         .keys = {{Key::P}},
         .menu = Menu::View,
         .run = [](UiState& s) { toggle_scope(s.get<ScopeState>()); },
         .is_on = [](const UiState& s) { return s.get<ScopeState>().open; },
         .id = CommandId::Scope,
         .line_above = true,
         .changes_picture = true},
        {.name = "Vectors at the picked point",
         .keys = {{Key::V}},
         .menu = Menu::View,
         .run = [](UiState& s) { s.get<InspectorState>().shows_vectors ^= true; },
         .is_on = [](const UiState& s) { return s.get<InspectorState>().shows_vectors; }},
        {.name = "Back to the point picked before",
         .keys = {{Key::V, !ctrl, shift}},
         .menu = Menu::View,
         .run = [](UiState& s) { ask_as_before(s.viewport); },
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.viewport.probe_before.has_value(), "No other point was picked before");
             }},
        {.name = "Next quantity in place of the picture",
         .keys = {{Key::I}},
         .menu = Menu::View,
         .run = [](UiState& s) { step_debug_view(s, 1); },
         .id = CommandId::NextDebugView,
         .changes_picture = true},
        {.name = "Previous quantity in place of the picture",
         .keys = {{Key::I, !ctrl, shift}},
         .menu = Menu::View,
         .run = [](UiState& s) { step_debug_view(s, -1); },
         .id = CommandId::PreviousDebugView,
         .changes_picture = true},
        {.name = "Front and back of faces",
         .keys = {{Key::N, !ctrl, shift}},
         .menu = Menu::View,
         .run =
             [](UiState& s) {
                 show_quantity(s, shows_orientation(s) ? DebugView::Picture : DebugView::Orientation);
             },
         .is_on = shows_orientation,
         .changes_picture = true},
        {.name = "Stripes over what is too bright",
         .keys = {{Key::O}},
         .menu = Menu::View,
         .run = switch_over_range,
         .is_on = [](const UiState& s) { return s.get<DebugViewState>().set.over_range; },
         .id = CommandId::OverRange,
         .changes_picture = true,
         .words = "zebra clipped overexposed"},
        {.name = "Big pixels",
         .keys = {{Key::M}},
         .menu = Menu::View,
         .run = switch_magnifier,
         .is_on = [](const UiState& s) { return s.get<MagnifierState>().zoom > 1; },
         .id = CommandId::Magnify,
         .changes_picture = true},
        {.name = "Where the equation is evaluated",
         .keys = {{Key::J}},
         .menu = Menu::View,
         .run = [](UiState& s) { s.get<LitDotsState>().dots ^= true; },
         .is_on = [](const UiState& s) { return s.get<LitDotsState>().dots; },
         .id = CommandId::LitDots,
         .changes_picture = true},
        {.name = "Normals as needles where it is evaluated",
         .keys = {{Key::N}},
         .menu = Menu::View,
         .run = [](UiState& s) { s.get<LitDotsState>().needles ^= true; },
         .is_on = [](const UiState& s) { return s.get<LitDotsState>().needles; },
         .changes_picture = true},
    };
}

bool is_narrow_now() { return is_narrow(ImGui::GetIO().DisplaySize, px(1)); }

// In a narrow window both columns are tabs of one: to show one is to show its tab.

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
        {.name = "Scene column",
         .menu = Menu::View,
         .run = switch_scene_column,
         .is_on = shows_scene_column,
         .line_above = true},
        {.name = "Why column", .menu = Menu::View, .run = switch_why_column, .is_on = shows_why_column},
        {.name = "Picture alone",
         .keys = {{Key::F11}},
         .menu = Menu::View,
         .run = [](UiState& s) { s.layout.hides_columns ^= true; },
         .is_on = [](const UiState& s) { return s.layout.hides_columns; },
         .quiet = true,
         .words = "fullscreen columns"},
        {.name = "Caption of the scene",
         .menu = Menu::View,
         .run = [](UiState& s) { s.layout.caption ^= true; },
         .is_on = [](const UiState& s) { return s.layout.caption; },
         .quiet = true},
        {.name = "Light theme",
         .menu = Menu::View,
         .run = [](UiState& s) { s.dark ^= true; },
         .is_on = [](const UiState& s) { return !s.dark; },
         .line_above = true,
         .quiet = true,
         .words = "dark mode colours"},
        {.name = "Reset the window",
         .menu = Menu::View,
         .run = reset_layout,
         .words = "layout columns default"},
    };
}

}  // namespace

std::vector<WindowCommand> view_commands() {
    std::vector<WindowCommand> all;
    for (const auto rows :
         {looking_commands, scope_commands, stepping_commands, compare_commands, layout_commands})
        for (WindowCommand& row : rows()) all.push_back(std::move(row));
    return all;
}

}  // namespace glint
