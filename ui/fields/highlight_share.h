#pragma once
// Measures how much of an object's highlight its shading keeps: flat and Gouraud shading lose it where no
// corner lies under it. Lecture: Gouraud shading misses highlights.

#include <string>

#include "models/scene/scene.h"
#include "renderer/picture.h"
#include "ui/widgets/kept.h"

namespace glint {

/// Returns the object's brightest specular light in a picture of that size, relative to Phong shading: about
/// 1 if triangles are small, and above 1 only by as much as a corner lies nearer to the peak than a pixel's
/// middle. Nothing if there is no highlight. `object`: index in Scene::objects.
[[nodiscard]] std::optional<double> highlight_share(const Scene& scene, std::size_t object, PictureSize size);

/// That share, cached until the scene changes and rests.
struct HighlightShareState {
    struct Key {
        Scene scene;
        std::size_t object = 0;
        bool operator==(const Key&) const = default;
    };
    Kept<Key, std::optional<double>> share;
};

/// Says the share beside a mesh; empty if pixels are lit rather than corners, or if nothing shines.
[[nodiscard]] std::string highlight_words(HighlightShareState& state, const Scene& scene, std::size_t object,
                                          PictureSize size);

}  // namespace glint
