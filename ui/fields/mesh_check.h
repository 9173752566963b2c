#pragma once
// Lists the defects of an object's mesh, how other programs would draw them, and where they are.

#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "ui/document/job.h"

namespace glint {

struct MeshCheck {
    MeshPtr mesh;                  // the mesh that is being or was checked
    std::optional<MeshInfo> info;  // of `mesh`, when it is known
    JobPtr<MeshInfo> job, ending;  // computes it
    bool is_wanted = false;  // true while the selected object's panel needs it: open, or a mesh from a file
    int hovered = -1, shown = -1;  // findings whose places the picture shows
};

/// Draws the findings about the object's mesh, with a repair for those that the scene can repair.
void mesh_check_rows(MeshCheck& check, Object& object);

}  // namespace glint
