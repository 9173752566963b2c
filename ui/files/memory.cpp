#include "ui/files/memory.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "models/file.h"
#include "ui/files/recent_files.h"
#include "ui/ui.h"
#include "ui/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_between_copies = 5, seconds_of_rest = 1;
constexpr std::size_t longest_memory = 1 << 16;

std::string file_in(const Memory& memory, const char* name) {
    return (fs::path(memory.folder) / name).string();
}

std::string text_of(const Memory& memory, const char* name) {
    const Result<std::string> text = read_file(file_in(memory, name), longest_memory);
    return problem_of(text) == nullptr ? std::get<std::string>(text) : "";
}

/// What cannot be remembered is not worth a word: nothing that the user made is lost.
void write(const Memory& memory, const char* name, const std::string& text) {
    (void)write_file(file_in(memory, name), text);
}

void note_recent(UiState& state) {
    Memory& memory = state.memory;
    const std::string& path = state.editor.document.path;
    if (path == memory.opened) return;
    memory.opened = path;
    // Other windows write there too: their files stay in the list.
    memory.recent = with_recent_file(read_recent_files(text_of(memory, "recent.json")), path);
    write(memory, "recent.json", recent_files_text(memory.recent));
}

void note_settings(UiState& state) {
    Memory& memory = state.memory;
    Settings now = memory.settings;
    now.dark = state.dark;
    now.layout = state.layout;
    now.views = views_to_remember(state);
    now.layout.folded = now.layout.bare = false;  // the picture alone is for a moment
    const double time = ImGui::GetTime();
    if (!(now == memory.settings)) memory.settings_changed = time;
    memory.settings = now;
    if (memory.settings == memory.written) return;
    const double rest = memory.settings_changed + seconds_of_rest - time;
    if (rest > 0) return wish_frame_in(rest);
    write(memory, "window.json", settings_text(memory.settings));
    memory.written = memory.settings;
}

void write_copy(UiState& state) {
    Memory& memory = state.memory;
    if (!memory.copy) memory.copy = new_autosave(memory.folder);
    memory.copied = state.editor.scene();
    memory.copied_at = ImGui::GetTime();
    if (!memory.copy) return;
    // Writing waits for the disk: not here.
    memory.copying = std::async(std::launch::async, [document = state.editor.document, folder = memory.folder,
                                                     path = memory.copy->path()] {
        (void)write_file(path, autosave_text(document, folder));
    });
}

void note_copy(UiState& state) {
    Memory& memory = state.memory;
    if (!state.editor.unsaved()) return drop_copy(state);
    if (memory.copied == state.editor.scene() || state.viewport.gesture != Gesture::None) return;
    const double rest = memory.copied_at + seconds_between_copies - ImGui::GetTime();
    if (rest > 0) return wish_frame_in(rest);
    const bool busy = memory.copying.valid() &&
                      memory.copying.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
    if (busy) return wish_frame_in(0.2);
    write_copy(state);
}

}  // namespace

std::string state_folder() {
    const char* given = std::getenv("XDG_STATE_HOME");
    if (given != nullptr && fs::path(given).is_absolute()) return (fs::path(given) / "glint").string();
    const char* home = std::getenv("HOME");
    if (home == nullptr || !fs::path(home).is_absolute()) return {};
    return (fs::path(home) / ".local" / "state" / "glint").string();
}

void begin_memory(UiState& state, const std::string& folder) {
    Memory& memory = state.memory;
    std::error_code failed;
    if (folder.empty() || (fs::create_directories(folder, failed), failed)) return;
    memory.folder = folder;
    memory.recent = read_recent_files(text_of(memory, "recent.json"));
    memory.settings = memory.written = read_settings(text_of(memory, "window.json"));
    state.dark = memory.settings.dark;
    state.layout = memory.settings.layout;
    state.views.scope.open = state.layout.scope;
    recall_views(state, memory.settings.views);
    memory.left = left_copies(folder);
}

void tend_memory(UiState& state) {
    if (state.memory.folder.empty()) return;
    note_recent(state);
    note_settings(state);
    note_copy(state);
}

void drop_copy(UiState& state) {
    Memory& memory = state.memory;
    if (!memory.copy) return;
    if (memory.copying.valid()) memory.copying.wait();
    std::error_code failed;
    fs::remove(memory.copy->path(), failed);
    memory.copy.reset();
    memory.copied = {};
}

void end_memory(UiState& state) {
    Memory& memory = state.memory;
    if (memory.folder.empty()) return;
    drop_copy(state);
    if (!(memory.settings == memory.written)) write(memory, "window.json", settings_text(memory.settings));
}

void reset_layout(UiState& state) {
    state.layout = {};
    state.dark = true;
    state.views.scope.open = false;
    ViewMemory first_day;
    first_day.kept = state.kept_views;
    recall_views(state, first_day);
    state.memory.settings.width = state.memory.settings.height = 0;
    state.memory.settings.maximized = false;
}

}  // namespace glint
