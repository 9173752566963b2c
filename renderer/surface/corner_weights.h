#pragma once
// Weighs the corners of a face at a pixel, under the three ways of interpolating. Lecture: "Gouraud Shading",
// "Gouraud Shading Artifacts", "Shading Artifacts: Orientation".

#include <array>
#include <cstdint>

#include "renderer/visibility/visibility.h"

namespace glint {

/// A place on the screen in pixels, y down, (0, 0) the picture's upper left corner.
struct PixelPosition {
    float x = 0, y = 0;
};

/// One visible sample: the face it shows and the weights of its drawn triangle's corners.
struct SampleFace {
    PixelPosition at;
    std::uint32_t object = 0, triangle = 0;  // triangle: global number
    bool turned = false;                     // two_sided and seen from behind
    glm::vec3 weights{0};                    // perspective-correct
    glm::vec3 p{0};                          // where the pixel's ray meets the face, camera coordinates
};

/// Weights of some corners of a mesh; the rest count nothing. At most eight: a scanline meets two edges, and
/// where the near plane cuts the polygon each end of an edge may lie between two corners.
struct CornerWeights {
    static constexpr int most = 8;
    int count = 0;
    std::array<std::uint32_t, most> corner{};  // indices into Mesh::corner_position
    std::array<float, most> weight{};

    /// Adds a weight; a corner already listed keeps one entry.
    void add(std::uint32_t which, float w);
};

/// Fills in `weights` and `p` of the triangle seen at `face.at`.
void locate_on_face(SampleFace& face, const Geometry& geometry);

/// `perspective`: of the drawn triangle's corners, correct in space. `screen`: linear on the screen over the
/// drawn triangle. `scanline`: along the polygon's edges on the screen, then along the scanline between them.
/// Under the last two a face cut by the near plane is clipped first; its new corners get perspective-correct
/// values.
[[nodiscard]] CornerWeights corner_weights(Interpolation interpolation, const Geometry& geometry,
                                           const SampleFace& face);

}  // namespace glint
