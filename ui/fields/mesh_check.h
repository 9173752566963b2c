#pragma once
// Lists the defects of an object's mesh, where they are, and how other programs would draw them.

#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "ui/document/job.h"

namespace glint {

struct MeshCheck {
    MeshPtr mesh;                  // the mesh that is being or was checked
    std::optional<MeshInfo> info;  // info about `mesh`, once it is known
    JobPtr<MeshInfo> job, ending;  // computes it
    bool is_wanted = false;  // true while the selected object's panel needs it: open, or a mesh from a file
    int hovered = -1, shown = -1;  // findings whose positions the picture shows
};

/// Draws the findings about the object's mesh, with a button for each repair that the scene can store.
void mesh_check_rows(MeshCheck& check, Object& object);

}  // namespace glint
