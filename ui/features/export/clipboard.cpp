#include "ui/features/export/clipboard.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>

#include "models/json/json.h"
#include "models/scene_file/scene_file.h"

extern char** environ;

namespace glint {
namespace {

namespace fs = std::filesystem;

bool is_set(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != 0;
}

/// An in-memory file with these bytes, positioned at its beginning; -1 if there is not enough memory.
int file_of(const std::string& bytes) {
    const int file = ::memfd_create("glint-picture", MFD_CLOEXEC);
    if (file < 0) return -1;
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t count = ::write(file, bytes.data() + at, bytes.size() - at);
        if (count <= 0) {
            ::close(file);
            return -1;
        }
        at += static_cast<std::size_t>(count);
    }
    ::lseek(file, 0, SEEK_SET);
    return file;
}

/// Whether `b` has all keys of `a`. A missing key means its default, which is unknown here.
bool has_keys_of(const Json& b, const Json& a) {
    return std::all_of(members_of(a).begin(), members_of(a).end(),
                       [&b](const auto& member) { return find_member(b, member.first) != nullptr; });
}

/// Appends " --set POINTER=JSON" for each of the smallest parts in which `b` differs from `a`.
void append_sets(std::string& command, const Json& a, const Json& b, const std::string& pointer) {
    if (a == b) return;
    // A mesh or a projection of a different kind has different keys, so it is set as one value.
    const bool members = a.is_object() && b.is_object() && has_keys_of(b, a);
    const bool items = !elements_of(b).empty() && elements_of(a).size() == elements_of(b).size() &&
                       elements_of(b)[0].is_object();
    if (members) {
        for (const auto& [name, value] : members_of(b))
            append_sets(command, find_member(a, name) != nullptr ? *find_member(a, name) : Json(), value,
                        fmt::format("{}/{}", pointer, name));
    } else if (items) {
        for (std::size_t i = 0; i < elements_of(b).size(); ++i)
            append_sets(command, elements_of(a)[i], elements_of(b)[i], fmt::format("{}/{}", pointer, i));
    } else {
        command += " --set " + shell_word(pointer + "=" + json_line(b));
    }
}

/// A file name, relative to the working directory if the file is below it, otherwise absolute.
std::string named_from_here(const std::string& path) {
    std::error_code failed;
    const fs::path whole = fs::absolute(path, failed);
    const std::string below = whole.lexically_normal().lexically_relative(fs::current_path(failed)).string();
    return failed || below.empty() || below.starts_with("..") ? whole.string() : below;
}

Scene with_absolute_meshes(Scene scene, const std::string& mesh_dir) {
    for (Object& object : scene.objects)
        if (auto* file = std::get_if<MeshFile>(&object.source)) {
            std::error_code failed;
            const fs::path whole = fs::weakly_canonical(path_from(mesh_dir, file->path), failed);
            if (!failed) file->path = whole.string();
        }
    return scene;
}

/// Whether $PATH contains the program.
bool is_installed(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (!folder.empty() && ::access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

/// The command line that copies a PNG from standard input to the clipboard: `wl-copy` under Wayland, `xclip`
/// under X11, if $PATH contains it. Empty if there is none.
std::vector<std::string> clipboard_command() {
    if (is_set("WAYLAND_DISPLAY") && is_installed("wl-copy")) return {"wl-copy", "--type", "image/png"};
    if (is_set("DISPLAY") && is_installed("xclip"))
        return {"xclip", "-selection", "clipboard", "-t", "image/png", "-i"};
    return {};
}

}  // namespace

std::string mp4_disabled_reason() { return is_installed("ffmpeg") ? "" : "MP4 needs the program ffmpeg"; }

int run_tool(const std::vector<std::string>& command, int input, const std::atomic<bool>* cancelled) {
    std::vector<char*> words;
    words.reserve(command.size() + 1);
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    // A clipboard tool keeps running to serve the contents; it must not keep our terminal or pipe open.
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int failed = ::posix_spawnp(&child, words[0], &files, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (failed != 0) return -1;
    int status = 0;
    pid_t ended = 0;
    while ((ended = ::waitpid(child, &status, cancelled != nullptr ? WNOHANG : 0)) == 0) {
        if (cancelled != nullptr && *cancelled) ::kill(child, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return ended == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string clipboard_disabled_reason() {
    if (!clipboard_command().empty()) return {};
    return is_set("WAYLAND_DISPLAY") ? "Needs wl-copy, from the package wl-clipboard"
                                     : "Needs the program xclip";
}

Result<std::monostate> copy_png(const std::string& bytes) {
    const std::vector<std::string> command = clipboard_command();
    if (command.empty()) return Problem{"", "", clipboard_disabled_reason(), ""};
    const int input = file_of(bytes);
    if (input < 0) return Problem{command[0], "", "there is not enough memory for the picture", ""};
    const int status = run_tool(command, input);
    ::close(input);
    if (status != 0) return Problem{command[0], "", "did not accept the picture", "a working clipboard tool"};
    return std::monostate{};
}

std::string shell_word(const std::string& text) {
    constexpr const char* safe = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,:=+@%-";
    if (!text.empty() && text.find_first_not_of(safe) == std::string::npos) return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

std::string file_word(const std::string& path) {
    return shell_word(path.starts_with('-') && path != "-" ? "./" + path : path);
}

namespace {

/// "glint VERB FILE --set … --size WxH": the beginning of a command for a picture of the shown scene at that
/// size.
std::string command_of_shown(const char* verb, const SceneDocument& document, const Scene& in_file,
                             PictureSize size) {
    std::error_code failed;
    const bool has_file =
        !document.path.empty() && document.path != "-" && fs::is_regular_file(document.path, failed);
    Scene base, shown;
    std::string command;
    if (has_file) {
        base = in_file;
        shown = with_mesh_paths_from(document.scene, document.mesh_dir, directory_of(document.path));
        command = fmt::format("glint {} {}", verb, file_word(named_from_here(document.path)));
        for (const Assignment& set : document.assignments)
            command += " --set " + shell_word(set.pointer + "=" + set.json);
    } else {
        shown = with_absolute_meshes(document.scene, document.mesh_dir);
        command = fmt::format(R"(echo '{{"glint": 1}}' | glint {} -)", verb);
    }
    // `about` is left out: it is text about a scene and is not drawn. Projections are compared as fitted(),
    // which is how the window shows and writes them.
    base.about = shown.about = {};
    shown.camera.projection = fitted(shown.camera.projection, {size.width, size.height, true});
    if (document.fitted_to) base.camera.projection = fitted(base.camera.projection, *document.fitted_to);
    append_sets(command, json_or_null(scene_text(base)), json_or_null(scene_text(shown)), "");
    return command + fmt::format(" --size {}x{}", size.width, size.height);
}

}  // namespace

std::string render_command_text(const SceneDocument& document, const Scene& in_file, PictureSize size,
                                int samples, const std::string& out) {
    std::string command = command_of_shown("render", document, in_file, size);
    if (samples > 1 || document.picture_samples > 1) command += fmt::format(" --samples {}", samples);
    return command + " -o " + file_word(out);
}

std::string profile_command_text(const SceneDocument& document, const Scene& in_file, PictureSize size,
                                 glm::ivec2 from, glm::ivec2 to) {
    return command_of_shown("profile", document, in_file, size) +
           fmt::format(" --from {},{} --to {},{}", from.x, from.y, to.x, to.y);
}

}  // namespace glint
