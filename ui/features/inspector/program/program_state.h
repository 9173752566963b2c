#pragma once
// State of the tab "Program" from frame to frame.

#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "programs/gl_calls.h"
#include "ui/features/inspector/blocks_in_sight.h"
#include "ui/features/inspector/program/transform_lines.h"
#include "ui/widgets/kept.h"

namespace glint {

/// A scene's calls as written in the tab.
struct WrittenCalls {
    Scene scene;  // the scene with the transforms' numbers as written
    std::vector<WrittenTransform> transforms;
    std::vector<GlCallGroup> groups;
};

struct ProgramState {
    Kept<Scene, WrittenCalls> calls;     // with thousands of objects, computing them takes up to a second
    Kept<Scene, std::string> program;    // whole_program_words()
    BlocksInSight groups{1}, places{1};  // the groups; within one, the calls of the lights' positions
};

/// The command that writes a program for this scene, in a supported language.
[[nodiscard]] std::string whole_program_words(const Scene& scene);

}  // namespace glint
