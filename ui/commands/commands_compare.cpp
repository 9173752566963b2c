// The commands that compare: parts of the picture under wipe lines, a picture of one's own, a stored scene.
#include <imgui.h>

#include "ui/commands/command_rows.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/debug_view_controls.h"
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
    state.notifications.add(Tone::Done, "Stored as B: press " + keys_of(CommandId::ShowB) + " to look at it");
}

std::string unless_compared(const UiState& state) {
    if (state.get<CompareState>().choice.on) return {};
    return "Nothing is compared (" + keys_of(CommandId::Compare) + ")";
}

}  // namespace

std::vector<WindowCommand> compare_commands() {
    return {
        {.name = "Compare under wipe lines",
         .keys = {{Key::C}},
         .menu = Menu::View,
         .run = switch_compare,
         .is_on = [](const UiState& s) { return s.get<CompareState>().choice.on; },
         .id = CommandId::Compare,
         .changes_picture = true,
         .words = "split before after"},
        {.name = "Compare: the difference of the parts",
         .run = [](UiState& s) { s.get<CompareState>().choice.difference ^= true; },
         .is_on = [](const UiState& s) { return s.get<CompareState>().choice.difference; },
         .why_disabled = unless_compared,
         .changes_picture = true},
        {.name = "Compare: the difference twice as strong",
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
        {.name = "Compare my picture…",
         .menu = Menu::View,
         .run = [](UiState& s) { s.files.ask(FilePurpose::MyPicture, s.editor.document.path); },
         .words = "diagnose wrong mistake image"},
        {.name = "Put my picture away",
         .menu = Menu::View,
         .run = put_picture_away,
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.get<MyPictureState>().shown != nullptr,
                               "No picture was brought to compare with");
             }},
        {.name = "Look for two mistakes at once",
         .run = [](UiState& s) { ask_for_pairs(s.get<MyPictureState>()); },
         .why_disabled = [](const UiState& s) { return why_no_pairs(s.get<MyPictureState>()); },
         .words = "diagnose my picture pairs"},
        {.name = "Change the scene this way, to be sure",
         .run = [](UiState& s) { try_experiment(s, *offered_experiment(s)); },
         .why_disabled =
             [](const UiState& s) {
                 return unless(offered_experiment(s) != nullptr,
                               "No change would tell more of the mistake in a picture");
             },
         .words = "diagnose my picture experiment"},
        {.name = "Look at B, the stored scene",
         .keys = {{Key::B}},
         .menu = Menu::View,
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
         .menu = Menu::View,
         .run = store_b,
         .id = CommandId::StoreB,
         .changes_picture = true,
         .words = "snapshot compare"},
    };
}

}  // namespace glint
