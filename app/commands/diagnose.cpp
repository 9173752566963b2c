// glint diagnose: finds the mistakes in another program's picture of a scene.
#include "diagnose/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/options.h"
#include "diagnose/diagnosis_format.h"
#include "diagnose/search/display_change.h"
#include "models/io/file.h"
#include "models/scene/mistakes.h"
#include "renderer/image/image_file.h"

namespace glint {
namespace {

enum class DiagnosisFormat { Text, Json, Csv, Html };

struct DiagnoseArguments {
    SceneArguments scene;
    std::vector<std::string> pictures;
    std::string out;
    bool pairs = false;
    std::vector<std::string> conventions;  // conventions that the other program uses
    std::vector<MistakeSet> apart;         // mistakes to distinguish, without a picture
    DiagnosisFormat format = DiagnosisFormat::Text;
};

std::string sheet_png(const DiagnoseArguments& arguments, const Font& font, const Diagnosis& found,
                      const Scene& scene, const Picture& wrong) {
    const PictureSize size = diagnosis_sheet_size(found, font);
    if (size.width > max_picture_side || size.height > max_picture_side)
        throw wrong_usage("-o", fmt::format("the sheet would be {}x{} pixels", size.width, size.height),
                          fmt::format("at most {0}x{0}", max_picture_side));
    const Picture sheet = diagnosis_sheet(found, scene, wrong, font, arguments.scene.threads);
    return png_bytes(sheet, {});
}

void require_one_picture_for_a_sheet(const DiagnoseArguments& arguments) {
    if (arguments.out.empty()) return;
    const bool many = arguments.pictures.size() > 1;
    if (arguments.format == DiagnosisFormat::Html && (many || lower_extension(arguments.out) != ".png"))
        throw wrong_usage("-o", "writes the .png sheet of one picture, but --format html prints a page",
                          "> PAGE.html in place of -o");
    if (many)
        throw wrong_usage("-o",
                          fmt::format("can write the sheet of only one picture, but {} are given",
                                      arguments.pictures.size()),
                          "one PICTURE, or --format html");
    require_png_file(arguments.out);
    require_writable(arguments.out);
}

DiagnosedPicture unreadable_picture(const std::string& path, const Problem& problem) {
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::NotReadable;
    diagnosis.why = with_expected(problem.what, problem.expected);
    return {path, std::move(diagnosis), {}, {}};
}

/// Returns the diagnoses of all pictures, in order; stores the sheet of a single picture if `-o` requests it.
std::vector<DiagnosedPicture> diagnose_all(const DiagnoseArguments& arguments, const SceneDocument& document,
                                           Outcome& outcome) {
    std::optional<Font> font;
    if (!arguments.out.empty()) font.emplace(take(Font::find()));
    const int threads = arguments.scene.threads;
    const bool many = arguments.pictures.size() > 1;
    std::optional<Progress> progress;
    if (many) progress.emplace("picture", arguments.pictures.size());
    DiagnosisOptions options{arguments.pairs, arguments.conventions, threads, {}};
    if (!many)
        options.progress = [&progress](std::size_t done, std::size_t all) {
            if (!progress) progress.emplace("explanation", all);
            progress->at(done);
        };
    std::vector<DiagnosedPicture> all;
    for (const std::string& path : arguments.pictures) {
        if (many) progress->at(all.size() + 1);
        Result<Picture> read = read_picture(path);
        if (const Problem* problem = problem_of(read); problem != nullptr && many) {
            all.push_back(unreadable_picture(path, *problem));
            outcome.warnings.push_back(problem->text());
            outcome.status = ExitStatus::Impossible;
            continue;
        }
        Picture picture = take(std::move(read));
        require_not_read(arguments.out);
        SceneDocument framed = document;
        Projection& projection = framed.scene.camera.projection;
        if (const auto size = fitted_size_in(path); size && !document.fitted_to)
            projection = fitted(projection, *size);
        const auto [wrong, undone] =
            as_arrived(as_shown(std::move(picture), framed.scene.display), framed.scene);
        Diagnosis found = glint::diagnose(framed, wrong, options);
        found.display.arrived = undone;
        outcome.path = arguments.out;
        if (font) outcome.bytes = sheet_png(arguments, *font, found, framed.scene, wrong);
        all.push_back(diagnosed_picture(path, std::move(found), framed.scene, wrong, threads));
    }
    return all;
}

std::string text_of(const DiagnosedPicture& p, const Scene& scene, bool pairs) {
    const bool may_be_two = !pairs && p.diagnosis.verdict == Verdict::NotInCatalogue;
    return diagnosis_text(p.diagnosis, scene) +
           (may_be_two ? "Use --pairs to look for two mistakes at once.\n" : "");
}

std::string formatted(const std::vector<DiagnosedPicture>& all, const DiagnoseArguments& arguments,
                      const SceneDocument& document) {
    const bool many = all.size() > 1;
    std::string text;
    switch (arguments.format) {
    case DiagnosisFormat::Text:
        for (const DiagnosedPicture& p : all)
            text += (many ? on_one_line(p.name) + "\n" : "") + text_of(p, document.scene, arguments.pairs) +
                    (many && &p != &all.back() ? "\n" : "");
        return text;
    case DiagnosisFormat::Json:
        return diagnoses_json(all, document.scene);
    case DiagnosisFormat::Csv:
        return diagnoses_csv(all);
    case DiagnosisFormat::Html:
        return diagnoses_html(all, document.path);
    }
    return text;  // not reached
}

/// Reads "a,b": the names of two to four mistakes in the catalogue.
std::vector<MistakeSet> read_mistakes(const std::string& option, const std::string& text) {
    constexpr std::size_t most = 4;
    std::vector<std::string> known;
    for (const MistakeName& m : mistake_names()) known.emplace_back(m.name);
    std::vector<MistakeSet> mistakes;
    std::istringstream names(text);
    for (std::string name; std::getline(names, name, ',');) {
        const MistakeSet mistake{read_word(option, name, known)};
        if (std::find(mistakes.begin(), mistakes.end(), mistake) != mistakes.end())
            throw wrong_usage(option, "names " + name + " twice", "each mistake once");
        mistakes.push_back(mistake);
    }
    if (mistakes.size() < 2 || mistakes.size() > most)
        throw wrong_usage(option, fmt::format("number of mistakes: {}", mistakes.size()),
                          "two to four, separated by commas");
    return mistakes;
}

/// Finds the change to the scene that distinguishes the mistakes.
Outcome tell_apart(const DiagnoseArguments& arguments) {
    constexpr PictureSize size{640, 480};
    if (!arguments.pictures.empty()) throw wrong_usage("--apart", "needs only a scene", "no PICTURE");
    if (arguments.format != DiagnosisFormat::Text && arguments.format != DiagnosisFormat::Json)
        throw wrong_usage("--apart", "is not available as a table", "--format text or json");
    if (!arguments.out.empty()) throw wrong_usage("-o", "--apart draws no sheet", "no -o");
    if (arguments.pairs) throw wrong_usage("--pairs", "cannot be combined with --apart", "no --pairs");
    const SceneDocument document = open_scene(arguments.scene);
    const auto found = find_experiment(document, size, arguments.apart, arguments.scene.threads);
    return {arguments.format == DiagnosisFormat::Json ? experiment_json(found) : experiment_text(found),
            document.warnings, ExitStatus::Done};
}

Outcome diagnose(const DiagnoseArguments& arguments) {
    require_file(arguments.scene);
    if (!arguments.apart.empty()) return tell_apart(arguments);
    require_given(arguments.pictures.empty() ? "" : arguments.pictures.front(), "PICTURE",
                  "a picture of the scene that another program drew");
    require_one_picture_for_a_sheet(arguments);
    const SceneDocument document = open_scene(arguments.scene);
    require_not_read(arguments.out);
    Outcome outcome{{}, document.warnings, ExitStatus::Done};
    outcome.output = formatted(diagnose_all(arguments, document, outcome), arguments, document);
    return outcome;
}

Run declare_diagnose(Options& options) {
    auto arguments = std::make_shared<DiagnoseArguments>();
    add_scene(options, arguments->scene);
    options.add_words(
        "PICTURE", "pictures of the scene by another program, of any size (.png, .pfm, .exr)",
        [&pictures = arguments->pictures](const std::string& text) { pictures.push_back(text); });
    options.add_flag("--pairs", arguments->pairs, "also look for two mistakes at once");
    options.add_value("--convention", "NAME", "a convention that the program uses; may be repeated",
                      [&declared = arguments->conventions](const std::string& text) {
                          std::vector<std::string> known;
                          for (const ConventionName& c : convention_names()) known.emplace_back(c.name);
                          declared.push_back(known[read_word("--convention", text, known)]);
                      });
    options.add_value(
        "--apart", "A,B",
        "without PICTURE: find the change to the scene that distinguishes these two to four mistakes",
        [&apart = arguments->apart](const std::string& text) { apart = read_mistakes("--apart", text); });
    options.add_value("--format", "FORMAT", "text (default), json, csv or html (a page with small pictures)",
                      [&format = arguments->format](const std::string& text) {
                          format = static_cast<DiagnosisFormat>(
                              read_word("--format", text, {"text", "json", "csv", "html"}));
                      });
    add_text(options, "-o", "SHEET.png",
             "write a sheet for one picture: the picture, the correct one, the likeliest mistake and the "
             "differences",
             arguments->out);
    return [arguments] { return diagnose(*arguments); };
}

}  // namespace

Command diagnose_command() {
    return {"diagnose", "FILE PICTURE...", "name the mistake in pictures by another program",
            "glint diagnose teapot.json mine.png --pairs -o sheet.png", declare_diagnose};
}

}  // namespace glint
