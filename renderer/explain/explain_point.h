#pragma once
// The lighting equation at one point, explained: for explain.cpp.

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "renderer/explain/explanation.h"
#include "renderer/lighting/light_job.h"
#include "renderer/simd/glm_vec3.h"
#include "renderer/stages.h"
#include "renderer/surface/surface.h"

namespace glint {

/// Returns the camera and the world coordinates of a vector or a position in camera coordinates.
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

/// What may be in the way of the lights of a picture. References must outlive it.
struct PointTransport {
    LitPointFinder points;
    const TransportInputs& inputs;
    const Scene& scene;
};

/// What reaches one point: everything, without a transport.
struct PointArrivals {
    const PointTransport* transport = nullptr;
    TracedPoint point = {};
};

/// Evaluates the equation at one point and keeps every step; the sum is added in the picture's own order.
/// Unless `lit`, only position, normal and view vector are filled in.
[[nodiscard]] ExplainedPoint explain_point(const Lighting& lighting, const LightJob& job,
                                           const PositionNormal& place, const Frames& frames, bool lit,
                                           const PointArrivals& arrivals);

}  // namespace glint
