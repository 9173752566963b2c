#pragma once
// Reads the arguments that commands share: scenes, lessons, sizes, pixels, counts. Reading is strict: "640x"
// and "0x5" are errors.

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/options.h"
#include "lessons/lesson.h"
#include "models/problem.h"
#include "models/scene/scene.h"
#include "models/scene_file/scene_file.h"

namespace glint {

struct Pixel {
    int x = 0, y = 0;  // counted from the top left
};

/// Reads "640x480", each side 1 to 16384. All these readers throw a Failure that names `option` in place of a
/// file.
[[nodiscard]] PictureSize read_size(const std::string& option, std::string_view text);
/// Reads "900,20", two whole numbers; require_inside() checks that the pixel is in the picture.
[[nodiscard]] Pixel read_pixel(const std::string& option, std::string_view text);
void require_inside(const std::string& option, Pixel pixel, PictureSize size);
/// Reads an integer in [least, most], written in decimal digits.
[[nodiscard]] int read_count(const std::string& option, std::string_view text, int least, int most);
/// Reads a finite number in [0, most].
[[nodiscard]] double read_amount(const std::string& option, std::string_view text,
                                 double most = std::numeric_limits<double>::infinity());
/// Returns the index of the word in `words` that is exactly `text`.
[[nodiscard]] std::size_t read_word(const std::string& option, std::string_view text,
                                    const std::vector<std::string>& words);

/// The arguments that all drawing commands share.
struct SceneArguments {
    std::string file;  // a scene, a picture that contains one, a mesh, or "-"
    std::vector<Assignment> assignments;
    int threads = 0;  // 0: all cores
};

/// Adds an option that takes a text value and may be given at most once.
void add_text(Options& options, const std::string& names, const std::string& value_name,
              const std::string& help, std::string& value);
/// Adds FILE, --set, --threads and --memory. `arguments` must live as long as `options`.
void add_scene(Options& options, SceneArguments& arguments);
void add_threads(Options& options, int& threads);
void add_memory(Options& options);
void add_size(Options& options, std::optional<PictureSize>& size);
/// Adds the option `--format text`, which is the default, or `--format json`.
void add_json_format(Options& options, bool& as_json);
/// Adds --timeout SECONDS, the time limit for drawing with one shader.
void add_timeout(Options& options, double& seconds);
void add_samples(Options& options, std::optional<int>& samples);

/// Opens the scene with its meshes and checks it completely. Throws Failure.
[[nodiscard]] SceneDocument open_scene(const SceneArguments& arguments);

/// Returns the given size or samples, or else those of the picture from which the scene was read. For other
/// scenes: 1280x720 and one sample.
[[nodiscard]] PictureSize size_to_draw(const std::optional<PictureSize>& given,
                                       const SceneDocument& document);
[[nodiscard]] int samples_to_draw(const std::optional<int>& given, const SceneDocument& document);
/// Warns that results computed with one sample per pixel differ from a picture with several.
void warn_of_samples(const SceneDocument& document, Warnings& warnings);

/// Throws Failure for a missing OUT, FILE or similar argument.
void require_given(const std::string& value, const std::string& option, const std::string& expected);
void require_file(const SceneArguments& arguments);

/// Throws Failure if the output file cannot be written, before any work is done; "-" is always accepted.
void require_writable(const std::string& out);

/// Throws Failure if the option's output file would overwrite one of the input files.
void require_not_read(const std::string& out, const std::string& option = "-o");

/// Writes a command's result to `-o`, which must not be one of the input files. Throws Failure.
void write_output(const std::string& out, std::string_view bytes);

/// Whether an output is written as PNG: "-", a name that ends in .png, or a device or pipe without an
/// extension.
[[nodiscard]] bool takes_png(const std::string& out);

/// Throws Failure if `-o` is given but does not name a PNG file. Standard output is not allowed either,
/// because the command prints its result there.
void require_png_file(const std::string& out);

/// Returns the path of the file or folder `relative` in `assets`: next to the program, in the installation,
/// or in the source tree whose build/PRESET/app contains the program. Empty if it exists in none of these
/// places.
[[nodiscard]] std::string asset_path(const std::string& relative);
/// Returns the paths where asset_path() looks for `relative` in an installation, for messages.
[[nodiscard]] std::string asset_places(const std::string& relative);

/// Returns the files of the named lessons: each word is a file, a folder of lessons, or the name or number of
/// an installed lesson ("05-lambert", "lambert", "5"). Without words: all installed lessons. Throws Failure.
[[nodiscard]] std::vector<std::string> named_lessons(const std::vector<std::string>& words);
/// Returns the file of the one lesson that `word` names. Throws Failure.
[[nodiscard]] std::string lesson_file(const std::string& word);
/// Opens the one lesson that `word` names. Throws Failure.
[[nodiscard]] Lesson open_lesson(const std::string& word);

// Errors in commands: app throws a Failure, and main() prints it as one line and exits with its status. Other
// layers return a Result; take() converts it.

/// docs/command_line.md: 0 success; 1 impossible because of the input or the machine; 2 wrong usage.
enum class ExitStatus { Done = 0, Impossible = 1, WrongUsage = 2 };

struct Failure {
    ExitStatus status;
    Problem problem;
};

/// Returns a failure that reports wrong usage of an option, of FILE or of a command. The name of the option
/// or command is printed in place of a file name.
[[nodiscard]] inline Failure wrong_usage(std::string option, std::string what, std::string expected = {}) {
    Problem problem;
    problem.file = std::move(option);
    problem.what = std::move(what);
    problem.expected = std::move(expected);
    return {ExitStatus::WrongUsage, std::move(problem)};
}

/// Returns the value of a result, or throws its problem: as wrong usage if it is about the value of --set or
/// --memory, else as a problem with the input.
template <class T> [[nodiscard]] T take(Result<T> result) {
    if (Problem* problem = std::get_if<Problem>(&result)) {
        const bool usage = problem->file == "--set" || problem->file == "--memory";
        throw Failure{usage ? ExitStatus::WrongUsage : ExitStatus::Impossible, std::move(*problem)};
    }
    return std::get<T>(std::move(result));
}

/// Prints "glint: KIND: the problem" to standard error: one line of at most 4096 bytes, with control
/// characters escaped.
void say(const char* kind, Problem problem);
/// Prints a warning in the same format as an error.
void say_warning(const std::string& warning);

}  // namespace glint
