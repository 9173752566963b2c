#include "tests/support/program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "tests/places.h"

namespace glint {
namespace {

/// Quotes arbitrary text as a single shell word.
std::string quoted(const std::string& word) {
    std::string text(1, '\'');
    for (const char c : word) {
        if (c == '\'') text += "'\\'";
        text += c;
    }
    text += '\'';
    return text;
}

/// Runs the command without a display and waits; returns the status from wait(), or -1 if it could not start.
/// Standard output goes to the file `out`. If `in` or `err` is empty, the command shares that stream with the
/// tests.
int run(std::vector<std::string> words, const std::string& out, const std::string& in,
        const std::string& err) {
    std::vector<char*> arguments, environment;
    for (std::string& word : words) arguments.push_back(word.data());
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (const std::string_view name = *variable;
            !name.starts_with("DISPLAY=") && !name.starts_with("WAYLAND_DISPLAY="))
            environment.push_back(*variable);
    arguments.push_back(nullptr);
    environment.push_back(nullptr);
    constexpr int written = O_WRONLY | O_CREAT | O_TRUNC;
    constexpr mode_t mode = 0666;
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    if (!in.empty()) posix_spawn_file_actions_addopen(&files, 0, in.c_str(), O_RDONLY, mode);
    posix_spawn_file_actions_addopen(&files, 1, out.c_str(), written, mode);
    if (!err.empty()) posix_spawn_file_actions_addopen(&files, 2, err.c_str(), written, mode);
    pid_t child = 0;
    int status = -1;
    if (posix_spawn(&child, arguments[0], &files, nullptr, arguments.data(), environment.data()) == 0)
        ::waitpid(child, &status, 0);
    posix_spawn_file_actions_destroy(&files);
    return status;
}

/// A shell command whose status is the program's own, even if its output is piped.
std::string redirected(const std::vector<std::string>& words, const std::string& in, const std::string& err,
                       const std::string& redirect) {
    std::string command;
    for (const std::string& word : words) command.append(quoted(word)).append(" ");
    return fmt::format("set -o pipefail; {}2>{} <{} {}", command, quoted(err), quoted(in), redirect);
}

}  // namespace

Ended run_glint(const std::vector<std::string>& arguments, const std::string& input,
                const std::string& redirect, std::vector<std::string> words) {
    const TemporaryDirectory directory;
    const std::string in = directory.file("in", input), out = directory.path("out"),
                      err = directory.path("err");
    words.emplace_back(glint_program);
    words.insert(words.end(), arguments.begin(), arguments.end());
    const int status = redirect.empty()
                           ? run(words, out, in, err)
                           : run({"/bin/bash", "-c", redirected(words, in, err, redirect)}, out, {}, {});
    Ended ended;
    ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ended.out = bytes_of(out);
    ended.err = bytes_of(err);
    return ended;
}

TemporaryDirectory::TemporaryDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "glint-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryDirectory::file(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
}

std::vector<std::string> TemporaryDirectory::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
        names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::string bytes_of(const std::string& path) {
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
}

}  // namespace glint
