// glint compare: measures the difference between two pictures.
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/io/file.h"
#include "renderer/answers/answers.h"
#include "renderer/image/image_file.h"

namespace glint {
namespace {

struct CompareArguments {
    std::string a, b, out;
    std::optional<double> max_error;
    int threads = 0;  // accepted by every command; unused here
};

Outcome compare(const CompareArguments& arguments) {
    require_given(arguments.a, "A.png", "two pictures to compare");
    require_given(arguments.b, "B.png", "a second picture to compare with");
    require_png_file(arguments.out);
    if (!arguments.out.empty()) require_writable(arguments.out);
    const Picture a = take(read_png(arguments.a));
    const Picture b = take(read_png(arguments.b));
    require_not_read(arguments.out);
    Result<Comparison> compared = glint::compare(a, b);
    if (Problem* problem = std::get_if<Problem>(&compared)) problem->file = arguments.b;
    const Comparison result = take(std::move(compared));
    // A difference above the limit is a result, not an error: only the exit status reports it.
    const bool too_far = arguments.max_error && result.max_error > *arguments.max_error;
    Outcome outcome{
        json_text(comparison_json(result)), {}, too_far ? ExitStatus::Impossible : ExitStatus::Done};
    outcome.path = arguments.out;
    if (!arguments.out.empty())
        outcome.bytes = png_bytes(difference_picture(a, b, difference_gain(result)), {});
    return outcome;
}

Run declare_compare(Options& options) {
    auto arguments = std::make_shared<CompareArguments>();
    add_text(options, "A.png", "", "a PNG picture", arguments->a);
    add_text(options, "B.png", "", "another picture of the same size", arguments->b);
    add_text(options, "-o", "DIFF.png",
             "write the absolute difference, multiplied by the `gain` in the output", arguments->out);
    options.add_value("--max-error", "E",
                      "exit with status 1 if any channel of any pixel differs by more than E, 0 to 255",
                      [&max_error = arguments->max_error](const std::string& text) {
                          max_error = read_amount("--max-error", text, 255);
                      });
    add_threads(options, arguments->threads);
    add_memory(options);
    return [arguments] { return compare(*arguments); };
}

}  // namespace

Command compare_command() {
    return {"compare", "A.png B.png", "measure the difference between two pictures, as JSON",
            "glint compare before.png after.png -o difference.png --max-error 1", declare_compare};
}

}  // namespace glint
