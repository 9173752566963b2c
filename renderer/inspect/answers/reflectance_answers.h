#pragma once
// What `glint lobe` and `glint microfacets` answer, as JSON (docs/interface.md).

#include <string>
#include <vector>

#include "models/json/json_value.h"
#include "renderer/inspect/reflectance/lobes.h"
#include "renderer/inspect/reflectance/microfacets.h"

namespace glint {

/// `glint lobe` of the object's material under the scene's reflection model and terms. `slice` is
/// lobe_slice() of that reflector and angle. Throws Refused where there is no memory for it.
[[nodiscard]] JsonValue lobe_json(const Reflector& reflector, const std::string& object, double light_deg,
                                  const std::vector<LobeSample>& slice);

/// `glint microfacets`; `lobe_rays` rays count its lobe in space. Throws Refused where there is no memory for
/// it.
[[nodiscard]] JsonValue microfacets_json(const MicrofacetOptions& options, int lobe_rays = 100000);

}  // namespace glint
