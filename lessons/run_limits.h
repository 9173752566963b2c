#pragma once
// Maximum angles between the normal and the light or viewer of a run, in degrees. At 90 a surface receives no
// light.

namespace glint {

inline constexpr double max_lobe_deg = 89.9;       // of the light of `lobe`
inline constexpr double max_microfacets_deg = 89;  // of light and viewer of `microfacets`

}  // namespace glint
