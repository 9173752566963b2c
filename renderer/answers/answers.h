#pragma once
// The commands' JSON about scenes and pictures. The command line, the claims of lessons and the window share
// it, so that they agree. docs/command_line.md names the fields.

#include <vector>

#include "models/json/json.h"
#include "models/mesh/mesh.h"
#include "models/scene/scene.h"
#include "renderer/debug_views/profile.h"
#include "renderer/image/compare.h"
#include "renderer/renderer.h"

namespace glint {

/// `glint info` of a mesh with the normals of `source`, and of a scene whose meshes are loaded; `size` is for
/// clip_from_view.
[[nodiscard]] Json info_json(const Mesh& mesh, NormalSource source = NormalSource::Auto);
[[nodiscard]] Json info_json(const Scene& scene, PictureSize size);

/// `glint render --stats` of the last picture.
[[nodiscard]] Json stats_json(const Renderer& renderer, PictureSize size);

/// `glint compare`.
[[nodiscard]] Json comparison_json(const Comparison& comparison);

/// `glint profile`: a list for each column of profile_csv(), with null for a sample that lacks the value.
[[nodiscard]] Json profile_json(const std::vector<ProfileSample>& samples);

}  // namespace glint
