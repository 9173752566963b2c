#pragma once
// The stage between surface and lighting: which lights reach each lit point, and the light that arrives there
// from other surfaces. Inputs: the surface, meshes and transforms, the lights' positions, `transport`, and
// for paths also the lights' and the materials' colours. Does nothing for the local model.

#include <functional>
#include <optional>
#include <vector>

#include "renderer/surface/surface.h"
#include "renderer/transport/paths.h"

namespace glint {

/// Called after some paths of all points.
using PathProgress = std::function<void(int done, int all)>;

struct TransportStage {
    RayScene rays;
    TransportInputs inputs;
    std::vector<std::uint16_t> reached;  // [light][block] as in Arrivals
    std::vector<glm::dvec3> sums;        // of the paths' radiance at each lit point, 16 per block
    std::vector<ColorBlock> bounced;     // their means
    int paths = 0;                       // that `sums` contain
    bool any_shadow = false;             // `reached` is up to date with `inputs`

    /// For the lighting stage: nothing for the local model.
    [[nodiscard]] std::optional<Arrivals> arrivals() const;
};

/// Whether light is transported in the scene: not for the local model, and not without a reflection model.
[[nodiscard]] bool has_transport(const Scene& scene);

/// Runs the stage again if its inputs differ; returns whether its results did. With more paths than before
/// and otherwise equal inputs, only the further paths are followed, with the same result as all at once.
/// `surface_redone`: the lit points are not those of the last call. `progress` may be empty. Throws
/// LoadCancelled soon after this thread's work was cancelled (models/progress.h).
bool update_transport(TransportStage& kept, const Scene& scene, const Geometry& geometry,
                      const Visibility& visibility, const Surface& surface, bool surface_redone,
                      const PathProgress& progress);

/// Finds the picture's lit points on the triangles of the rays. References must outlive it.
struct LitPointFinder {
    const RayScene& rays;
    const Geometry& geometry;
    glm::dmat4 world_from_view;

    /// The point of a pixel of a face; `pixel`: its number in the picture.
    [[nodiscard]] TracedPoint pixel(const SurfaceInputs& surface, const SampleFace& face, std::size_t pixel,
                                    const PositionNormal& at) const;
    /// A lit corner or face (Gouraud, flat).
    [[nodiscard]] TracedPoint item(const SurfaceChoice& choice, const ShadingPoint& source,
                                   const PositionNormal& at) const;
};

}  // namespace glint
