// glint shade: draws a scene with the user's own lighting equation in GLSL.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/io/file.h"
#include "renderer/image/image_file.h"
#include "shader/shader_process.h"

namespace glint {
namespace {

struct ShadeArguments {
    SceneArguments scene;
    std::string shader, out, buffers;
    std::optional<PictureSize> size;
    double timeout = 10;  // seconds
};

/// Throws the last problem; prints the others before it.
void require_drawn(const ShaderAnswer& answer, const std::string& file) {
    const std::vector<Problem> problems = problems_of(answer, file);
    if (problems.empty()) return;
    for (const Warnings warnings = warnings_of(answer, file); const std::string& warning : warnings)
        say_warning(warning);
    for (std::size_t i = 0; i + 1 < problems.size(); ++i) say("error", problems[i]);
    throw Failure{ExitStatus::Impossible, problems.back()};
}

void write_buffers(const ShadeArguments& arguments, PictureFormat format, ShaderPicture& drawn) {
    const PictureFormat linear = is_linear(format) ? format : PictureFormat::Pfm;
    Picture buffer{drawn.picture.size, {}, {}};
    for (auto& [name, numbers] : {std::pair{"sum", &drawn.picture.linear},
                                  {"position", &drawn.positions},
                                  {"normal", &drawn.normals}}) {
        if (numbers->empty()) continue;
        const std::string path =
            (std::filesystem::path(arguments.buffers) / (std::string(name) + extension_of(linear))).string();
        require_not_read(path, "--buffers");
        buffer.linear.swap(*numbers);
        (void)take(write_file(path, picture_bytes(buffer, linear, 1, {})));
        buffer.linear.swap(*numbers);
    }
}

Outcome shade(const ShadeArguments& arguments) {
    require_file(arguments.scene);
    require_given(arguments.shader, "--shader",
                  "a file with vec3 lit(vec3 p, vec3 n), such as lighting.glsl");
    require_given(arguments.out, "-o",
                  "a file to write, .png, .pfm or .exr, or - for a PNG on standard output");
    const PictureFormat format =
        takes_png(arguments.out) ? PictureFormat::Png : take(picture_format(arguments.out));
    require_writable(arguments.out);
    std::error_code ignored;
    if (!arguments.buffers.empty() && !std::filesystem::is_directory(arguments.buffers, ignored))
        throw wrong_usage("--buffers", arguments.buffers + " is not a directory", "an existing directory");
    const SceneDocument document = open_scene(arguments.scene);
    const std::string text = take(read_shader(arguments.shader));
    require_not_read(arguments.out);
    CornerCache cache;
    Result<ShaderScene> scene = shader_scene(document.scene, size_to_draw(arguments.size, document), cache);
    if (Problem* problem = std::get_if<Problem>(&scene)) problem->file = arguments.scene.file;
    const bool is_png = format == PictureFormat::Png && arguments.buffers.empty();
    ShaderAnswer answer =
        shade_in_process(take(std::move(scene)), text, is_png ? ShaderOutput::Displayed : ShaderOutput::All,
                         {arguments.timeout});
    require_drawn(answer, arguments.shader);
    Outcome outcome{{}, document.warnings, ExitStatus::Done};
    for (const std::string& warning : warnings_of(answer, arguments.shader))
        outcome.warnings.push_back(warning);
    if (!arguments.buffers.empty()) write_buffers(arguments, format, answer.picture);
    std::string bytes = picture_bytes(answer.picture.picture, format, document.scene.display.exposure, {});
    if (arguments.out == "-") {
        outcome.output = std::move(bytes);
    } else {
        outcome.path = arguments.out;
        outcome.bytes = std::move(bytes);
    }
    return outcome;
}

Run declare_shade(Options& options) {
    auto arguments = std::make_shared<ShadeArguments>();
    add_scene(options, arguments->scene);
    add_text(options, "--shader", "FILE.glsl",
             "the lighting equation in GLSL, as glint code --language glsl writes it (docs/shader.md)",
             arguments->shader);
    add_text(options, "-o", "OUT", "output file: .png, .pfm or .exr, or - for a PNG on standard output",
             arguments->out);
    add_size(options, arguments->size);
    add_timeout(options, arguments->timeout);
    add_text(
        options, "--buffers", "DIR",
        "also write sum, position and normal of each pixel to this directory, as EXR if OUT is an EXR, else "
        "as PFM",
        arguments->buffers);
    return [arguments] { return shade(*arguments); };
}

}  // namespace

Command shade_command() {
    return {"shade", "FILE --shader FILE.glsl -o OUT", "draw a scene with your own lighting equation in GLSL",
            "glint shade teapot.json --shader lighting.glsl -o mine.png", declare_shade};
}

}  // namespace glint
