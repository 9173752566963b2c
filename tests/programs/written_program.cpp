#include "tests/programs/written_program.h"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <regex>
#include <stdexcept>

#include "programs/model_text.h"
#include "tests/support/program.h"

namespace glint::programs {
namespace {

/// The text after `word` in a comment in the first lines.
std::string line_after(const std::string& text, const std::string& word) {
    const std::size_t at = text.find(" " + word + ": ");
    if (at == text.npos) throw std::runtime_error("no line " + word);
    const std::size_t begin = at + word.size() + 3;
    return text.substr(begin, text.find('\n', begin) - begin);
}

void replace(std::string& text, const std::string& from, const std::string& to) {
    if (const std::size_t at = text.find(from); at != text.npos) text.replace(at, from.size(), to);
}

/// Whether the command succeeds in that folder; its output goes to `said`. Debian's own Python comes first
/// because it has numpy.
bool runs(const std::string& command, const TemporaryDirectory& folder, std::string& said) {
    const std::string line =
        fmt::format("cd '{}' && PATH=/usr/bin:$PATH && ( {} ) >../{}.log 2>&1", folder.path(), command,
                    folder.path().substr(folder.path().rfind('/') + 1));
    const bool ok = std::system(line.c_str()) == 0;
    said = bytes_of(folder.path() + ".log");
    std::remove((folder.path() + ".log").c_str());
    return ok;
}

/// Builds a program that resembles an earlier one, in a third of the time: the standard headers of C++
/// programs are compiled once, and gold is the linker, because the default linker reads all of LLVM behind
/// OSMesa each time. With ccache, earlier compilations are reused.
class QuickerBuild {
  public:
    /// A command that builds the program in `folder` faster than `build`, the build line in the program's
    /// comment. The first program of each kind is built by `build` itself, as a user would.
    std::string command(const std::string& text, const std::string& build, const TemporaryDirectory& folder) {
        const bool is_cpp = build.starts_with("g++ ");
        std::string headers;
        const std::regex standard("#include <[a-z]+(\\.h)?>\n");
        for (std::sregex_iterator i(text.begin(), text.end(), standard), end; i != end; ++i)
            headers += i->str();
        const auto [at, is_new] = known_.try_emplace(build + headers, known_.size());
        if (is_new) return build;
        // The build line of a Python program only checks for numpy.
        if (!is_cpp && !build.starts_with("gcc ")) return "true";
        const std::size_t output = build.find(" -o "), source = build.find(" main.c");
        const std::string compile = build.substr(0, output);
        std::string included;
        if (is_cpp)
            included = " -fpch-preprocess -include " + precompiled(headers, at->second, compile, folder);
        const std::size_t libraries = std::min(build.find(' ', source + 1), build.size());
        return kept + compile + included + " -c -o main.o" + build.substr(source, libraries - source) +
               " && " + compile + " -fuse-ld=gold" + build.substr(output, source - output) + " main.o" +
               build.substr(libraries);
    }

  private:
    /// Returns the name of the header in `folder` that has a precompiled form next to it. That form is made
    /// once, with the options of `compile`.
    std::string precompiled(const std::string& headers, std::size_t number, const std::string& compile,
                            const TemporaryDirectory& folder) {
        std::string name = "headers" + std::to_string(number) + ".h";
        if (!std::filesystem::exists(folder_.path(name + ".gch"))) {
            (void)folder_.file(name, headers);
            std::string said;
            if (!runs(kept + compile + " -x c++-header " + name + " -o " + name + ".gch", folder_, said))
                throw std::runtime_error(said);
        }
        for (const std::string& file : {name, name + ".gch"})
            std::filesystem::create_symlink(folder_.path(file), folder.path(file));
        return name;
    }

    // Differences that ccache must ignore to accept a precompiled header.
    static constexpr const char* kept = "CCACHE_SLOPPINESS=pch_defines,time_macros $(command -v ccache) ";
    TemporaryDirectory folder_;
    std::map<std::string, std::size_t> known_;
};

/// The bytes after a header of that many lines.
std::string behind_header(const std::string& bytes, int lines) {
    std::size_t at = 0;
    for (int i = 0; i < lines; ++i) at = bytes.find('\n', at) + 1;
    return bytes.substr(at);
}

void read_pictures(Drawn& drawn, const TemporaryDirectory& folder, PictureSize size) {
    const std::string ppm = behind_header(bytes_of(folder.path("picture.ppm")), 3);
    drawn.bytes.assign(ppm.begin(), ppm.end());
    if (drawn.bytes.size() != 3 * size.pixels())
        drawn.failure = "picture.ppm does not have the picture's size";
    const std::string pfm = bytes_of(folder.path("picture.pfm"));
    if (pfm.empty()) return;
    const std::string floats = behind_header(pfm, 3);
    drawn.linear.resize(floats.size() / sizeof(float));
    const std::size_t row = 3 * static_cast<std::size_t>(size.width);
    for (std::size_t y = 0; y * row < drawn.linear.size(); ++y)  // bottom row first
        std::memcpy(&drawn.linear[drawn.linear.size() - (y + 1) * row], &floats[y * row * sizeof(float)],
                    row * sizeof(float));
    if (drawn.linear.size() != 3 * size.pixels())
        drawn.failure = "picture.pfm does not have the picture's size";
}

}  // namespace

Drawn build_and_run(const ProgramOf& of, Language language) {
    const TemporaryDirectory folder;
    const auto program = std::get<Program>(write_program(of, language));
    const std::string& text = program.texts.front().text;
    Drawn drawn;
    for (const ProgramFile& file : program.texts) {
        (void)folder.file(file.name, file.text);
        drawn.text += file.text;
    }
    for (const ProgramMesh& mesh : program.meshes)
        (void)folder.file(mesh.name, mesh_text(mesh.object, of.scene.shading.mistakes));
    std::string build = line_after(text, "build offscreen");
    replace(build, "-O2", "-O1 -Wall -Wextra -Werror");
    static QuickerBuild quicker_build;
    if (!runs(quicker_build.command(text, build, folder), folder, drawn.failure) ||
        !runs(line_after(text, "run offscreen"), folder, drawn.failure)) {
        drawn.failure += " (failed: " + of.name + ")";
        return drawn;
    }
    drawn.failure.clear();
    read_pictures(drawn, folder, of.size);
    return drawn;
}

}  // namespace glint::programs
