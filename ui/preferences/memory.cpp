#include "ui/preferences/memory.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <utility>

#include "models/io/file.h"
#include "ui/document/recent_files.h"
#include "ui/preferences/folder_lock.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_between_copies = 5, seconds_of_rest = 1, seconds_between_asking = 0.02;
constexpr int most_asking = 50;  // times, of a window that ends
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

/// False when another window has the list just now.
bool note_recent(UiState& state) {
    Memory& memory = state.memory;
    const std::string& path = state.editor.document.path;
    if (path == memory.opened) return true;
    // Other windows write there too: their files stay in the list.
    const FolderLock lock(memory.folder);
    if (!lock.held()) return false;
    memory.opened = path;
    memory.recent = with_recent_file(read_recent_files(text_of(memory, "recent.json")), path);
    write(memory, "recent.json", recent_files_text(memory.recent));
    return true;
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

/// Once, until a copy could be written again.
void tell_failed_copy(UiState& state, const Problem& problem) {
    state.memory.copied.reset();  // the next one is tried in its time
    if (std::exchange(state.memory.copy_failed, true)) return;
    state.notifications.add(Tone::Warning,
                            fmt::format("No copy of the unsaved work can be kept: {}; save it to "
                                        "keep it over a crash",
                                        problem.text()));
}

/// The result of the copy that was being written, when it has come to its end. False while it has not.
bool take_copied(UiState& state) {
    Memory& memory = state.memory;
    if (!memory.copying.valid()) return true;
    if (memory.copying.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    const Result<std::monostate> written = memory.copying.get();
    if (const Problem* problem = problem_of(written))
        tell_failed_copy(state, *problem);
    else
        memory.copy_failed = false;
    return true;
}

/// Takes a name for this window's copy, if it has none yet. False when the folder cannot be written.
bool has_copy_name(Memory& memory) {
    if (!memory.copy) memory.copy = new_autosave(memory.folder);
    return memory.copy.has_value();
}

void write_copy(UiState& state) {
    Memory& memory = state.memory;
    memory.copied_at = ImGui::GetTime();
    if (!has_copy_name(memory))
        return tell_failed_copy(state, {memory.folder, "", "cannot be written", "a folder of your own"});
    memory.copied = state.editor.scene();
    // Writing waits for the disk: not here.
    memory.copying = std::async(std::launch::async, [document = state.editor.document, folder = memory.folder,
                                                     path = memory.copy->path()] {
        return write_file(path, autosave_text(document, folder));
    });
}

void note_copy(UiState& state) {
    Memory& memory = state.memory;
    if (!state.editor.unsaved()) return drop_copy(state);
    const bool ended = take_copied(state);
    if (memory.copied == state.editor.scene() || state.viewport.gesture != Gesture::None) return;
    const double rest = memory.copied_at + seconds_between_copies - ImGui::GetTime();
    if (rest > 0) return wish_frame_in(rest);
    if (!ended) return wish_frame_in(0.2);
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
    if (!note_recent(state)) wish_frame_in(seconds_between_asking);
    note_settings(state);
    note_copy(state);
}

void drop_copy(UiState& state) {
    Memory& memory = state.memory;
    if (!memory.copy) return;
    if (memory.copying.valid()) (void)memory.copying.get();
    std::error_code failed;
    fs::remove(memory.copy->path(), failed);
    memory.copy.reset();
    memory.copied.reset();
}

void end_memory(UiState& state) {
    Memory& memory = state.memory;
    if (memory.folder.empty()) return;
    drop_copy(state);
    for (int i = 0; i < most_asking && !note_recent(state); ++i)
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds_between_asking));
    if (!(memory.settings == memory.written)) write(memory, "window.json", settings_text(memory.settings));
}

bool keep_unsaved_work(UiState& state) {
    Memory& memory = state.memory;
    if (memory.folder.empty() || !state.editor.unsaved()) return false;
    if (memory.copying.valid()) memory.copying.wait();  // it writes the same file
    if (!has_copy_name(memory)) return false;
    const std::string text = autosave_text(state.editor.document, memory.folder);
    return problem_of(write_file(memory.copy->path(), text)) == nullptr;
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
