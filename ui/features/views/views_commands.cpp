// The commands of the views: the scope, quantities, dots, comparisons.
#include <imgui.h>

#include "ui/commands/command.h"
#include "ui/document/loading.h"
#include "ui/features/views/scope.h"
#include "ui/features/views/views.h"
#include "ui/ui.h"

namespace glint {
namespace {

void switch_compare(UiState& state) {
    state.get<CompareState>().choice.on ^= true;
    state.get<DebugViewState>().set.choice.view = DebugView::Picture;
}

void switch_b(UiState& state) {
    CompareState& compare = state.get<CompareState>();
    compare.choice.shows_stored = !compare.choice.shows_stored;
    compare.b_turned = true;
    compare.b_since = ImGui::GetTime();
    compare.b_frames = 0;
}

void store_b(UiState& state) {
    CompareChoice& choice = state.get<CompareState>().choice;
    choice.stored = std::make_shared<const Scene>(as_made(state, state.editor.scene()));
    choice.shows_stored = false;
    state.notifications.add(Tone::Done, "Stored as B: press " + keys_of(CommandId::ShowB) + " to view it");
}

std::string unless_compared(const UiState& state) {
    if (state.get<CompareState>().choice.on) return {};
    return "No comparison is shown (" + keys_of(CommandId::Compare) + ")";
}

void step_debug_view(UiState& state, int steps) {
    const DebugView shown = debug_view_after(state.get<DebugViewState>().set.choice.view, steps);
    show_quantity(state, shown);
    const std::string what = shown == DebugView::Picture
                                 ? "Back to the picture"
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

std::string unless_scope(const UiState& state) {
    return unless(state.get<ScopeState>().open && state.rendered != nullptr, "The scope is not open");
}

}  // namespace

std::vector<WindowCommand> scope_commands() {
    return {
        {.name = "Scan-line scope",
         .keys = {{Key::P}},
         .section = Section::InspectScope,
         .run = [](UiState& s) { toggle_scope(s.get<ScopeState>()); },
         .is_on = [](const UiState& s) { return s.get<ScopeState>().open; },
         .id = CommandId::Scope,
         .line_above = true,
         .changes_picture = true},
        {.name = "Scope: red, green and blue",
         .run = [](UiState& s) { s.get<ScopeState>().channels ^= true; },
         .is_on = [](const UiState& s) { return s.get<ScopeState>().channels; },
         .why_disabled = unless_scope},
        {.name = "Scope: what the eye perceives",
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

std::vector<WindowCommand> debug_view_commands() {
    return {
        {.name = "Next quantity in place of the picture",
         .keys = {{Key::I}},
         .section = Section::InspectQuantity,
         .run = [](UiState& s) { step_debug_view(s, 1); },
         .id = CommandId::NextDebugView,
         .changes_picture = true},
        {.name = "Previous quantity in place of the picture",
         .keys = {{Key::I, !ctrl, shift}},
         .section = Section::InspectQuantity,
         .run = [](UiState& s) { step_debug_view(s, -1); },
         .id = CommandId::PreviousDebugView,
         .changes_picture = true},
        {.name = "Front and back of faces",
         .keys = {{Key::N, !ctrl, shift}},
         .section = Section::InspectQuantity,
         .run =
             [](UiState& s) {
                 show_quantity(s, shows_orientation(s) ? DebugView::Picture : DebugView::Orientation);
             },
         .is_on = shows_orientation,
         .changes_picture = true},
        {.name = "Stripes over colours that are too bright",
         .keys = {{Key::O}},
         .section = Section::InspectQuantity,
         .run = switch_over_range,
         .is_on = [](const UiState& s) { return s.get<DebugViewState>().set.over_range; },
         .id = CommandId::OverRange,
         .changes_picture = true,
         .words = "zebra clipped overexposed"},
    };
}

std::vector<WindowCommand> lit_dots_commands() {
    return {
        {.name = "Where the equation is evaluated",
         .keys = {{Key::J}},
         .section = Section::InspectDots,
         .run = [](UiState& s) { s.get<LitDotsState>().dots ^= true; },
         .is_on = [](const UiState& s) { return s.get<LitDotsState>().dots; },
         .id = CommandId::LitDots,
         .changes_picture = true},
        {.name = "Normals as needles at the evaluated points",
         .keys = {{Key::N}},
         .section = Section::InspectDots,
         .run = [](UiState& s) { s.get<LitDotsState>().needles ^= true; },
         .is_on = [](const UiState& s) { return s.get<LitDotsState>().needles; },
         .changes_picture = true},
    };
}

std::vector<WindowCommand> compare_commands() {
    return {
        {.name = "Compare with wipe lines",
         .keys = {{Key::C}},
         .section = Section::Compare,
         .run = switch_compare,
         .is_on = [](const UiState& s) { return s.get<CompareState>().choice.on; },
         .id = CommandId::Compare,
         .changes_picture = true,
         .words = "split before after"},
        {.name = "Compare: the difference between the parts",
         .run = [](UiState& s) { s.get<CompareState>().choice.difference ^= true; },
         .is_on = [](const UiState& s) { return s.get<CompareState>().choice.difference; },
         .why_disabled = unless_compared,
         .changes_picture = true},
        {.name = "Compare: double the difference",
         .run = [](UiState& s) { double_gain(s.get<CompareState>().choice); },
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.get<CompareState>().choice.on && s.get<CompareState>().choice.difference,
                               "No difference is shown");
             },
         .changes_picture = true,
         .words = "gain scale"},
        {.name = "Compare: the parts one above the other",
         .run = [](UiState& s) { s.get<CompareState>().choice.stacked ^= true; },
         .is_on = [](const UiState& s) { return s.get<CompareState>().choice.stacked; },
         .why_disabled = unless_compared,
         .changes_picture = true,
         .words = "stacked side by side"},
    };
}

std::vector<WindowCommand> stored_scene_commands() {
    return {
        {.name = "View B, the stored scene",
         .keys = {{Key::B}},
         .section = Section::CompareStored,
         .run = switch_b,
         .is_on = [](const UiState& s) { return s.get<CompareState>().choice.shows_stored; },
         .why_disabled =
             [](const UiState& s) {
                 return s.get<CompareState>().choice.stored
                            ? std::string()
                            : "No scene is stored as B (" + keys_of(CommandId::StoreB) + ")";
             },
         .id = CommandId::ShowB,
         .changes_picture = true},
        {.name = "Store the scene as B",
         .keys = {{Key::B, ctrl}},
         .section = Section::CompareStored,
         .run = store_b,
         .id = CommandId::StoreB,
         .changes_picture = true,
         .words = "snapshot compare"},
    };
}

}  // namespace glint
