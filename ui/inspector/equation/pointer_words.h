#pragma once
// A JSON pointer of the scene file in words, and the panel in which its number stands.

#include <string>

#include "ui/document/scene_edit.h"

namespace glint {

struct NamedNumber {
    std::string owner;  // "Bulb", "Teapot", "Camera"
    std::string what;   // "position x", "diffuse red", "falloff quadratic"; empty for the whole owner
    Selection selection;
};

/// Of a number of this scene, or of a whole object. Pointers into nothing keep their text.
[[nodiscard]] NamedNumber named_number(const std::string& pointer, const Scene& scene);

}  // namespace glint
