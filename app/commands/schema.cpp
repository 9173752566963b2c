// glint schema: what a scene file may hold, for editors and other programs.
#include "app/commands/command.h"
#include "models/scene_file/scene_file.h"

namespace glint {
namespace {

Run declare(Options& /*options*/) {
    return [] { return Outcome{scene_schema(), {}, ExitStatus::Done}; };
}

}  // namespace

Command schema_command() {
    return {"schema", "", "prints the JSON Schema (2020-12) of the scene file",
            "glint schema > scene.schema.json", declare};
}

}  // namespace glint
