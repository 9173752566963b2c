#pragma once
// What is wrong with an object's mesh, what other programs would draw because of it, and where.

#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "ui/document/job.h"

namespace glint {

struct MeshCheck {
    MeshPtr mesh;                  // that is or was checked
    std::optional<MeshInfo> info;  // of `mesh`, when it is known
    JobPtr<MeshInfo> job, ending;  // computes it
    bool is_wanted = false;        // by the selected object's panel: it is open, or the mesh is from a file
    int hovered = -1, shown = -1;  // findings whose places the picture shows
};

/// The findings about the object's mesh, with a repair of those that the scene can repair. True when the
/// object was edited.
[[nodiscard]] bool mesh_check_rows(MeshCheck& check, Object& object);

}  // namespace glint
