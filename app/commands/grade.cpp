// glint grade: judges the shaders and pictures of a class, each in a process of its own.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/options.h"
#include "diagnose/diagnosis_format.h"
#include "diagnose/search/display_change.h"
#include "models/io/file.h"
#include "models/json/json.h"
#include "models/memory_limit.h"
#include "models/scene/mistakes.h"
#include "models/utf8.h"
#include "renderer/image/image_file.h"
#include "shader/shader_process.h"

namespace glint {
namespace {

// A table of grades for a class: the verdict on each submitted file, with points and hints from a rubric.

/// The points and the hint for a mistake or a verdict. Source: docs/command_line.md, "grade".
struct RubricEntry {
    std::optional<double> points;
    std::string hint;
};

struct Rubric {
    std::optional<double> points;  // awarded to a picture without mistakes
    std::map<std::string, RubricEntry, std::less<>> mistakes, verdicts;
};

// Verdicts that do not come from a diagnosis.
constexpr const char* does_not_compile = "does not compile";
constexpr const char* does_not_end = "does not end";
constexpr const char* not_judged = "not judged";

/// A row of the table is a JSON object with the fields of `--format json` (docs/command_line.md) and, for the
/// page, `picture_html` and `reference_html`.
using GradeRow = Json;

constexpr std::array verdicts{
    "mistake",        "left out",       "another setting", "another number", "not in the catalogue",
    "not comparable", does_not_compile, does_not_end,      not_judged};
constexpr Range points_range{-1e6, 1e6, "a number"};

RubricEntry entry_of(const Node& node) {
    RubricEntry entry;
    node.allow_keys({"points", "hint"});
    node.with("points", [&](const Node& points) { entry.points = number(points, points_range); });
    node.with("hint", [&](const Node& hint) { entry.hint = text(hint); });
    return entry;
}

/// Reads the object's members, whose keys must be in `known`.
std::map<std::string, RubricEntry, std::less<>> entries_of(const Node& node,
                                                           const std::vector<std::string>& known) {
    std::map<std::string, RubricEntry, std::less<>> entries;
    if (!node.value().is_object()) node.wrong_type("an object");
    node.allow_keys(known);
    for (const auto& [key, value] : members_of(node.value())) entries[key] = entry_of(Node(value, node, key));
    return entries;
}

std::string string_of(const GradeRow& row, std::string_view key) {
    const Json* const found = find_member(row, key);
    if (found == nullptr || found->is_null()) return {};
    return found->is_string() ? found->get<std::string>() : json_line(*found);
}

/// Returns the strings of a list, each on one line.
std::vector<std::string> strings_of(const GradeRow& row, std::string_view key) {
    std::vector<std::string> strings;
    const Json* const found = find_member(row, key);
    if (found == nullptr) return strings;
    for (const Json& one : elements_of(*found)) strings.push_back(on_one_line(one.get<std::string>()));
    return strings;
}

bool has_points(const std::vector<GradeRow>& rows) {
    return std::any_of(rows.begin(), rows.end(),
                       [](const GradeRow& row) { return !string_of(row, "points").empty(); });
}

/// Returns the verdict, followed by the mistake if there is one: "mistake: reflect_sign".
std::string finding_of(const GradeRow& row) {
    const std::string mistake = string_of(row, "mistake");
    return string_of(row, "verdict") + (mistake.empty() ? "" : ": " + mistake);
}

std::string csv_field(std::string text) {
    if (!text.empty() && std::string_view("=+-@\t").find(text[0]) != std::string_view::npos)
        text.insert(0, "'");  // keeps spreadsheets from reading it as a formula
    if (text.find_first_of(",\"\r\n") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string(2, c) : std::string(1, c);
    return quoted + "\"";
}

/// Returns the row's pixel as "537,188", or an empty string if the row has none.
std::string pixel_of(const GradeRow& row, const char* separator) {
    const Json* const pixel = find_member(row, "pixel");
    if (pixel == nullptr) return {};
    return fmt::format("{}{}{}", (*pixel)[0].get<int>(), separator, (*pixel)[1].get<int>());
}

/// Returns the colour as "rgb(1,2,3)", or an empty string if the row has none.
std::string color_of(const GradeRow& row, std::string_view key) {
    const Json* const found = find_member(row, key);
    if (found == nullptr || !found->is_array()) return {};
    std::vector<int> channels;
    for (const Json& channel : elements_of(*found)) channels.push_back(channel.get<int>());
    return fmt::format("rgb({})", fmt::join(channels, ","));
}

/// Returns the HTML of a ring around the deciding pixel in a small picture.
std::string ring(const GradeRow& row) {
    const Json *const pixel = find_member(row, "pixel"), *const size = find_member(row, "size");
    if (pixel == nullptr || size == nullptr) return {};
    const auto share = [&](std::size_t i) {
        return 100 * ((*pixel)[i].get<double>() + 0.5) / std::max(1.0, (*size)[i].get<double>());
    };
    return fmt::format("<i style=\"left:{:.2f}%;top:{:.2f}%\"></i>", share(0), share(1));
}

constexpr std::string_view style =
    "body{font:16px/1.45 system-ui,sans-serif;margin:2em auto;max-width:75em;padding:0 1em}"
    "table{border-collapse:collapse;width:100%}th,td{text-align:left;vertical-align:top;padding:.6em .8em;"
    "border-bottom:1px solid #8884}figure{margin:0;position:relative;display:inline-block}img{display:block}"
    "i{position:absolute;width:14px;height:14px;margin:-9px;border:2px solid #fff;border-radius:50%;"
    "box-shadow:0 0 0 2px #000}b.s{display:inline-block;width:1em;height:1em;vertical-align:-.15em;"
    "border:1px solid #888}code{font-size:.9em}.right{color:#187a2f}.wrong{color:#b3261e}p{margin:.3em 0}"
    "pre{margin:.3em 0;white-space:pre-wrap;font-size:.9em}:root{color-scheme:light dark}"
    "@media(prefers-color-scheme:dark){.right{color:#7bd88f}.wrong{color:#ff9a92}}";

std::string figure(const GradeRow& row, std::string_view key) {
    const std::string image = string_of(row, key);
    return image.empty() ? "" : "<figure>" + image + ring(row) + "</figure>";
}

std::string html_row(const GradeRow& row, bool points) {
    const bool is_right = string_of(row, "verdict") == "no mistake";
    std::string cell =
        fmt::format("<b class=\"{}\">{}</b>", is_right ? "right" : "wrong", html_escaped(finding_of(row)));
    const auto paragraph = [&cell](const std::string& html) {
        if (!html.empty()) cell += "<p>" + html + "</p>";
    };
    const std::string hint = string_of(row, "hint"),
                      also = fmt::format("{}", fmt::join(strings_of(row, "also"), ", "));
    paragraph(html_escaped(string_of(row, "text")));
    paragraph(hint.empty() ? "" : "<em>" + html_escaped(hint) + "</em>");
    paragraph(also.empty() ? "" : "Looks the same here: <code>" + html_escaped(also) + "</code>");
    if (const std::string mine = color_of(row, "mine"); !mine.empty())
        paragraph(fmt::format(
            "Pixel {}: yours <b class=\"s\" style=\"background:{}\"></b> {}, correct "
            "<b class=\"s\" style=\"background:{}\"></b> {}",
            pixel_of(row, ","), mine, mine, color_of(row, "reference"), color_of(row, "reference")));
    for (const std::string& message : strings_of(row, "messages"))
        cell += "<pre>" + html_escaped(message) + "</pre>";
    return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td>{}</tr>\n",
                       html_escaped(string_of(row, "file")), figure(row, "picture_html"),
                       figure(row, "reference_html"), cell,
                       points ? "<td>" + html_escaped(string_of(row, "points")) + "</td>" : "");
}

/// Returns a problem if the text is not JSON, contains an unknown key, mistake or verdict, or a wrong type.
Result<Rubric> read_rubric(const std::string& text, const std::string& file) {
    return result_of(file, [&] {
        const Json json = parsed_json(text, file);
        const Node root(json);
        if (!json.is_object()) root.wrong_type("an object");
        root.allow_keys({"points", "mistakes", "verdicts"});
        std::vector<std::string> names;
        for (const MistakeName& mistake : mistake_names()) names.emplace_back(mistake.name);
        Rubric rubric;
        root.with("points", [&](const Node& node) { rubric.points = number(node, points_range); });
        root.with("mistakes", [&](const Node& node) { rubric.mistakes = entries_of(node, names); });
        root.with("verdicts", [&](const Node& node) {
            rubric.verdicts = entries_of(node, {verdicts.begin(), verdicts.end()});
        });
        return rubric;
    });
}

/// Adds the rubric's `points` and `hint` to a row.
void apply_rubric(GradeRow& row, const Rubric& rubric) {
    const std::string verdict = string_of(row, "verdict");
    std::vector<std::string> names = strings_of(row, "also");  // mistakes that look the same
    names.insert(names.begin(), string_of(row, "mistake"));
    RubricEntry entry;
    if (verdict == "no mistake") {
        entry.points = rubric.points;
    } else {
        if (const auto found = rubric.verdicts.find(verdict); found != rubric.verdicts.end())
            entry = found->second;
        for (const std::string& name : names) {
            const auto found = rubric.mistakes.find(name);
            if (found == rubric.mistakes.end()) continue;
            if (found->second.points) entry.points = found->second.points;
            if (!found->second.hint.empty()) entry.hint = found->second.hint;
            break;
        }
        if (!entry.points && rubric.points) entry.points = 0;
    }
    row["points"] = entry.points ? number_json(static_cast<float>(*entry.points)) : Json();
    row["hint"] = entry.hint;
}

/// Whether Glint judged the file.
bool is_judged(const GradeRow& row) { return string_of(row, "verdict") != not_judged; }

std::string grades_text(const std::vector<GradeRow>& rows) {
    const bool points = has_points(rows);
    std::size_t widest = std::string_view("file").size();
    for (const GradeRow& row : rows) widest = std::max(widest, on_one_line(string_of(row, "file")).size());
    const std::size_t indent = widest + 2 + (points ? 8 : 0);
    std::string text;
    const auto line = [&](const std::string& file, const std::string& point, const std::string& rest) {
        text += fmt::format("{:<{}}  ", file, widest);
        if (points) text += fmt::format("{:>6}  ", point);
        text += rest + "\n";
    };
    line("file", "points", "verdict");
    for (const GradeRow& row : rows) {
        line(on_one_line(string_of(row, "file")), string_of(row, "points"), finding_of(row));
        std::vector<std::string> more = strings_of(row, "messages");
        if (const std::string hint = string_of(row, "hint"); !hint.empty())
            more.insert(more.begin(), on_one_line(hint));
        for (const std::string& message : more) text += std::string(indent, ' ') + message + "\n";
    }
    return text;
}

/// Returns a JSON object for each row, on a line of its own, without the pictures.
std::string grades_json(const std::vector<GradeRow>& rows) {
    std::string lines;
    for (GradeRow row : rows) {
        row.erase("picture_html");
        row.erase("reference_html");
        lines += json_line(row) + "\n";
    }
    return lines;
}

std::string grades_csv(const std::vector<GradeRow>& rows) {
    std::string text = "file,verdict,mistake,also,points,hint,pixel,messages\n";
    for (const GradeRow& row : rows) {
        const std::array fields{
            string_of(row, "file"),    string_of(row, "verdict"),
            string_of(row, "mistake"), fmt::format("{}", fmt::join(strings_of(row, "also"), ", ")),
            string_of(row, "points"),  string_of(row, "hint"),
            pixel_of(row, " "),        fmt::format("{}", fmt::join(strings_of(row, "messages"), "; "))};
        for (std::size_t i = 0; i < fields.size(); ++i)
            text +=
                (i > 0 ? "," : "") + (i == 4 ? fields[i] : csv_field(fields[i]));  // points may be negative
        text += "\n";
    }
    return text;
}

/// Returns a self-contained HTML page; `title` is the scene's name.
std::string grades_html(const std::vector<GradeRow>& rows, const std::string& title) {
    const bool points = has_points(rows);
    const auto right = std::count_if(rows.begin(), rows.end(), [](const GradeRow& row) {
        return string_of(row, "verdict") == "no mistake";
    });
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta "
        "charset=\"utf-8\"><title>{0}</title><style>{1}</style>"
        "</head><body>\n<h1>Grades: {0}</h1>\n<p>{2} of {3} without a "
        "mistake.</p>\n<table>\n<tr><th>File</th>"
        "<th>Yours</th><th>Correct</th><th>Verdict</th>{4}</tr>\n",
        html_escaped(title), style, right, rows.size(), points ? "<th>Points</th>" : "");
    for (const GradeRow& row : rows) html += html_row(row, points);
    return html + "</table>\n</body></html>\n";
}

/// Returns a JUnit test case for each file: a mistake is a failure, and a file that was not judged is an
/// error.
std::string grades_junit(const std::vector<GradeRow>& rows, const std::string& title) {
    std::string cases;
    std::size_t failures = 0, errors = 0;
    for (const GradeRow& row : rows) {
        cases += fmt::format("  <testcase classname=\"{}\" name=\"{}\"", html_escaped(title),
                             html_escaped(string_of(row, "file")));
        if (string_of(row, "verdict") == "no mistake") {
            cases += "/>\n";
            continue;
        }
        ++(is_judged(row) ? failures : errors);
        const char* const kind = is_judged(row) ? "failure" : "error";
        std::vector<std::string> more = strings_of(row, "messages");
        for (const char* key : {"text", "hint"})
            if (std::string text = string_of(row, key); !text.empty()) more.push_back(std::move(text));
        cases +=
            fmt::format(">\n    <{0} message=\"{1}\">{2}</{0}>\n  </testcase>\n", kind,
                        html_escaped(finding_of(row)), html_escaped(fmt::format("{}", fmt::join(more, " "))));
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
        "errors=\"{}\">\n{}</testsuite>\n",
        html_escaped(title), rows.size(), failures, errors, cases);
}

enum class GradeFormat { Text, Json, Csv, Html, Junit };
constexpr PictureSize default_size{640, 480};

struct GradeArguments {
    SceneArguments scene;
    std::vector<std::string> files;
    PictureSize size = default_size;  // size of the pictures that shaders draw
    double timeout = 10;              // seconds for each shader
    std::string rubric, out = "-";
    GradeFormat format = GradeFormat::Text;
};

// Grading one file, in a process of its own.

/// Adds to the row the name and numbers of the first explanation, as in the public JSON of a diagnosis.
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
    const auto [shown, undone] =
        as_arrived(as_shown(std::move(picture), document.scene.display), document.scene);
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

/// Draws the scene with a shader; if that is impossible, returns nullopt and puts the reason into the row.
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

/// Whether the name has the extension of a picture. Unsupported formats count as well, because the error from
/// reading such a file lists the supported formats.
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

// Grading all files, by starting a process for each.

/// The arguments for run_grade_worker(): everything that judged() needs.
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
        why = "the process that judges it did not start: " + reason(end.status);
    return {{"file", file}, {"verdict", not_judged}, {"messages", Json::array({file + ": " + why})}};
}

/// Judges all files, as many at the same time as there are threads.
std::vector<GradeRow> judge_all(const GradeArguments& arguments, const std::string& input) {
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t threads = arguments.scene.threads > 0 ? std::size_t(arguments.scene.threads) : cores;
    const std::size_t processes = std::clamp<std::size_t>(arguments.files.size(), 1, threads);
    constexpr double seconds_to_judge = 300;
    // The limit is on address space, much of which is never used.
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
    // Standard input can be read only once, so its bytes are passed to each process.
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
