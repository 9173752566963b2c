#include "ui/preferences/autosave.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <memory>
#include <utility>

#include "models/io/file.h"
#include "models/json/json.h"
#include "models/utf8.h"
#include "ui/document/editor.h"
#include "ui/preferences/persistence.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_copy = std::size_t{64} << 20;
constexpr int max_copies = 100;

std::string copy_path(const std::string& folder, int number) {
    return (fs::path(folder) / fmt::format("{}.autosave", number)).string();
}

std::string time_text(std::time_t when) {
    std::tm local{};
    ::localtime_r(&when, &local);
    char text[64];
    return {text, std::strftime(text, sizeof text, "%F %H:%M", &local)};
}

struct Copy {
    std::string path;  // path of the file whose scene was copied
    Json scene;
    FileStamp stamp;  // stamp of that file when it was read
};

std::optional<Copy> read_copy(const std::string& path) {
    const Result<std::string> text = read_file(path, longest_copy);
    if (problem_of(text) != nullptr) return {};
    const Json json = json_or_null(std::get<std::string>(text));
    const Json *of = find_member(json, "path"), *scene = find_member(json, "scene");
    if (of == nullptr || !of->is_string() || scene == nullptr || !scene->is_object()) return {};
    const Json* stamp = find_member(json, "file");
    const bool stamped = stamp != nullptr && stamp->is_string();
    return Copy{unescaped_bytes(of->get_ref<const std::string&>()), *scene,
                stamped ? stamp_of(stamp->get_ref<const std::string&>()).value_or(FileStamp{}) : FileStamp{}};
}

/// Locks the copy `path`, whether or not it exists. Returns nullopt if another process has locked it or the
/// folder is not writable.
std::optional<AutosaveLock> lock_autosave(const std::string& path) {
    const auto close = [](const int* file) {
        ::close(*file);
        delete file;
    };
    const std::string name = path + ".lock";  // never removed: removal would race with another process's lock
    const std::shared_ptr<const int> file(new int(::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)),
                                          close);
    if (*file < 0 || ::flock(*file, LOCK_EX | LOCK_NB) != 0) return {};
    return AutosaveLock{path, file};
}

}  // namespace

std::optional<AutosaveLock> new_autosave(const std::string& folder) {
    for (int number = 0; number < max_copies; ++number) {
        const std::string path = copy_path(folder, number);
        auto lock = lock_autosave(path);
        std::error_code failed;
        if (lock && !fs::exists(path, failed)) return lock;
    }
    return {};
}

std::string autosave_text(const SceneDocument& document, const std::string& folder) {
    std::error_code failed;
    const bool named = !document.path.empty() && document.path != "-";
    const std::string path = named ? fs::absolute(document.path, failed).string() : "";
    const Scene scene = with_mesh_paths_from(document.scene, document.mesh_dir, folder);
    return fmt::format("{{\"path\": {},\n\"file\": \"{}\",\n\"scene\": {}}}\n",
                       json_string(escaped_bytes(path)), stamp_text(document.stamp), scene_text(scene));
}

std::vector<OrphanedAutosave> orphaned_autosaves(const std::string& folder) {
    std::vector<std::pair<std::time_t, OrphanedAutosave>> found;
    for (int number = 0; number < max_copies; ++number) {
        const std::string path = copy_path(folder, number);
        struct stat status {};
        if (::stat(path.c_str(), &status) != 0) continue;
        auto lock = lock_autosave(path);
        if (!lock) continue;  // the copy's process is still running
        if (const auto copy = read_copy(path))
            found.emplace_back(status.st_mtime, OrphanedAutosave{*std::move(lock), file_title(copy->path),
                                                                 time_text(status.st_mtime)});
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<OrphanedAutosave> copies;
    copies.reserve(found.size());
    for (auto& [when, copy] : found) copies.push_back(std::move(copy));
    return copies;
}

Result<SceneDocument> open_autosave(const std::string& path) {
    const auto copy = read_copy(path);
    if (!copy) return Problem{path, "", "is not a copy of unsaved work", "a copy that Glint made"};
    Result<Scene> parsed = parse_scene(json_line(copy->scene), path);
    if (const Problem* problem = problem_of(parsed)) return *problem;
    SceneDocument document{std::get<Scene>(std::move(parsed)), copy->path, directory_of(path), {}};
    Result<Warnings> loaded = load_meshes(document.scene, path, document.mesh_dir);
    if (const Problem* problem = problem_of(loaded)) return *problem;
    document.warnings = std::get<Warnings>(std::move(loaded));
    if (document.path.empty()) return document;
    document.stamp = copy->stamp;
    const std::string home = directory_of(document.path);
    document.scene = with_mesh_paths_from(std::move(document.scene), document.mesh_dir, home);
    document.mesh_dir = home;
    return document;
}

// The copy of unsaved work: writing it, reporting that it cannot be written, and removing it.

namespace {

constexpr double seconds_between_copies = 5;

/// Locks a copy for this process if it has none, and creates the folder if it is missing. Returns a problem
/// if no copy is possible.
std::optional<Problem> why_no_autosave(Persistence& memory) {
    if (auto problem = why_no_folder(memory.folder)) return problem;
    if (!memory.autosave) memory.autosave = new_autosave(memory.folder);
    if (memory.autosave) return {};
    return Problem{memory.folder, "", "cannot be written", "a folder of your own"};
}

/// Starts writing the copy on a separate thread, since writing may wait for the disk.
void write_autosave(UiState& state) {
    Persistence& memory = state.persistence;
    memory.autosaved_at = ImGui::GetTime();
    redraw_within(seconds_between_copies);
    if (const auto problem = why_no_autosave(memory)) return tell_no_copy(state, *problem);
    SceneDocument document = document_as_made(state);
    memory.autosaved_scene = document.scene;
    const auto work = [document = std::move(document), folder = memory.folder,
                       path = memory.autosave->path](LoadProgress&) {
        return write_file_at_once(path, autosave_text(document, folder));
    };
    memory.autosave_writing = state.jobs.start<std::monostate>(memory.autosave->path, work);
}

/// Reports a failed write once the thread has ended.
void take_written_autosave(UiState& state) {
    Persistence& memory = state.persistence;
    if (!memory.autosave_writing || !memory.autosave_writing->done()) return;
    const Result<std::monostate> written = memory.autosave_writing->take();
    memory.autosave_writing.reset();
    if (const Problem* problem = problem_of(written)) return tell_no_copy(state, *problem);
    memory.autosave_failed = false;
}

}  // namespace

void tell_no_copy(UiState& state, const Problem& problem) {
    state.persistence.autosaved_scene.reset();  // so that the next frame tries again
    if (std::exchange(state.persistence.autosave_failed, true)) return;
    state.notifications.add(
        Tone::Error,
        fmt::format("The unsaved work cannot be backed up: {}; save it so that it is not lost in a crash",
                    problem.text()));
}

void poll_unsaved_work(UiState& state) {
    Persistence& memory = state.persistence;
    if (!state.editor.unsaved()) return drop_autosave(state);
    take_written_autosave(state);
    const Scene& scene = state.editor.scene();
    const bool copied =
        awaits_mesh(state) ? memory.has_copy_of(as_made(state, scene)) : memory.has_copy_of(scene);
    if (copied || state.viewport.gesture != Gesture::None) return;
    const double rest = memory.autosaved_at + seconds_between_copies - ImGui::GetTime();
    if (rest > 0) return redraw_within(rest);
    if (memory.autosave_writing) return redraw_within(0.2);
    write_autosave(state);
}

void drop_autosave(UiState& state) {
    Persistence& memory = state.persistence;
    if (!memory.autosave) return;
    if (memory.autosave_writing) std::exchange(memory.autosave_writing, nullptr)->wait();
    std::error_code failed;
    std::filesystem::remove(memory.autosave->path, failed);
    memory.autosaved_scene.reset();
    if (!failed) memory.autosave.reset();  // else the next frame tries again
}

void keep_orphan(UiState& state, const std::string& path) {
    Persistence& memory = state.persistence;
    const auto copy = std::find_if(memory.orphans.begin(), memory.orphans.end(),
                                   [&path](const OrphanedAutosave& o) { return o.lock.path == path; });
    if (copy == memory.orphans.end()) return;
    memory.autosaved_scene = state.editor.scene();
    memory.autosave = copy->lock;
    memory.orphans.erase(copy);
}

bool keep_unsaved_work(UiState& state) {
    Persistence& memory = state.persistence;
    if (memory.folder.empty() || !state.editor.unsaved()) return false;
    if (memory.autosave_writing)  // the thread writes to the same file
        std::exchange(memory.autosave_writing, nullptr)->wait();
    if (why_no_autosave(memory)) return false;
    const std::string text = autosave_text(document_as_made(state), memory.folder);
    return problem_of(write_file_at_once(memory.autosave->path, text)) == nullptr;
}

}  // namespace glint
