// glint code: writes a program that draws the scene, for people learning to write one.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/fields/choices.h"
#include "models/io/file.h"
#include "programs/model_text.h"
#include "programs/program.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

struct CodeArguments {
    SceneArguments scene;
    std::optional<PictureSize> size;
    std::optional<Language> language;
    std::string out;  // a directory
    bool blank = false;
};

/// A directory that contains only the program's files. Removes a new directory if nothing is written to it.
class OutDirectory {
  public:
    /// Throws Failure unless the path is a new or an empty directory.
    explicit OutDirectory(const std::string& path) : path_(path) {
        std::error_code error;
        const fs::file_status found = fs::status(path, error);
        if (fs::exists(found) && !fs::is_directory(found)) refuse("is not a directory");
        is_new_ = fs::create_directory(path, error);
        if (error) refuse("cannot be created: " + reason(error.value()));
        if (!fs::is_empty(path, error) || error) refuse(error ? reason(error.value()) : "is not empty");
    }
    ~OutDirectory() {
        std::error_code not_empty;
        if (is_new_) fs::remove(path_, not_empty);
    }
    OutDirectory(const OutDirectory&) = delete;
    OutDirectory& operator=(const OutDirectory&) = delete;

    void write(const std::string& name, const std::string& text) const {
        (void)take(write_file((fs::path(path_) / name).string(), text));
    }

  private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw Failure{ExitStatus::Impossible, {path_, "", what, "a new or an empty directory"}};
    }

    std::string path_;
    bool is_new_ = false;
};

/// Returns the scene's name for the first line of the program.
std::string name_of_scene(const std::string& file) {
    return file == "-" ? "scene" : fs::path(file).filename().string();
}

Outcome code(const CodeArguments& arguments) {
    require_file(arguments.scene);
    if (!arguments.language)
        throw wrong_usage("--language", "is missing",
                          fmt::format("{}", fmt::join(names_of<Language>(), ", ")));
    if (arguments.blank && *arguments.language != Language::Glsl && *arguments.language != Language::Webgl)
        throw wrong_usage("--blank", "applies only to shaders", "--language glsl or webgl");
    require_given(arguments.out, "-o", "a new or an empty directory");
    const OutDirectory out(arguments.out);
    const SceneDocument document = open_scene(arguments.scene);
    Result<Program> written = write_program({document.scene, size_to_draw(arguments.size, document),
                                             name_of_scene(arguments.scene.file), arguments.blank},
                                            *arguments.language);
    if (auto* problem = std::get_if<Problem>(&written)) problem->file = arguments.scene.file;
    const Program program = take(std::move(written));
    for (const ProgramFile& file : program.texts) out.write(file.name, file.text);
    for (const ProgramMesh& mesh : program.meshes)  // one at a time, because each is large
        out.write(mesh.name, mesh_text(mesh.object, document.scene.shading.mistakes));
    return {{}, document.warnings, ExitStatus::Done};
}

Run declare_code(Options& options) {
    auto arguments = std::make_shared<CodeArguments>();
    add_scene(options, arguments->scene);
    options.add_value("--language", "LANGUAGE", "gl1, glsl, cpp, python or webgl",
                      [&language = arguments->language](const std::string& text) {
                          language =
                              static_cast<Language>(read_word("--language", text, names_of<Language>()));
                      });
    add_size(options, arguments->size);
    add_text(options, "-o", "DIR", "the directory to write to, new or empty", arguments->out);
    options.add_flag("--blank", arguments->blank,
                     "leave the functions of lighting.glsl empty, with a comment for each step to write");
    return [arguments] { return code(*arguments); };
}

}  // namespace

Command code_command() {
    return {"code", "FILE --language LANGUAGE -o DIR", "write a program that draws the scene",
            "glint code teapot.json --language cpp -o teapot", declare_code};
}

}  // namespace glint
