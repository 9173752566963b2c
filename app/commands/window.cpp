// glint [FILE]: the window.
#include "app/window/window.h"

#include <memory>

#include "app/arguments.h"
#include "app/commands/command.h"

namespace glint {
namespace {

Run declare(Options& options) {
    auto arguments = std::make_shared<SceneArguments>();
    add_scene(options, *arguments);
    return [arguments]() -> Outcome {
        run_window({arguments->file, arguments->assignments, arguments->threads});
        return {};
    };
}

}  // namespace

Command window_command() { return {"", "[FILE]", "opens the window", "glint teapot.json", declare}; }

}  // namespace glint
