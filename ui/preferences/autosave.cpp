#include "ui/preferences/autosave.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <filesystem>
#include <memory>
#include <utility>

#include "models/io/file.h"
#include "models/io/utf8.h"
#include "models/json/json_value.h"
#include "ui/document/editor.h"

namespace glint {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_copy = std::size_t{64} << 20;
constexpr const char* ending = ".autosave";

constexpr const char* lock_ending = ".lock";
std::string lock_path(const std::string& path) { return path + lock_ending; }

std::string time_words(std::time_t when) {
    const std::time_t now = std::time(nullptr);
    std::tm then{}, today{};
    ::localtime_r(&when, &then);
    ::localtime_r(&now, &today);
    const bool same_year = then.tm_year == today.tm_year;
    const bool same_day = same_year && then.tm_yday == today.tm_yday;
    const char* const words = same_day ? "%H:%M" : same_year ? "%e %B, %H:%M" : "%e %B %Y, %H:%M";
    char text[64];
    return {text, std::strftime(text, sizeof text, words, &then)};
}

struct Copy {
    std::string path;  // of the file that it is a copy of
    JsonValue scene;
    FileStamp stamp;  // of that file when it was read
};

std::optional<Copy> read_copy(const std::string& path) {
    const Result<std::string> text = read_file(path, longest_copy);
    if (problem_of(text) != nullptr) return {};
    const JsonValue json = JsonValue::parse(std::get<std::string>(text)).value_or(JsonValue());
    const JsonValue *of = json.find("path"), *scene = json.find("scene");
    if (of == nullptr || !of->is_string() || scene == nullptr || !scene->is_object()) return {};
    const JsonValue* stamp = json.find("file");
    const bool stamped = stamp != nullptr && stamp->is_string();
    return Copy{unescaped_bytes(of->string()), *scene,
                stamped ? stamp_of(stamp->string()).value_or(FileStamp{}) : FileStamp{}};
}

/// Whether the file of this descriptor still has this name; nothing when that cannot be found out.
std::optional<bool> is_named(int descriptor, const std::string& path) {
    struct stat ours {
    }, named{};
    if (::stat(path.c_str(), &named) != 0) return errno == ENOENT ? std::optional(false) : std::nullopt;
    if (::fstat(descriptor, &ours) != 0) return {};
    return ours.st_ino == named.st_ino;
}

/// Takes the lock of an opened file; -1, and it is closed, when another holds it. Whoever held it may have
/// removed the file between our opening and our locking.
int locked(int descriptor, const std::string& path) {
    if (descriptor < 0) return -1;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_named(descriptor, path).value_or(false))
        return descriptor;
    ::close(descriptor);
    return -1;
}

}  // namespace

std::optional<AutosaveLock> AutosaveLock::take(const std::string& path) {
    std::optional<AutosaveLock> lock(AutosaveLock{path});  // from here on nothing asks for memory
    const int file = ::open(lock->lock_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    lock->descriptor_ = locked(file, lock->lock_);
    if (lock->descriptor_ < 0) return {};
    return lock;
}

std::optional<AutosaveLock> AutosaveLock::take_left(const std::string& path) {
    const std::string lock_file = lock_path(path);
    if (::faccessat(AT_FDCWD, directory_of(path).c_str(), W_OK, AT_EACCESS) == 0) return take(path);
    std::optional<AutosaveLock> lock(AutosaveLock{path});
    int file = ::open(lock_file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    const bool missing = file < 0 && errno == ENOENT;
    if (missing) file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    lock->descriptor_ = locked(file, missing ? path : lock_file);
    if (lock->descriptor_ < 0) return {};
    return lock;
}

bool AutosaveLock::stands() const { return is_named(descriptor_, lock_).value_or(true); }

AutosaveLock::AutosaveLock(const std::string& path) : path_(path), lock_(lock_path(path)) {}

AutosaveLock::AutosaveLock(AutosaveLock&& other) noexcept
    : path_(std::move(other.path_)),
      lock_(std::move(other.lock_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AutosaveLock& AutosaveLock::operator=(AutosaveLock&& other) noexcept {
    if (this == &other) return *this;
    release();
    path_ = std::move(other.path_);
    lock_ = std::move(other.lock_);
    descriptor_ = std::exchange(other.descriptor_, -1);
    return *this;
}

AutosaveLock::~AutosaveLock() { release(); }

void AutosaveLock::release() noexcept {
    if (descriptor_ < 0) return;
    ::unlink(lock_.c_str());  // before letting go: nobody else's can be in its place yet
    ::close(descriptor_);
    descriptor_ = -1;
}

std::optional<AutosaveLock> new_autosave(const std::string& folder) {
    for (int number = 0; number < 100; ++number) {
        const std::string path =
            (fs::path(folder) / fmt::format("{}-{}{}", ::getpid(), number, ending)).string();
        std::error_code failed;
        if (fs::exists(path, failed)) continue;  // left by an earlier process of this number
        if (auto lock = AutosaveLock::take(path)) return lock;
    }
    return {};
}

std::string autosave_text(const SceneDocument& document, const std::string& folder) {
    std::error_code failed;
    const bool named = !document.path.empty() && document.path != "-";
    const std::string path = named ? fs::absolute(document.path, failed).string() : "";
    const Scene scene = with_mesh_paths_from(document.scene, document.mesh_dir, folder);
    return fmt::format("{{\"path\": {},\n\"file\": \"{}\",\n\"scene\": {}}}\n",
                       JsonValue(escaped_bytes(path)).text(), stamp_text(document.stamp), scene_text(scene));
}

/// What a folder holds; nothing where it cannot be read. The library's own iterator ends the program where
/// there is no memory.
static std::vector<fs::path> entries_of(const std::string& folder) {
    const std::unique_ptr<DIR, int (*)(DIR*)> open(::opendir(folder.c_str()), ::closedir);
    std::vector<fs::path> entries;
    while (const dirent* entry = open ? ::readdir(open.get()) : nullptr)
        entries.push_back(fs::path(folder) / entry->d_name);
    return entries;
}

/// Removes, by taking it, a lock whose window was killed before it wrote its copy.
static void remove_left_lock(const fs::path& path) {
    std::error_code failed;
    fs::path copy = path;
    copy.replace_extension();
    const bool is_lock = path.extension() == lock_ending && copy.extension() == ending;
    if (is_lock && !fs::exists(copy, failed) && !failed) (void)AutosaveLock::take(copy.string());
}

std::vector<OrphanedAutosave> orphaned_autosaves(const std::string& folder) {
    std::vector<std::pair<std::time_t, OrphanedAutosave>> found;
    std::error_code failed;
    for (const fs::path& entry : entries_of(folder)) {
        const std::string path = entry.string();
        remove_left_lock(entry);
        if (entry.extension() != ending || fs::is_symlink(entry, failed)) continue;
        auto lock = AutosaveLock::take_left(path);
        if (!lock) continue;  // its window lives
        struct stat status {};
        if (::stat(path.c_str(), &status) != 0) continue;
        const auto copy = read_copy(path);
        if (!copy) continue;
        found.emplace_back(status.st_mtime, OrphanedAutosave{std::move(*lock), file_title(copy->path),
                                                             time_words(status.st_mtime)});
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<OrphanedAutosave> copies;
    copies.reserve(found.size());
    for (auto& [when, copy] : found) copies.push_back(std::move(copy));
    return copies;
}

Result<SceneDocument> open_autosave(const std::string& path) {
    const auto copy = read_copy(path);
    if (!copy) return Problem{path, "", "is not a copy of a scene", "one that Glint kept"};
    Result<Scene> parsed = parse_scene(copy->scene.text(), path);
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
