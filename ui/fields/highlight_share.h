#pragma once
// Measures how much of an object's highlight survives its shading: flat and Gouraud shading lose a highlight
// that covers no vertex. Lecture: Gouraud shading misses highlights.

#include <string>

#include "models/scene/scene.h"
#include "renderer/picture.h"
#include "ui/widgets/kept.h"

namespace glint {

/// Returns the object's brightest specular light in a picture of that size, relative to Phong shading: about
/// 1 if triangles are small. It exceeds 1 only slightly, when a vertex is closer to the peak than any pixel
/// centre. Nothing without a highlight. `object`: index in Scene::objects.
[[nodiscard]] std::optional<double> highlight_share(const Scene& scene, std::size_t object, PictureSize size);

/// highlight_share(), cached until the scene changes and settles.
struct HighlightShareState {
    struct Key {
        Scene scene;
        std::size_t object = 0;
        bool operator==(const Key&) const = default;
    };
    Kept<Key, std::optional<double>> share;
};

/// Returns the share as a note next to a mesh; empty if lighting is computed per pixel, or without a
/// highlight.
[[nodiscard]] std::string highlight_words(HighlightShareState& state, const Scene& scene, std::size_t object,
                                          PictureSize size);

}  // namespace glint
