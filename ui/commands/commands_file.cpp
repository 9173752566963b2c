// The commands of the menu File.

#include <algorithm>

#include "ui/commands/command_rows.h"
#include "ui/commands/menus.h"
#include "ui/document/document_actions.h"
#include "ui/features/export/clipboard.h"
#include "ui/features/export/export_picture.h"
#include "ui/features/export/save_with_command.h"
#include "ui/features/lecture/examples.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lessons_dialog.h"
#include "ui/picture/draw_picture.h"

namespace glint {
namespace {

/// Opens the dialog in the open scene's folder, else here; with the examples if there is no scene in it.
void ask_scene(UiState& state) {
    const std::string& path = state.editor.document.path;
    state.files.ask(FilePurpose::OpenScene, path);
    const auto is_file = [](const FolderEntry& entry) { return !entry.folder; };
    const bool fits = std::any_of(state.files.entries.begin(), state.files.entries.end(), is_file);
    if (!fits && !state.shipped_scenes.empty())
        state.files.ask(FilePurpose::OpenScene, state.shipped_scenes + "/");
}

std::string unless_picture_can_be_written(const UiState& state) {
    return state.rendered == nullptr ? unless_drawn(nullptr)
                                     : unless_busy(bool(state.get<ExportState>().job));
}

std::string copy_disabled_reason(const UiState& state) {
    if (state.get<ExportState>().job) return unless_busy(true);
    return state.rendered == nullptr ? unless_drawn(nullptr) : clipboard_disabled_reason();
}

}  // namespace

std::vector<WindowCommand> file_commands() {
    return {
        {.name = "New scene",
         .keys = {{Key::N, ctrl}},
         .menu = Menu::File,
         .run = [](UiState& s) { begin_pending(s, Pending::What::New); }},
        {.name = "Open…",
         .keys = {{Key::O, ctrl}},
         .menu = Menu::File,
         .run = ask_scene,
         .id = CommandId::Open,
         .words = "load import"},
        {.name = "Examples…",
         .keys = {{Key::O, ctrl, shift}},
         .menu = Menu::File,
         .run = open_examples,
         .why_disabled =
             [](const UiState& s) {
                 return unless(!s.shipped_scenes.empty(), "The scenes of Glint are not installed");
             }},
        {.name = "Lessons…",
         .keys = {{Key::L, ctrl}},
         .menu = Menu::File,
         .run = open_lessons,
         .why_disabled =
             [](const UiState& s) {
                 return unless(!s.get<LessonState>().folder.empty() || s.get<LessonState>().course,
                               "The lessons of Glint are not installed");
             }},
        {.name = "Save",
         .keys = {{Key::S, ctrl}},
         .menu = Menu::File,
         .run = [](UiState& s) { save(s); },
         .line_above = true},
        {.name = "Save as…",
         .keys = {{Key::S, ctrl, shift}},
         .menu = Menu::File,
         .run = [](UiState& s) { s.files.ask(FilePurpose::SaveScene, offered_name(s, ".json")); }},
        {.name = "Save picture…",
         .keys = {{Key::F12}},
         .menu = Menu::File,
         .run = [](UiState& s) { ask_for_picture(s, FilePurpose::SavePicture); },
         .why_disabled = unless_picture_can_be_written,
         .line_above = true,
         .words = "image screenshot png"},
        {.name = "Save picture here and copy its command",
         .keys = {{Key::F12, !ctrl, shift}},
         .menu = Menu::File,
         .run = save_with_command,
         .why_disabled = unless_picture_can_be_written},
        {.name = "Export picture…",
         .keys = {{Key::E, ctrl}},
         .menu = Menu::File,
         .run = [](UiState& s) { s.get<ExportState>().open = true; },
         .why_disabled = [](const UiState& s) { return unless_busy(bool(s.get<ExportState>().job)); },
         .words = "image png exr resolution"},
        {.name = "Copy picture",
         .keys = {{Key::C, ctrl, shift}},
         .menu = Menu::File,
         .run = begin_copy,
         .why_disabled = copy_disabled_reason,
         .words = "image clipboard screenshot"},
        {.name = "Copy as command",
         .keys = {{Key::K, ctrl, shift}},
         .menu = Menu::File,
         .run = copy_last_command,
         .why_disabled = [](const UiState& s) { return unless_drawn(s.rendered); },
         .id = CommandId::CopyCommand},
        {.name = "Quit",
         .keys = {{Key::Q, ctrl}},
         .menu = Menu::File,
         .run = [](UiState& s) { begin_pending(s, Pending::What::Quit); },
         .id = CommandId::Quit,
         .line_above = true,
         .words = "exit close"},
    };
}

}  // namespace glint
