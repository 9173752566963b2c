// glint [FILE...]: the window.
#include "app/window/window.h"

#include <memory>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/failure.h"
#include "app/lesson_arguments.h"
#include "models/io/file.h"
#include "ui/lessons/course.h"

namespace glint {
namespace {

/// Throws for a missing file now, before PgDn would come to it.
void require_all(const std::vector<std::string>& files) {
    for (const std::string& file : files)
        if (auto problem = why_not_there(file, "scenes, meshes, or pictures that Glint wrote"))
            throw Failure{ExitStatus::Impossible, *std::move(problem)};
}

Run declare_window(Options& options) {
    auto arguments = std::make_shared<SceneArguments>();
    auto more = std::make_shared<std::vector<std::string>>();
    auto lesson = std::make_shared<std::string>();
    add_scene(options, *arguments);
    add_text(options, "--lesson", "NAME", "open a lesson: by its name or number, or its file (.md)", *lesson);
    options.add_words("MORE", "further files: PgDn and PgUp go through all of them, in this order",
                      [more](const std::string& text) { more->push_back(text); });
    return [arguments, more, lesson]() -> Outcome {
        require_all(*more);
        std::vector<std::string> files{arguments->file};
        files.insert(files.end(), more->begin(), more->end());
        if (lesson->empty() && is_lesson_file(arguments->file)) std::swap(*lesson, arguments->file);
        if (lesson->empty()) {
            run_window({arguments->file, arguments->assignments, arguments->threads, files, ""});
            return {};
        }
        if (!arguments->file.empty())
            throw wrong_usage("--lesson", "cannot be combined with " + arguments->file, "one of the two");
        if (!more->empty())
            throw wrong_usage(more->front(), "cannot be combined with a lesson", "the lesson alone");
        if (!arguments->assignments.empty())
            throw wrong_usage("--set", "cannot be combined with a lesson, which has its own scene",
                              "one of the two");
        run_window({"", {}, arguments->threads, {}, lesson_file(*lesson)});
        return {};
    };
}

}  // namespace

Command window_command() {
    return {"", "[FILE...]", "opens the window", "glint teapot.json", declare_window};
}

}  // namespace glint
