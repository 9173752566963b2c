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

}  // namespace glint
