#pragma once
// How much of an object's highlight its shading keeps: under flat and Gouraud shading it is lost where no
// corner lies under it. Lecture: Gouraud shading misses highlights.

#include <string>

#include "models/scene/scene.h"
#include "renderer/picture.h"
#include "ui/widgets/kept.h"

namespace glint {

/// The brightest specular light that the object shows in a picture of that size, as a share of what it shows
/// under Phong shading: 1 there; about 1 where triangles are small, and above it only by what a corner lies
/// nearer to the peak than a pixel's middle. Nothing without a highlight. `object`: in Scene::objects.
[[nodiscard]] std::optional<double> highlight_share(const Scene& scene, std::size_t object, PictureSize size);

/// That, kept until the scene changes and rests.
struct HighlightShareState {
    struct Key {
        Scene scene;
        std::size_t object = 0;
        bool operator==(const Key&) const = default;
    };
    Kept<Key, std::optional<double>> share;
};

/// The words beside a mesh; empty where pixels are lit rather than corners, and where
/// nothing shines.
[[nodiscard]] std::string highlight_words(HighlightShareState& state, const Scene& scene, std::size_t object,
                                          PictureSize size);

}  // namespace glint
