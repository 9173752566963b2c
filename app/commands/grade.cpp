// glint grade: judges the shaders and pictures of a class, each in a process of its own.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/grade_report.h"
#include "app/options.h"
#include "diagnose/diagnosis_format.h"
#include "diagnose/search/display_change.h"
#include "models/io/file.h"
#include "models/memory_limit.h"
#include "renderer/image/image_file.h"
#include "shader/shader_process.h"

namespace glint {
namespace {

enum class GradeFormat { Text, Json, Csv, Html, Junit };
constexpr PictureSize default_size{640, 480};

struct GradeArguments {
    SceneArguments scene;
    std::vector<std::string> files;
    PictureSize size = default_size;  // of shaders
    double timeout = 10;              // seconds, of each shader
    std::string rubric, out = "-";
    GradeFormat format = GradeFormat::Text;
};

// One file, graded in a process of its own.

/// The name and numbers of the first explanation, from the public JSON of a diagnosis.
void add_diagnosis(GradeRow& row, const DiagnosedPicture& diagnosed, const Scene& scene) {
    const Json found = json_or_null(diagnoses_json({diagnosed}, scene));
    row["verdict"] = found["verdict"];
    std::string text = diagnosis_text(diagnosed.diagnosis, scene);
    std::size_t end = text.find('\n');
    if (text.compare(end + 1, 7, "Look in") == 0) {
        text[end] = ' ';
        end = text.find('\n', end);
    }
    row["text"] = text.substr(0, end);
    row["size"] = {found["width"], found["height"]};
    row["picture_html"] = html_image(diagnosed.thumbnail, "as submitted");
    const Json* const candidates = find_member(found, "candidates");
    if (!is_explained(diagnosed.diagnosis.verdict) || candidates == nullptr || candidates->empty()) return;
    const Json& first = (*candidates)[0];
    row["mistake"] = first["name"];
    for (const char* key : {"also", "pixel", "mine", "reference"}) row[key] = first[key];
}

/// Judges a picture. Only this function depends on the diagnosis.
void judge_picture(GradeRow& row, const SceneDocument& document, Picture picture, int threads) {
    const auto [shown, undone] = as_arrived(as_shown(std::move(picture), document.scene.display));
    Diagnosis diagnosis = glint::diagnose(document, shown, {.threads = threads});
    diagnosis.display.arrived = undone;
    const DiagnosedPicture diagnosed =
        diagnosed_picture("", std::move(diagnosis), document.scene, shown, threads);
    add_diagnosis(row, diagnosed, document.scene);
    Scene right = document.scene;
    right.shading.mistakes = {};
    Renderer renderer(threads);
    row["reference_html"] = html_image(renderer.render(right, diagnosed.thumbnail.size), "right");
}

/// Draws the scene with a shader; nothing if that is impossible, and then the row says why.
std::optional<Picture> drawn_by(const std::string& file, GradeRow& row, const SceneDocument& document,
                                const GradeArguments& arguments) {
    CornerCache cache;
    Result<ShaderScene> scene = shader_scene(document.scene, arguments.size, cache);
    if (Problem* problem = std::get_if<Problem>(&scene)) problem->file = arguments.scene.file;
    const std::string text = take(read_shader(file));
    ShaderAnswer answer =
        shade_in_process(take(std::move(scene)), text, ShaderOutput::Displayed, {arguments.timeout});
    Json& messages = row["messages"];
    for (const Problem& problem : problems_of(answer, file)) messages.push_back(problem.text());
    for (const std::string& warning : warnings_of(answer, file)) messages.push_back(warning);
    using End = ShaderAnswer::End;
    if (answer.end == End::NotCompiled) row["verdict"] = does_not_compile;
    if (answer.end == End::NeverEnds || answer.end == End::TimedOut) row["verdict"] = does_not_end;
    if (answer.end != End::Drawn) return {};
    row["not_finite"] = answer.picture.not_finite.count;
    row["discarded"] = answer.picture.discarded.count;
    return std::move(answer.picture.picture);
}

/// Whether the name is that of a picture. Pictures that cannot be read count too, so that reading one names
/// the formats that can.
bool is_picture(const std::string& file) {
    constexpr std::array others{".jpg",  ".jpeg", ".gif", ".bmp", ".tif",
                                ".tiff", ".tga",  ".ppm", ".hdr", ".webp"};
    return problem_of(picture_format(file)) == nullptr ||
           std::find(others.begin(), others.end(), lower_extension(file)) != others.end();
}

GradeRow judged(const std::string& file, const GradeArguments& arguments) {
    GradeRow row{{"file", file}, {"verdict", not_judged}, {"messages", Json::array()}};
    try {
        const SceneDocument document = open_scene(arguments.scene);
        std::optional<Picture> picture;
        if (is_picture(file))
            picture = take(read_picture(file));
        else
            picture = drawn_by(file, row, document, arguments);
        if (picture) judge_picture(row, document, std::move(*picture), arguments.scene.threads);
    } catch (const Failure& failure) {
        row["messages"].push_back(failure.problem.text());
    }
    return row;
}

// All files, here.

/// The words for grade_worker(): everything that judged() needs.
std::vector<std::string> worker_words(const std::string& file, const GradeArguments& arguments, int threads) {
    std::vector<std::string> words{arguments.scene.file,
                                   file,
                                   fmt::format("{}x{}", arguments.size.width, arguments.size.height),
                                   fmt::format("{}", arguments.timeout),
                                   fmt::format("{}", threads),
                                   fmt::format("{}", memory_limit())};
    for (const Assignment& a : arguments.scene.assignments) words.push_back(a.pointer + "=" + a.json);
    return words;
}

GradeRow row_of(const std::string& file, const ChildEnd& end, const ChildLimits& limits) {
    if (end.succeeded())
        if (GradeRow row = json_or_null(end.output); row.is_object()) return row;
    std::string why = fmt::format("the process that judged it ended (status {})", end.status);
    if (end.how == ChildEnd::How::TimedOut)
        why = fmt::format("judging it took more than {:g} s", limits.seconds);
    if (end.how == ChildEnd::How::NotStarted)
        why = "the process that judges did not start: " + reason(end.status);
    return {{"file", file}, {"verdict", not_judged}, {"messages", Json::array({file + ": " + why})}};
}

/// Judges all files, as many at once as there are threads.
std::vector<GradeRow> judge_all(const GradeArguments& arguments, const std::string& input) {
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t threads = arguments.scene.threads > 0 ? std::size_t(arguments.scene.threads) : cores;
    const std::size_t processes = std::clamp<std::size_t>(arguments.files.size(), 1, threads);
    constexpr double seconds_to_judge = 300;
    // Of the address space, much of which is never used.
    const ChildLimits limits{seconds_to_judge + arguments.timeout, memory_limit() + shader_memory};
    std::vector<GradeRow> rows(arguments.files.size());
    std::atomic<std::size_t> next = 0;
    std::mutex showing;
    Progress progress("file", rows.size());
    const auto work = [&] {
        for (std::size_t i = next++; i < rows.size(); i = next++) {
            {
                const std::lock_guard lock(showing);
                progress.at(i + 1);
            }
            const std::string& file = arguments.files[i];
            rows[i] = row_of(file,
                             run_child(grade_worker_name,
                                       worker_words(file, arguments, static_cast<int>(threads / processes)),
                                       input, limits),
                             limits);
        }
    };
    std::vector<std::jthread> pool(processes);
    for (std::jthread& thread : pool) thread = std::jthread(work);
    pool.clear();
    return rows;
}

std::string formatted(const std::vector<GradeRow>& rows, const GradeArguments& arguments) {
    const std::string title = std::filesystem::path(arguments.scene.file).filename().string();
    switch (arguments.format) {
    case GradeFormat::Text:
        return grades_text(rows);
    case GradeFormat::Json:
        return grades_json(rows);
    case GradeFormat::Csv:
        return grades_csv(rows);
    case GradeFormat::Html:
        return grades_html(rows, title);
    case GradeFormat::Junit:
        return grades_junit(rows, title);
    }
    return {};  // not reached
}

Outcome grade(const GradeArguments& arguments) {
    constexpr std::size_t max_rubric_bytes = std::size_t{1} << 20;
    require_file(arguments.scene);
    require_given(arguments.files.empty() ? "" : arguments.files.front(), "SUBMISSION",
                  "shaders (.glsl) and pictures (.png, .pfm, .exr)");
    if (arguments.out != "-") require_writable(arguments.out);
    Rubric rubric;
    if (!arguments.rubric.empty())
        rubric = take(read_rubric(take(read_file(arguments.rubric, max_rubric_bytes)), arguments.rubric));
    // Standard input can be read only once, so its bytes go to each process.
    std::string input;
    Outcome outcome;
    if (arguments.scene.file == "-") {
        input = take(read_file("-", max_json_bytes));
        (void)take(parse_scene(input, "-", arguments.scene.assignments));
    } else {
        outcome.warnings = open_scene(arguments.scene).warnings;
    }
    require_not_read(arguments.out);
    std::vector<GradeRow> rows = judge_all(arguments, input);
    for (GradeRow& row : rows) {
        if (!arguments.rubric.empty()) apply_rubric(row, rubric);
        if (!is_judged(row)) outcome.status = ExitStatus::Impossible;
    }
    (arguments.out == "-" ? outcome.output : outcome.bytes) = formatted(rows, arguments);
    if (arguments.out != "-") outcome.path = arguments.out;
    return outcome;
}

Run declare_grade(Options& options) {
    auto arguments = std::make_shared<GradeArguments>();
    add_scene(options, arguments->scene);
    options.add_words("SUBMISSION", "shaders (docs/shader.md), and pictures of the scene (.png, .pfm, .exr)",
                      [&files = arguments->files](const std::string& text) { files.push_back(text); });
    options.add_value(
        "--size", "WxH", "size of the pictures that shaders draw; default 640x480",
        [&size = arguments->size](const std::string& text) { size = read_size("--size", text); });
    add_timeout(options, arguments->timeout);
    add_text(options, "--rubric", "FILE.json", "points and hints for mistakes", arguments->rubric);
    options.add_value("--format", "FORMAT", "text (default), json, csv, html or junit",
                      [&format = arguments->format](const std::string& text) {
                          format = static_cast<GradeFormat>(
                              read_word("--format", text, {"text", "json", "csv", "html", "junit"}));
                      });
    options.add_value("-o", "OUT", "write the table to this file in place of standard output",
                      [&out = arguments->out](const std::string& text) { out = text; });
    return [arguments] { return grade(*arguments); };
}

}  // namespace

int run_grade_worker(const std::vector<std::string>& words) {
    GradeArguments arguments;
    arguments.scene.file = words.at(0);
    arguments.size = read_size("--size", words.at(2));
    arguments.timeout = read_amount("--timeout", words.at(3));
    arguments.scene.threads = std::max(1, std::stoi(words.at(4)));
    set_memory_limit(std::stoull(words.at(5)));
    for (std::size_t i = 6; i < words.size(); ++i)
        arguments.scene.assignments.push_back(take(parse_assignment(words[i])));
    (void)take(write_file("-", json_line(judged(words.at(1), arguments))));
    return 0;
}

Command grade_command() {
    return {
        "grade", "FILE SUBMISSION...", "judge the shaders and pictures of a class",
        "glint grade teapot.json class/*.glsl class/*.png --rubric rubric.json --format html -o grades.html",
        declare_grade};
}

}  // namespace glint
