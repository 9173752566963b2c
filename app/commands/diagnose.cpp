// glint diagnose: what is wrong in a picture that another program drew of a scene.
#include "renderer/diagnose/diagnose.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/progress.h"
#include "models/io/file.h"
#include "models/memory_limit.h"
#include "renderer/diagnose/diagnosis_format.h"
#include "renderer/image/image_file.h"

namespace glint {
namespace {

enum class Format { Text, Json };

struct DiagnoseArguments {
    SceneArguments scene;
    std::string picture, out;
    bool pairs = false;
    Format format = Format::Text;
};

Picture read_picture(const std::string& path) {
    const Result<PictureFormat> format = picture_format(path);
    if (problem_of(format) != nullptr)
        throw Failure{ExitStatus::Impossible,
                      {path, "", "cannot be read", "a picture whose name ends in .png, .pfm or .exr"}};
    switch (std::get<PictureFormat>(format)) {
    case PictureFormat::Png:
        return take(read_png(path));
    case PictureFormat::Pfm:
        return take(read_pfm(path));
    case PictureFormat::Exr:
        return take(read_exr(path));
    }
    return {};  // not reached
}

void write_sheet(const DiagnoseArguments& arguments, const Font& font, const Diagnosis& found,
                 const Scene& scene, const Picture& wrong) {
    const PictureSize size = diagnosis_sheet_size(found, font);
    if (size.width > max_picture_side || size.height > max_picture_side)
        throw wrong_usage("-o", fmt::format("the sheet would be {}x{} pixels large", size.width, size.height),
                          fmt::format("at most {0}x{0}", max_picture_side));
    const MemoryShare share(memory_need(MemoryUse::Output, png_memory(size) + 2 * picture_memory(size)));
    const Picture sheet = diagnosis_sheet(found, scene, wrong, font, arguments.scene.threads);
    (void)take(write_file(arguments.out, png_bytes(sheet, {})));
}

Outcome diagnose(const DiagnoseArguments& arguments) {
    require_file(arguments.scene);
    require_given(arguments.picture, "PICTURE", "a picture of the scene that another program drew");
    std::optional<Font> font;
    if (!arguments.out.empty()) {
        require_png_file(arguments.out);
        font.emplace(take(Font::find()));
        require_writable(arguments.out);
    }
    const SceneDocument document = open_scene(arguments.scene);
    Picture picture = read_picture(arguments.picture);
    const MemoryShare share(memory_need(MemoryUse::Pixels, picture_memory(picture.size)));
    const Picture wrong = as_shown(std::move(picture), document.scene.display);
    DiagnosisOptions options{arguments.pairs, arguments.scene.threads, {}};
    std::optional<Progress> progress;
    options.progress = [&progress](std::size_t done, std::size_t all) {
        if (!progress) progress.emplace("pair", all);
        progress->at(done);
    };
    const Diagnosis found = glint::diagnose(document, wrong, options);
    progress.reset();
    if (font) write_sheet(arguments, *font, found, document.scene, wrong);
    return {arguments.format == Format::Json ? diagnosis_json(found, document.scene)
                                             : diagnosis_text(found, document.scene),
            document.warnings, ExitStatus::Done};
}

Run declare(Options& options) {
    auto arguments = std::make_shared<DiagnoseArguments>();
    add_scene(options, arguments->scene);
    add_text(options, "PICTURE", "", "a picture of it by any program, of any size (.png .pfm .exr)",
             arguments->picture);
    options.add_flag("--pairs", arguments->pairs, "also looks for two mistakes at once");
    options.add_value("--format", "FORMAT", "text, the default, or json",
                      [&format = arguments->format](const std::string& text) {
                          format = static_cast<Format>(read_word("--format", text, {"text", "json"}));
                      });
    add_text(options, "-o", "SHEET.png",
             "write a sheet: the picture, the right one, the likeliest mistake, the differences",
             arguments->out);
    return [arguments] { return diagnose(*arguments); };
}

}  // namespace

Command diagnose_command() {
    return {"diagnose", "FILE PICTURE", "names the mistake in a picture that another program drew",
            "glint diagnose teapot.json mine.png --pairs -o sheet.png", declare};
}

}  // namespace glint
