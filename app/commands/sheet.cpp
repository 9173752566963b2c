// glint sheet: draws a labelled grid of pictures over two parameters.
#include "renderer/image/sheet.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/options.h"
#include "models/io/file.h"
#include "models/json/json.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

struct SheetArguments {
    SceneArguments scene;
    std::string rows, columns, out;
    PictureSize cell{256, 256};
    std::optional<int> samples;
};

SheetAxis axis_of(const std::string& option, const std::string& text) {
    require_given(text, option, "POINTER=A,B,C, such as /objects/0/material/shininess=8,32,128");
    Result<SheetAxis> axis = parse_axis(option, text);
    if (const Problem* problem = problem_of(axis)) throw Failure{ExitStatus::WrongUsage, *problem};
    return std::get<SheetAxis>(std::move(axis));
}

/// Whether setting `outer` overwrites an earlier value at `inner`.
bool overwrites(const std::string& outer, const std::string& inner) { return is_within(inner, outer); }

/// Throws if the columns overwrite the rows' parameter: a column's value is set after its row's, so the row's
/// label would be wrong.
void require_two_parameters(const SheetAxis& rows, const SheetAxis& columns) {
    if (overwrites(columns.pointer, rows.pointer))
        throw Failure{ExitStatus::WrongUsage,
                      {"--cols", columns.pointer, "it overwrites what --rows sets", "a different parameter"}};
}

/// Returns the option with the invalid value: --rows if the same pointer is invalid even without the columns.
std::string axis_at_fault(const Problem& problem, const SceneVariants& variants, const Assignment& row) {
    const Result<Scene> without_columns = variants.with({row});
    const Problem* of_row = problem_of(without_columns);
    return of_row != nullptr && of_row->pointer == problem.pointer ? "--rows" : "--cols";
}

/// Returns the scene of one cell. A problem with a value names the option that contains the value.
Scene scene_of_cell(const SceneVariants& variants, const SheetAxis& rows, const std::string& row,
                    const SheetAxis& columns, const std::string& column) {
    const Assignment of_row{rows.pointer, row};
    Result<Scene> made = variants.with({of_row, {columns.pointer, column}});
    if (const Problem* found = problem_of(made)) {
        Problem problem = *found;
        if (problem.file != "--set") throw Failure{ExitStatus::Impossible, problem};
        problem.file = axis_at_fault(problem, variants, of_row);
        throw Failure{ExitStatus::WrongUsage, problem};
    }
    return std::get<Scene>(std::move(made));
}

void require_fitting(const SheetAxis& rows, const SheetAxis& columns, PictureSize cell, const Font& font) {
    const std::size_t cells = rows.values.size() * columns.values.size();
    if (cells > max_sheet_cells)
        throw wrong_usage("--cols", fmt::format("the sheet would have {} pictures", cells),
                          fmt::format("at most {}", max_sheet_cells));
    const PictureSize size = sheet_size(rows, columns, cell, font);
    if (size.width > max_picture_side || size.height > max_picture_side)
        throw wrong_usage("--cell", fmt::format("the sheet would be {}x{} pixels", size.width, size.height),
                          fmt::format("at most {0}x{0}", max_picture_side));
}

Outcome sheet(const SheetArguments& arguments) {
    require_file(arguments.scene);
    const SheetAxis rows = axis_of("--rows", arguments.rows);
    const SheetAxis columns = axis_of("--cols", arguments.columns);
    require_two_parameters(rows, columns);
    require_given(arguments.out, "-o", "a file to write, .png, or - for standard output");
    if (!takes_png(arguments.out))
        throw wrong_usage("-o", arguments.out + " cannot be written",
                          "a name that ends in .png, or - for standard output");
    const Font font = take(Font::find());
    require_fitting(rows, columns, arguments.cell, font);
    require_writable(arguments.out);
    const SceneDocument document = open_scene(arguments.scene);
    require_not_read(arguments.out);
    Outcome outcome{{}, document.warnings, ExitStatus::Done};

    Renderer renderer(arguments.scene.threads);
    const SceneVariants variants(document);
    const int samples = samples_to_draw(arguments.samples, document);
    Progress progress("picture", rows.values.size() * columns.values.size());
    progress.show_paths(renderer);
    const Picture picture =
        make_sheet(rows, columns, arguments.cell, font, [&](std::size_t r, std::size_t c) -> const Picture& {
            progress.at(r * columns.values.size() + c + 1);
            return renderer.render(scene_of_cell(variants, rows, rows.values[r], columns, columns.values[c]),
                                   arguments.cell, false, samples);
        });
    std::string bytes = png_bytes(picture, {});
    if (arguments.out == "-") {
        outcome.output = std::move(bytes);
    } else {
        (void)take(write_file(arguments.out, bytes));
    }
    return outcome;
}

Run declare_sheet(Options& options) {
    auto arguments = std::make_shared<SheetArguments>();
    add_scene(options, arguments->scene);
    const std::string values =
        "=A,B,C, each value as in --set; commas inside [], {} and \"\" do not separate values";
    add_text(options, "--rows", "POINTER=A,B,C", "the values of the rows: POINTER" + values, arguments->rows);
    add_text(options, "--cols", "POINTER=A,B,C", "the values of the columns, in the same form",
             arguments->columns);
    add_text(options, "-o", "OUT.png", "output file; - is standard output", arguments->out);
    options.add_value(
        "--cell", "WxH", "size of each picture in pixels; default 256x256",
        [&cell = arguments->cell](const std::string& text) { cell = read_size("--cell", text); });
    add_samples(options, arguments->samples);
    return [arguments] { return sheet(*arguments); };
}

}  // namespace

Command sheet_command() {
    return {"sheet", "FILE --rows P=A,B --cols P=A,B -o OUT.png",
            "render a labelled grid of pictures over two parameters",
            "glint sheet sun.json --rows /shading/mode=flat,gouraud,phong "
            "--cols /objects/0/material/shininess=8,32,128 -o sheet.png",
            declare_sheet};
}

}  // namespace glint
