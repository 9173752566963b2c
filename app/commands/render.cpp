// glint render: draws one picture.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/options.h"
#include "models/io/file.h"
#include "renderer/answers/answers.h"
#include "renderer/debug_views/debug_view.h"
#include "renderer/image/image_file.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

struct RenderArguments {
    SceneArguments scene;
    std::optional<PictureSize> size;
    std::string out;
    std::string buffers;  // a directory
    std::optional<int> samples;
    bool stats = false;
    bool no_scene = false;
};

/// With this many pixels, twelve buffers take about 2 GiB.
constexpr int max_buffer_pixels = 4096 * 4096;

/// Returns the format given by the extension; PNG for "-", and for a device or pipe without an extension.
PictureFormat format_of(const std::string& out) {
    if (takes_png(out)) return PictureFormat::Png;
    const Result<PictureFormat> format = picture_format(out);
    if (const Problem* problem = problem_of(format))
        throw wrong_usage("-o", out + " " + problem->what, problem->expected + ", or - for standard output");
    return std::get<PictureFormat>(format);
}

/// Returns the format of the buffers that are written along with a picture in `format`.
PictureFormat buffer_format(PictureFormat format) {
    return format == PictureFormat::Exr ? PictureFormat::Exr : PictureFormat::Pfm;
}

/// Returns the path of the named buffer.
std::string buffer_path(const RenderArguments& arguments, const std::string& name) {
    const PictureFormat format = buffer_format(format_of(arguments.out));
    return (std::filesystem::path(arguments.buffers) / (name + extension_of(format))).string();
}

void require_possible(const RenderArguments& arguments) {
    if (arguments.stats && is_standard_output(arguments.out))
        throw wrong_usage("--stats", "standard output is used for the picture", "a file after -o");
    if (arguments.buffers.empty()) return;
    std::error_code ignored;
    if (!std::filesystem::is_directory(arguments.buffers, ignored))
        throw wrong_usage("--buffers", arguments.buffers + " is not a directory", "an existing directory");
}

void require_buffers_of(PictureSize size, int samples) {
    if (samples > 1)
        throw wrong_usage("--buffers", "a pixel with several samples may show several surfaces",
                          "--samples 1");
    if (size.width > max_buffer_pixels / size.height)
        throw wrong_usage("--buffers", "the picture is too large", "at most 16777216 pixels");
}

/// Rejects a buffer that would be written to the same file as the picture or another buffer, since one of the
/// two would be lost.
void require_apart(const RenderArguments& arguments, const Scene& scene) {
    if (arguments.buffers.empty()) return;
    const std::string picture = replaced_file(arguments.out);
    std::map<std::string, std::string> taken;  // the buffer written to each file
    for (const std::string& name : buffer_names(scene)) {
        const std::string path = buffer_path(arguments, name), replaced = replaced_file(path);
        if (replaced.empty()) continue;
        require_not_read(path, "--buffers");
        if (replaced == picture)
            throw wrong_usage("-o", arguments.out + " is also the file of the buffer " + name,
                              "a different name");
        const auto [first, is_new] = taken.emplace(replaced, path);
        if (!is_new)
            throw wrong_usage("--buffers", path + " is the same file as " + first->second,
                              "a directory in which each buffer has its own file");
    }
}

/// Rejects a picture that would overwrite a file that the scene uses. A picture that contains the scene may
/// overwrite the picture from which the scene was read.
void require_scene_kept(const RenderArguments& arguments, PictureFormat format) {
    const std::string& scene = arguments.scene.file;
    const bool carries = format == PictureFormat::Png && !arguments.no_scene;
    if (carries && lower_extension(scene) == ".png" && replaced_file(arguments.out) == replaced_file(scene))
        return;
    require_not_read(arguments.out);
}

void write_buffers(const RenderArguments& arguments, const Renderer& renderer, const Scene& scene,
                   PictureSize size) {
    const PictureFormat format = buffer_format(format_of(arguments.out));
    const std::vector<std::string> names = buffer_names(scene);
    Progress progress("buffer", names.size());
    std::size_t count = 0;
    visit_pixel_buffers(renderer, scene, size, names, [&](const PixelBuffer& buffer) {
        progress.at(++count);
        (void)take(
            write_file(buffer_path(arguments, buffer.name), picture_bytes(buffer.picture, format, 1, {})));
        return true;
    });
}

Outcome render(const RenderArguments& arguments) {
    require_file(arguments.scene);
    require_given(arguments.out, "-o",
                  "a file to write, .png, .pfm or .exr, or - for a PNG on standard output");
    const PictureFormat format = format_of(arguments.out);
    require_possible(arguments);
    require_writable(arguments.out);
    if (!arguments.buffers.empty()) require_writable(buffer_path(arguments, "sum"));
    const SceneDocument document = open_scene(arguments.scene);
    const PictureSize size = size_to_draw(arguments.size, document);
    const int samples = samples_to_draw(arguments.samples, document);
    if (!arguments.buffers.empty()) require_buffers_of(size, samples);
    require_scene_kept(arguments, format);
    require_apart(arguments, document.scene);
    Outcome outcome{{}, document.warnings, ExitStatus::Done};

    Renderer renderer(arguments.scene.threads);
    Progress progress("picture", 1);
    progress.show_paths(renderer);
    const Picture& picture = renderer.render(document.scene, size, is_linear(format), samples);
    outcome.warnings.insert(outcome.warnings.end(), renderer.warnings().begin(), renderer.warnings().end());
    std::string bytes = picture_bytes(
        picture, format, document.scene.display.exposure,
        arguments.no_scene ? "" : carried_scene_text(document.scene, document.mesh_dir, arguments.out));
    if (arguments.out == "-") {
        outcome.output = std::move(bytes);
    } else {
        outcome.path = arguments.out;
        outcome.bytes = std::move(bytes);
    }
    if (!arguments.buffers.empty()) write_buffers(arguments, renderer, document.scene, size);
    if (arguments.stats) outcome.output = json_text(stats_json(renderer, size));
    return outcome;
}

Run declare_render(Options& options) {
    auto arguments = std::make_shared<RenderArguments>();
    add_scene(options, arguments->scene);
    add_text(options, "-o", "OUT",
             "output file: .png (8 bit, contains its scene), .pfm or .exr (linear float), or - for a PNG on "
             "standard output",
             arguments->out);
    add_size(options, arguments->size);
    add_samples(options, arguments->samples);
    add_text(options, "--buffers", "DIR",
             "also write positions, normals, vectors and terms of each pixel to this directory, as EXR if "
             "OUT is an EXR, else as PFM",
             arguments->buffers);
    options.add_flag("--no-scene", arguments->no_scene,
                     "leave the scene, and with it the paths of its meshes, out of a PNG");
    options.add_flag("--stats", arguments->stats, "print counts and times as JSON");
    return [arguments] { return render(*arguments); };
}

}  // namespace

Command render_command() {
    return {"render", "FILE -o OUT", "render a picture of a scene",
            "glint render teapot.json -o teapot.png --size 640x480 --set /display/exposure=2",
            declare_render};
}

}  // namespace glint
