#pragma once
// The camera of another program's picture, estimated from silhouettes.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/search/probes.h"

namespace glint {

/// How another program's camera differs from the scene's.
struct CameraDifference {
    glm::dvec2 scale{1};   // of the picture about its centre, horizontally and vertically
    glm::dvec2 shift{0};   // after scaling, in pixels to the right and down
    glm::dvec3 eye{0};     // how far eye and target are moved, in camera coordinates
    bool is_small = true;  // at most a twentieth of the picture, or of the distance to the target
    Camera camera;         // the scene's, with this difference

    [[nodiscard]] bool is_field_of_view() const;  // nothing but the field of view differs
    [[nodiscard]] bool is_stretched() const { return scale.x != scale.y; }
};

/// Returns the difference under which the scene's silhouettes match those of the picture. Returns nothing if
/// they agree already, if they are not visible or drawn with strokes, or if no difference makes them match.
[[nodiscard]] std::optional<CameraDifference> camera_difference(Renderer& renderer, const Scene& right,
                                                                const Picture& wrong,
                                                                const std::vector<PixelKind>& kinds);

/// "your field of view is 51.0°, the scene's is 45.0°".
[[nodiscard]] std::string camera_text(const CameraDifference& difference, const Camera& scene,
                                      PictureSize size);

}  // namespace glint
