#pragma once
// What the commands answer about scenes and pictures, as JSON: written here, so that the command line, the
// claims of a lesson and the window say the same. docs/interface.md names the fields.

#include <vector>

#include "models/json/json_value.h"
#include "models/mesh/mesh.h"
#include "models/scene/scene.h"
#include "renderer/inspect/debug_views/compare.h"
#include "renderer/inspect/debug_views/profile.h"
#include "renderer/renderer.h"

namespace glint {

/// `glint info` of a mesh, and of a scene whose meshes are loaded; `size` is for clip_from_view.
[[nodiscard]] JsonValue info_json(const Mesh& mesh);
[[nodiscard]] JsonValue info_json(const Scene& scene, PictureSize size);

/// `glint render --stats` of the last picture.
[[nodiscard]] JsonValue stats_json(const Renderer& renderer, PictureSize size);

/// `glint compare`.
[[nodiscard]] JsonValue comparison_json(const Comparison& comparison);

/// `glint profile`: a list for each column of profile_csv(), null where a sample does not have it.
[[nodiscard]] JsonValue profile_json(const std::vector<ProfileSample>& samples);

}  // namespace glint
