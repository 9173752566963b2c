#pragma once
// The stage between surface and lighting. Determines which lights reach each lit point, and the light that
// arrives there from other surfaces. Inputs: the surface, meshes and transforms, the lights' positions,
// `transport`, and for paths also the colours of lights and materials. Does nothing for the local model.

#include <functional>
#include <optional>
#include <vector>

#include "renderer/surface/surface.h"
#include "renderer/transport/paths.h"

namespace glint {

/// Called each time more paths have been traced for all points.
using PathProgress = std::function<void(int done, int all)>;

struct TransportStage {
    RayScene rays;
    TransportInputs inputs;
    std::vector<std::uint16_t> reached;  // [light][block] as in Arrivals
    std::vector<glm::dvec3> sums;        // of the paths' radiance at each lit point, 16 per block
    std::vector<ColorBlock> bounced;     // the means of the paths
    int paths = 0;                       // number of paths in `sums`
    bool any_shadow = false;             // whether `reached` is up to date with `inputs`

    /// The input of the lighting stage; nullopt for the local model.
    [[nodiscard]] std::optional<Arrivals> arrivals() const;
};

/// Whether the scene uses shadows or bounces: false for the local model and for an unlit scene.
[[nodiscard]] bool has_transport(const Scene& scene);

/// Runs the stage again if its inputs have changed; returns whether its results have changed. If only the
/// number of paths has increased, traces only the additional paths, with the same result as tracing all at
/// once. `surface_redone`: the lit points differ from those of the last call. `progress` may be empty. Throws
/// LoadCancelled soon after this thread's work has been cancelled (models/progress.h).
bool update_transport(TransportStage& kept, const Scene& scene, const Geometry& geometry,
                      const Visibility& visibility, const Surface& surface, bool surface_redone,
                      const PathProgress& progress);

/// A triangle that is visible in the picture.
struct VisibleTriangle {
    std::uint32_t object = 0, triangle = no_index;  // triangle: global number
    bool turned = false;                            // as in SampleFace
    RayFacet facet;
    std::array<glm::dvec3, 3> normals{};  // unit normals of the corners; unused with facet normals

    [[nodiscard]] bool is_of(const SampleFace& face) const {
        return object == face.object && triangle == face.triangle && turned == face.turned;
    }
};

/// Locates the picture's lit points on the triangles used for ray tracing. The references must outlive this
/// object.
struct LitPointFinder {
    const RayScene& rays;
    const Geometry& geometry;
    glm::dmat4 world_from_view;

    [[nodiscard]] VisibleTriangle triangle(const SurfaceInputs& surface, const SampleFace& face) const;
    /// The point of a pixel on a triangle or face. `pixel`: its number in the picture.
    [[nodiscard]] TracedPoint pixel(const SurfaceInputs& surface, const VisibleTriangle& triangle,
                                    std::size_t pixel, const PositionNormal& at) const;
    [[nodiscard]] TracedPoint pixel(const SurfaceInputs& surface, const SampleFace& face, std::size_t pixel,
                                    const PositionNormal& at) const {
        return this->pixel(surface, triangle(surface, face), pixel, at);
    }
    /// A lit corner or face (Gouraud or flat shading).
    [[nodiscard]] TracedPoint item(const SurfaceChoice& choice, const ShadingPoint& source,
                                   const PositionNormal& at) const;
};

}  // namespace glint
