#pragma once
// Colours to choose from: pure ones that a lecture reasons with, and those of lamps.

#include <glm/vec3.hpp>
#include <span>

namespace glint {

struct ColourPreset {
    const char* name;
    glm::vec3 linear;  // linear sRGB, the largest channel at most 1
    int kelvin = 0;    // of a lamp: the black body whose chromaticity this is; else 0
};

/// The lamps follow the others, from the warmest to the coldest.
[[nodiscard]] std::span<const ColourPreset> colour_presets();

}  // namespace glint
