#pragma once
// The JSON output of commands about scenes and pictures. Shared by the command line, the claims of lessons
// and the window, so that they agree. docs/command_line.md documents the fields.

#include <vector>

#include "models/json/json.h"
#include "models/mesh/mesh.h"
#include "models/scene/scene.h"
#include "renderer/debug_views/profile.h"
#include "renderer/image/compare.h"
#include "renderer/renderer.h"

namespace glint {

/// The output of `glint info`: for a mesh with normals from `source`, and for a scene with loaded meshes.
/// `size` determines clip_from_view.
[[nodiscard]] Json info_json(const Mesh& mesh, NormalSource source = NormalSource::Auto);
[[nodiscard]] Json info_json(const Scene& scene, PictureSize size);

/// The output of `glint render --stats` for the last picture.
[[nodiscard]] Json stats_json(const Renderer& renderer, PictureSize size);

/// The output of `glint compare`.
[[nodiscard]] Json comparison_json(const Comparison& comparison);

/// The output of `glint profile`: a list for each column of profile_csv(), with null for missing values.
[[nodiscard]] Json profile_json(const std::vector<ProfileSample>& samples);

}  // namespace glint
