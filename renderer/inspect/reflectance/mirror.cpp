#include "renderer/inspect/reflectance/mirror.h"

#include "renderer/lighting/surface_point.h"

namespace glint {

MirrorSteps mirror_steps(glm::vec3 n, glm::vec3 l) {
    const PointAt<float> at{{}, {n.x, n.y, n.z}, {}};
    const Directions<float> d = directions_for(Vec3<float>{l.x, l.y, l.z}, at);
    MirrorSteps steps;
    steps.n_dot_l = d.n_dot_l;
    steps.r = {d.r.x, d.r.y, d.r.z};
    steps.twice_p = steps.r + l;  // back from r, so that the formula stands once
    steps.p = 0.5f * steps.twice_p;
    return steps;
}

}  // namespace glint
