#include "tests/support/program.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace glint {
namespace {

/// One word for the shell, whatever is in it.
std::string quoted(const std::string& word) {
    std::string text(1, '\'');
    for (const char c : word) {
        if (c == '\'') text += "'\\'";
        text += c;
    }
    text += '\'';
    return text;
}

}  // namespace

Ended run_glint(const std::vector<std::string>& arguments, const std::string& input,
                const std::string& redirect) {
    const TemporaryDirectory directory;
    std::string words = quoted(GLINT_PROGRAM);
    for (const std::string& argument : arguments) words.append(" ").append(quoted(argument));
    // The command's own status, even in front of a pipe.
    const std::string all = fmt::format("{{ env -u DISPLAY -u WAYLAND_DISPLAY {} 2>{} <{} {}; }} >{}", words,
                                        quoted(directory.path("err")), quoted(directory.file("in", input)),
                                        redirect, quoted(directory.path("out")));
    const int status = std::system(("bash -o pipefail -c " + quoted(all)).c_str());
    Ended ended;
    ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ended.out = bytes_of(directory.path("out"));
    ended.err = bytes_of(directory.path("err"));
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
