// glint code: a program that draws the scene, for people who learn to write one.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/fields/choices.h"
#include "models/io/file.h"
#include "models/io/left_files.h"
#include "models/io/temporary.h"
#include "renderer/programs/mesh_text.h"
#include "renderer/programs/program.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

struct CodeArguments {
    SceneArguments scene;
    PictureSize size;
    std::optional<Language> language;
    std::string out;  // a directory
};

/// A directory for the program's files alone: new, or empty until now.
struct OutDirectory {
    std::unique_ptr<NewDirectory> made;  // null: it was there
    std::unique_ptr<FolderLock> lock;
};

/// Creates the directory unless it is there. Throws Failure if the path is anything but a new or an empty
/// directory, or another process is writing a program there.
OutDirectory out_directory(const std::string& path) {
    const auto refused = [&path](const std::string& what) {
        return Failure{ExitStatus::Impossible, {path, "", what, "a new or an empty directory"}};
    };
    OutDirectory out;
    std::error_code error;
    const fs::file_status found = fs::status(path, error);
    if (fs::exists(found)) {
        if (!fs::is_directory(found)) throw refused("is not a directory");
    } else {
        out.made = std::make_unique<NewDirectory>(path);
        if (out.made->error() != 0) throw refused("cannot be made: " + reason(out.made->error()));
    }
    out.lock = std::make_unique<FolderLock>(path);
    if (!out.lock->held()) throw refused("is being written by another process");
    remove_left_files((fs::path(path) / "").string());
    if (!fs::is_empty(path, error) || error) throw refused(error ? reason(error.value()) : "is not empty");
    return out;
}

/// The scene's name for the first line of the program.
std::string name_of_scene(const std::string& file) {
    return file == "-" ? "scene" : fs::path(file).filename().string();
}

Outcome code(const CodeArguments& arguments) {
    require_file(arguments.scene);
    if (!arguments.language)
        throw wrong_usage("--language", "is missing",
                          fmt::format("{}", fmt::join(names_of<Language>(), ", ")));
    require_given(arguments.out, "-o", "a new or an empty directory");
    const OutDirectory out = out_directory(arguments.out);
    const SceneDocument document = open_scene(arguments.scene);
    Result<Program> written = write_program(
        {document.scene, arguments.size, name_of_scene(arguments.scene.file)}, *arguments.language);
    if (auto* problem = std::get_if<Problem>(&written)) problem->file = arguments.scene.file;
    const Program program = take(std::move(written));
    FilesTogether together;
    const auto add = [&](const std::string& name, std::string text) {
        (void)take(together.add((fs::path(arguments.out) / name).string(), std::move(text)));
    };
    for (const ProgramFile& file : program.texts) add(file.name, file.text);
    for (const ProgramMesh& mesh : program.meshes) {  // one at a time: they are long
        MemoryShare share;
        add(mesh.name, mesh_text(mesh.object, document.scene.shading.mistakes, share));
    }
    (void)take(together.put_in_place());
    if (out.made) out.made->keep();
    return {{}, document.warnings, ExitStatus::Done};
}

Run declare_code(Options& options) {
    auto arguments = std::make_shared<CodeArguments>();
    add_scene(options, arguments->scene);
    options.add_value("--language", "LANGUAGE", "gl1, glsl, cpp or python",
                      [&language = arguments->language](const std::string& text) {
                          language =
                              static_cast<Language>(read_word("--language", text, names_of<Language>()));
                      });
    add_size(options, arguments->size);
    add_text(options, "-o", "DIR", "the directory for its files, new or empty", arguments->out);
    return [arguments] { return code(*arguments); };
}

}  // namespace

Command code_command() {
    return {"code", "FILE --language LANGUAGE -o DIR", "writes a program that draws the scene",
            "glint code teapot.json --language cpp -o teapot", declare_code};
}

}  // namespace glint
