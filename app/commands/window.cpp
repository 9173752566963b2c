// glint [FILE]: the window.
#include "app/window.h"

#include <memory>

#include "app/arguments.h"
#include "app/commands/command.h"

namespace glint {
namespace {

Run declare(CLI::App& app) {
    auto arguments = std::make_shared<SceneArguments>();
    add_scene(app, *arguments);
    return [arguments]() -> Outcome {
        // The window has said what went wrong, if anything did.
        const int status = run_window({arguments->file, arguments->assignments, arguments->threads});
        return {{}, {}, static_cast<ExitStatus>(status)};
    };
}

}  // namespace

Command window_command() { return {"", "[FILE]", "opens the window", "glint teapot.json", declare}; }

}  // namespace glint
