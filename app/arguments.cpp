#include "app/arguments.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "models/io/file.h"
#include "models/memory_limit.h"

namespace glint {

namespace fs = std::filesystem;

namespace {

constexpr int max_threads = 1024;

/// Parses all of `text` as an integer: digits with an optional minus. Returns nullopt for any other text.
std::optional<int> whole_number(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Whether the text is an integer, even one that is too large for an int.
bool are_digits(std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

struct Pair {
    std::optional<int> first, second;
};
Pair pair_of(std::string_view text, char separator) {
    const auto at = text.find(separator);
    if (at == std::string_view::npos) return {};
    return {whole_number(text.substr(0, at)), whole_number(text.substr(at + 1))};
}

}  // namespace

PictureSize read_size(const std::string& option, std::string_view text) {
    const auto [width, height] = pair_of(text, 'x');
    const auto fits = [](const std::optional<int>& side) {
        return side && *side >= 1 && *side <= max_picture_side;
    };
    if (fits(width) && fits(height)) return {*width, *height};
    throw wrong_usage(option, fmt::format("{} is not a picture size", text),
                      fmt::format("WIDTHxHEIGHT as in 1280x720, 1x1 to {0}x{0}", max_picture_side));
}

Pixel read_pixel(const std::string& option, std::string_view text) {
    const auto [x, y] = pair_of(text, ',');
    if (x && y) return {*x, *y};
    throw wrong_usage(option, fmt::format("{} is not a pixel", text), "X,Y as in 640,360");
}

void require_inside(const std::string& option, Pixel pixel, PictureSize size) {
    if (pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.width && pixel.y < size.height) return;
    throw wrong_usage(option, fmt::format("{},{} is outside the picture", pixel.x, pixel.y),
                      fmt::format("0 to {}, 0 to {}", size.width - 1, size.height - 1));
}

int read_count(const std::string& option, std::string_view text, int least, int most) {
    const auto value = whole_number(text);
    if (value && *value >= least && *value <= most) return *value;
    throw wrong_usage(option,
                      fmt::format("{} is {}", text, are_digits(text) ? "out of range" : "not a whole number"),
                      fmt::format("{} to {}", least, most));
}

double read_amount(const std::string& option, std::string_view text, double most) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    if (whole && std::isfinite(value) && value >= 0 && value <= most) return value;
    throw wrong_usage(option, fmt::format("{} is {}", text, whole ? "out of range" : "not a number"),
                      std::isfinite(most) ? fmt::format("0 to {}", most) : "0 or more");
}

std::size_t read_word(const std::string& option, std::string_view text,
                      const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == text) return i;
    }
    throw wrong_usage(option, fmt::format("{} is not known", text),
                      fmt::format("{}", fmt::join(words, ", ")));
}

void add_text(Options& options, const std::string& names, const std::string& value_name,
              const std::string& help, std::string& value) {
    options.add_value(names, value_name, help, [&value](const std::string& text) { value = text; });
}

void add_threads(Options& options, int& threads) {
    options.add_value(
        "-j,--threads", "N", "threads to use; default 0: all cores",
        [&threads](const std::string& text) { threads = read_count("--threads", text, 0, max_threads); });
}

void add_memory(Options& options) {
    options.add_value(
        "--memory", "SIZE", "memory limit for the scene, such as 8G; default: 3/4 of all memory",
        [](const std::string& text) { set_memory_limit(take(parse_memory_size("--memory", text))); });
}

void add_size(Options& options, std::optional<PictureSize>& size) {
    options.add_value(
        "--size", "WxH",
        "size of the picture in pixels; default: the size of FILE if it is a picture, else 1280x720",
        [&size](const std::string& text) { size = read_size("--size", text); });
}

void add_json_format(Options& options, bool& as_json) {
    options.add_value("--format", "FORMAT", "text (default) or json", [&as_json](const std::string& text) {
        as_json = read_word("--format", text, {"text", "json"}) == 1;
    });
}

void add_timeout(Options& options, double& seconds) {
    constexpr double most = 3600;
    options.add_value(
        "--timeout", "SECONDS", "stop a shader after this many seconds, at most 3600; default 10",
        [&seconds](const std::string& text) { seconds = read_amount("--timeout", text, most); });
}

void add_samples(Options& options, std::optional<int>& samples) {
    options.add_value("--samples", "N",
                      "samples per pixel, for smooth edges: 1, 2, 4 or 8; default: those of FILE if it is a "
                      "picture, else 1",
                      [&samples](const std::string& text) {
                          samples = 1 << read_word("--samples", text, {"1", "2", "4", "8"});
                      });
}

void add_scene(Options& options, SceneArguments& arguments) {
    add_text(
        options, "FILE", "",
        "a scene (.json, .glb, .gltf), a PNG from Glint that contains its scene, a mesh (.obj, .ply, .off, "
        ".stl), or - for a scene on standard input",
        arguments.file);
    options.works_on(arguments.file);
    options.add_values("--set", "POINTER=JSON",
                       "change the scene, for example /lights/0/position=[1,2,3]; may be repeated",
                       [&arguments](const std::string& text) {
                           arguments.assignments.push_back(take(parse_assignment(text)));
                       });
    add_threads(options, arguments.threads);
    add_memory(options);
}

void require_given(const std::string& value, const std::string& option, const std::string& expected) {
    if (value.empty()) throw wrong_usage(option, "is missing", expected);
}

void require_file(const SceneArguments& arguments) {
    require_given(arguments.file, "FILE", "a scene, a mesh, or - for a scene on standard input");
}

void require_writable(const std::string& out) {
    if (const auto problem = why_not_writable(out)) throw Failure{ExitStatus::Impossible, *problem};
}

void require_not_read(const std::string& out, const std::string& option) {
    if (was_read(out))
        throw wrong_usage(option, out + " is an input file and would be overwritten", "a different name");
}

void write_output(const std::string& out, std::string_view bytes) {
    require_not_read(out);
    (void)take(write_file(out, bytes));
}

bool takes_png(const std::string& out) {
    if (out == "-" || lower_extension(out) == ".png") return true;
    const fs::path path = out;
    std::error_code ignored;
    const auto status = fs::status(path, ignored);
    const bool is_channel = fs::is_character_file(status) || fs::is_fifo(status);
    return is_channel && !path.has_extension();
}

void require_png_file(const std::string& out) {
    if (is_standard_output(out))
        throw wrong_usage("-o", "standard output is used for the result", "a name that ends in .png");
    if (out.empty() || takes_png(out)) return;
    throw wrong_usage("-o", out + " cannot be written", "a name that ends in .png");
}

SceneDocument open_scene(const SceneArguments& arguments) {
    require_file(arguments);
    SceneDocument document = take(open_document(arguments.file, arguments.assignments));
    // A scene read from a picture is drawn with the picture's projection.
    Projection& projection = document.scene.camera.projection;
    if (document.fitted_to) projection = fitted(projection, *document.fitted_to);
    return document;
}

PictureSize size_to_draw(const std::optional<PictureSize>& given, const SceneDocument& document) {
    return given.value_or(document.picture_size.value_or(PictureSize{}));
}

int samples_to_draw(const std::optional<int>& given, const SceneDocument& document) {
    return given.value_or(document.picture_samples);
}

void warn_of_samples(const SceneDocument& document, Warnings& warnings) {
    if (document.picture_samples == 1) return;
    warnings.push_back(
        fmt::format("{}: the picture has {} samples per pixel, but these numbers are for one "
                    "sample, so they differ at edges",
                    on_one_line(document.path), document.picture_samples));
}

std::string asset_path(const std::string& relative) {
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    const fs::path asset = fs::path("assets") / relative;
    const fs::path folder = program.parent_path();
    for (const fs::path& root : {folder, folder / "../share/glint", folder / "../../.."})
        if (fs::exists(root / asset, failed)) return (root / asset).lexically_normal().string();
    return {};
}

std::string asset_places(const std::string& relative) {
    return "assets/" + relative + " next to the program, or in ../share/glint relative to it";
}

namespace {

/// A lesson in "05-lambert.md" is found under the names "05-lambert", "lambert", "05" and "5".
bool is_named(const std::string& file, const std::string& word) {
    const std::string name = fs::path(file).stem().string();
    const std::size_t dash = std::min(name.find('-'), name.size());
    const std::string number = name.substr(0, dash);
    const std::size_t first = std::min(number.find_first_not_of('0'), number.size() - 1);
    return word == name || word == number || (!number.empty() && word == number.substr(first)) ||
           (dash < name.size() && word == name.substr(dash + 1));
}

std::vector<std::string> own_lessons() {
    const std::string folder = asset_path("lessons");
    std::vector<std::string> files;
    if (!folder.empty()) files = take(lesson_files({folder}));
    if (files.empty())
        throw Failure{ExitStatus::Impossible, {"", "", "no lessons are installed", asset_places("lessons")}};
    return files;
}

}  // namespace

std::vector<std::string> named_lessons(const std::vector<std::string>& words) {
    if (words.empty()) return own_lessons();
    std::vector<std::string> files;
    for (const std::string& word : words) {
        std::error_code ignored;
        if (fs::exists(word, ignored)) {
            const std::vector<std::string> found = take(lesson_files({word}));
            if (found.empty()) throw wrong_usage(word, "contains no lessons", "a folder with lessons");
            files.insert(files.end(), found.begin(), found.end());
            continue;
        }
        const std::size_t before = files.size();
        std::vector<std::string> names;
        for (const std::string& file : own_lessons()) {
            names.push_back(fs::path(file).stem().string());
            if (is_named(file, word)) files.push_back(file);
        }
        if (files.size() == before)
            throw wrong_usage(word, "neither a file nor a lesson",
                              "a lesson, such as " + nearest(word, names) + ", or a file");
    }
    return files;
}

std::string lesson_file(const std::string& word) {
    const std::vector<std::string> files = named_lessons({word});
    if (files.size() != 1) throw wrong_usage(word, fmt::format("names {} lessons", files.size()), "only one");
    return files[0];
}

Lesson open_lesson(const std::string& word) { return take(read_lesson(lesson_file(word))); }

void say(const char* kind, Problem problem) {
    const std::string head = fmt::format("glint: {}: ", kind);
    // The length limit applies to the entire line, so that truncation keeps its beginning.
    problem.file.empty() ? problem.what.insert(0, head) : problem.file.insert(0, head);
    std::fputs((problem.text() + "\n").c_str(), stderr);
}

void say_warning(const std::string& warning) {
    say("warning", {.file = {}, .pointer = {}, .what = warning, .expected = {}});
}

}  // namespace glint
