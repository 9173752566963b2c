#pragma once
// The JSON output of commands about scenes and pictures. Shared by the command line, lesson claims and the
// window, so that they agree. docs/command_line.md documents the fields.

#include <string>
#include <vector>

#include "models/json/json.h"
#include "models/mesh/mesh.h"
#include "models/scene/scene.h"
#include "renderer/debug_views/profile.h"
#include "renderer/image/compare.h"
#include "renderer/reflectance/lobes.h"
#include "renderer/reflectance/microfacets.h"
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

// The JSON output of `glint lobe` and `glint microfacets` (docs/command_line.md).

/// The output of `glint lobe` for the object's material with the scene's reflection model and terms. `slice`
/// is lobe_slice() for the same reflector and angle.
[[nodiscard]] Json lobe_json(const Reflector& reflector, const std::string& object, double light_deg,
                             const std::vector<LobeSample>& slice);

/// The output of `glint microfacets`. `lobe_rays`: number of rays for sampling the lobe in space.
[[nodiscard]] Json microfacets_json(const MicrofacetOptions& options, int lobe_rays = 100000);

}  // namespace glint
