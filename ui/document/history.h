#pragma once
// Undo and redo: a list of scenes. A step costs what its plain data costs, and the meshes that it alone
// keeps: those that the present scene has lost or changed.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

class History {
  public:
    /// Forgets all steps and begins at `scene`.
    void reset(const Scene& scene);

    /// Adds a step from the present scene to `scene`, named by what changed, and drops what was undone.
    /// Equal scenes add nothing. `join`: if the newest step has the same name it is widened instead, so that
    /// ten clicks of the wheel are one step. True when the present scene changed.
    bool commit(const Scene& scene, bool join = false);

    [[nodiscard]] const Scene& present() const { return steps_[at_].scene; }
    [[nodiscard]] bool can_undo() const { return at_ > 0; }
    [[nodiscard]] bool can_redo() const { return at_ + 1 < steps_.size(); }
    /// Names of the step that undo() takes back and of the one that redo() does again; empty when there is
    /// none.
    [[nodiscard]] std::string undo_name() const { return can_undo() ? steps_[at_].name : std::string(); }
    [[nodiscard]] std::string redo_name() const { return can_redo() ? steps_[at_ + 1].name : std::string(); }

    /// Preconditions: can_undo() and can_redo().
    const Scene& undo();
    const Scene& redo();

  private:
    struct Step {
        std::string name;  // of the change that led here
        Scene scene;
    };
    void forget_oldest();
    [[nodiscard]] bool is_too_large() const;
    /// Of the meshes of all steps that the present scene does not have, each once.
    [[nodiscard]] std::uint64_t bytes_of_lost_meshes() const;

    std::vector<Step> steps_ = std::vector<Step>(1);
    std::size_t at_ = 0;
};

/// What changed between two scenes, as the name of a step: "Move Bulb", "Material of Teapot", "Add Lamp".
/// Empty when they are equal.
[[nodiscard]] std::string step_name(const Scene& before, const Scene& after);

}  // namespace glint
