#pragma once
// What the window remembers of the tab "Program" from frame to frame.

#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "programs/gl_calls.h"
#include "ui/features/inspector/blocks_in_sight.h"
#include "ui/features/inspector/program/transform_lines.h"
#include "ui/widgets/kept.h"

namespace glint {

/// A scene's calls as they are written in the tab.
struct WrittenCalls {
    Scene scene;  // with the transforms' numbers as they are written
    std::vector<WrittenTransform> transforms;
    std::vector<GlCallGroup> groups;
};

struct ProgramState {
    Kept<Scene, WrittenCalls> calls;     // of thousands of objects they take as long as a second
    Kept<Scene, std::string> program;    // whole_program_words()
    BlocksInSight groups{1}, places{1};  // the groups; the calls of the one with the lights' places
};

/// The command that writes a program of this scene, in a language that can.
[[nodiscard]] std::string whole_program_words(const Scene& scene);

}  // namespace glint
