#pragma once
// How r comes about, step by step. Lecture: "Calculating R Vector": P is l's shadow on n, R = 2 P - L.

#include <glm/vec3.hpp>

namespace glint {

struct MirrorSteps {
    float n_dot_l = 0;
    glm::vec3 p{0}, twice_p{0}, r{0};  // n (n.l); 2 n (n.l); 2 n (n.l) - l
};

/// The equation's own r for a normal of any length: with |n| = k, p is k^2 times as long as it should be, and
/// r is not a mirror direction. n and l in one frame; the results are in it.
[[nodiscard]] MirrorSteps mirror_steps(glm::vec3 n, glm::vec3 l);

}  // namespace glint
