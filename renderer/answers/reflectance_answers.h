#pragma once
// The JSON output of `glint lobe` and `glint microfacets` (docs/command_line.md).

#include <string>
#include <vector>

#include "models/json/json.h"
#include "renderer/reflectance/lobes.h"
#include "renderer/reflectance/microfacets.h"

namespace glint {

/// The output of `glint lobe` for the object's material with the scene's reflection model and terms. `slice`
/// is lobe_slice() for the same reflector and angle.
[[nodiscard]] Json lobe_json(const Reflector& reflector, const std::string& object, double light_deg,
                             const std::vector<LobeSample>& slice);

/// The output of `glint microfacets`. `lobe_rays`: number of rays for sampling the lobe in space.
[[nodiscard]] Json microfacets_json(const MicrofacetOptions& options, int lobe_rays = 100000);

}  // namespace glint
