#pragma once
// Explains the lighting equation at one point. Used by explain.cpp.

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "renderer/explain/explanation.h"
#include "renderer/lighting/light_job.h"
#include "renderer/simd/glm_vec3.h"
#include "renderer/stages.h"
#include "renderer/surface/surface.h"

namespace glint {

/// Converts a vector or position in camera coordinates to InBothFrames.
class Frames {
  public:
    explicit Frames(const Camera& camera) : world_from_view_(world_from_view(camera)) {}
    [[nodiscard]] InBothFrames direction(Vec3<float> v) const { return both_frames(to_glm(v), 0); }
    [[nodiscard]] InBothFrames position(Vec3<float> v) const { return both_frames(to_glm(v), 1); }

  private:
    [[nodiscard]] InBothFrames both_frames(glm::vec3 v, double w) const {
        return {v, glm::vec3(world_from_view_ * glm::dvec4(glm::dvec3(v), w))};
    }
    glm::dmat4 world_from_view_;
};

/// The inputs for shadow rays and paths. The references must outlive this object.
struct PointTransport {
    LitPointFinder points;
    const TransportInputs& inputs;
    const Scene& scene;
};

/// The light that arrives at a point. Without a transport, nothing is blocked.
struct PointArrivals {
    const PointTransport* transport = nullptr;
    TracedPoint point = {};
};

/// Evaluates the equation at one point and records every step; adds the sum in the same order as the picture.
/// Unless `lit`, fills in only position, normal and view vector.
[[nodiscard]] ExplainedPoint explain_point(const Lighting& lighting, const LightJob& job,
                                           const PositionNormal& place, const Frames& frames, bool lit,
                                           const PointArrivals& arrivals);

}  // namespace glint
