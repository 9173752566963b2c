#pragma once
// How far light and viewer of a run may lean from the normal, in degrees. At 90 a surface catches nothing.

namespace glint {

inline constexpr double max_lobe_deg = 89.9;       // of the light of `lobe`
inline constexpr double max_microfacets_deg = 89;  // of light and viewer of `microfacets`

}  // namespace glint
