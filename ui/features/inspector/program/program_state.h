#pragma once
// State of the tab "Program" from frame to frame.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "programs/gl_calls.h"
#include "ui/features/inspector/inspector.h"
#include "ui/widgets/area.h"
#include "ui/widgets/kept.h"

namespace glint {

// The calls of an object's transforms in the Program tab can be dragged past each other. A scene file has a
// fixed order, so the numbers do not change and the object moves to where the other order puts it.

/// An object's transform as written in the tab.
struct WrittenTransform {
    TransformOrder order = file_order;
    Transform numbers;
    bool operator==(const WrittenTransform&) const = default;
};

/// Returns how the object with that index is written in the current window: as kept last, or in the file's
/// order if something else has changed `transform` since.
[[nodiscard]] WrittenTransform written_transform(int object, const Transform& transform);
/// Keeps the written form for the next frame; `transform` is the result.
void keep_written(int object, const WrittenTransform& written, const Transform& transform);

/// The transform of a call; nothing for other calls.
[[nodiscard]] std::optional<TransformStep> step_of(const GlCall& call);

/// Puts the calls of the three transforms, which must be consecutive, into that order.
void put_in_order(std::vector<GlCall>& calls, const TransformOrder& order);

/// Returns the order while the step's lines are dragged to height `mouse_y`. They pass a neighbour once they
/// would be under the mouse afterwards. `areas`: of each step's lines, in written order.
[[nodiscard]] TransformOrder dragged_order(const TransformOrder& order, TransformStep held, float mouse_y,
                                           std::span<const Rect, 3> areas);

/// Explains, below the calls, the effect of an order other than the file's; draws nothing in the file's
/// order.
void order_note(const WrittenTransform& written, const Transform& transform);

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
