
#include <algorithm>

#include "ui/commands/command.h"
#include "ui/commands/menus.h"
#include "ui/document/document_actions.h"
#include "ui/picture/draw_picture.h"

namespace glint {
namespace {

/// Opens the dialog in the folder of the open scene, or in the working directory; in the examples' folder if
/// that contains no scene.
void ask_scene(UiState& state) {
    const std::string& path = state.editor.document.path;
    state.files.ask(open_purpose, path);
    const auto is_file = [](const FolderEntry& entry) { return !entry.folder; };
    const bool fits = std::any_of(state.files.entries.begin(), state.files.entries.end(), is_file);
    if (!fits && !state.shipped_scenes.empty()) state.files.ask(open_purpose, state.shipped_scenes + "/");
}

void begin_anew(UiState& state) {
    cancel_loads(state);
    take_scene(state, first_scene());
}

}  // namespace

std::vector<WindowCommand> file_commands() {
    return {
        {.name = "New scene",
         .keys = {{Key::N, ctrl}},
         .section = Section::FileOpen,
         .run = [](UiState& s) { ask_first(s, begin_anew); }},
        {.name = "Open…",
         .keys = {{Key::O, ctrl}},
         .section = Section::FileOpen,
         .run = ask_scene,
         .id = CommandId::Open,
         .words = "load import"},
        {.name = "Save",
         .keys = {{Key::S, ctrl}},
         .section = Section::FileSave,
         .run = [](UiState& s) { save(s); },
         .line_above = true},
        {.name = "Save as…",
         .keys = {{Key::S, ctrl, shift}},
         .section = Section::FileSave,
         .run = [](UiState& s) { s.files.ask(save_purpose, offered_name(s, ".json")); }},
        {.name = "Quit",
         .keys = {{Key::Q, ctrl}},
         .section = Section::FileQuit,
         .run = [](UiState& s) { ask_first(s, [](UiState& now) { now.quits = true; }); },
         .id = CommandId::Quit,
         .line_above = true,
         .words = "exit close"},
    };
}

}  // namespace glint
