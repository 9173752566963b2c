#include "renderer/inspect/reflectance/needs.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "renderer/simd/double_lanes.h"
#include "renderer/simd/vec3.h"

namespace glint {
namespace {

constexpr double turn = std::numbers::pi / 180;  // one degree

/// Two unit vectors across `a` and each other.
std::array<glm::dvec3, 2> across(glm::dvec3 a) {
    const Vec3<double> p = any_perpendicular(Vec3<double>{a.x, a.y, a.z});
    const glm::dvec3 first(p.x, p.y, p.z);
    return {first, glm::cross(a, first)};
}

/// What the three terms are for these vectors, in the frame in which n is (0, 0, 1).
std::array<glm::vec3, 3> terms(const Reflector& reflector, glm::dvec3 n, glm::dvec3 l, glm::dvec3 v) {
    const auto [x, y] = across(n);
    const glm::dmat3 local = glm::transpose(glm::dmat3(x, y, n));
    const Reflected r = reflected(reflector, glm::vec3(local * l), glm::vec3(local * v));
    return {r.ambient, r.diffuse, r.specular};
}

float largest(glm::vec3 d) { return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}); }

/// What rounding in the change of frame may do to a term that stays; a share of the term.
constexpr float rounding = 2e-6f;

}  // namespace

std::array<Needs, 3> term_needs(const Reflector& reflector, glm::vec3 n, glm::vec3 l, glm::vec3 v) {
    const std::array<glm::dvec3, 3> vectors{glm::dvec3(n), glm::dvec3(l), glm::dvec3(v)};
    const auto now = terms(reflector, vectors[0], vectors[1], vectors[2]);
    std::array<Needs, 3> needs;
    constexpr std::array members{&Needs::normal, &Needs::light, &Needs::viewer};
    for (std::size_t which = 0; which < vectors.size(); ++which)
        for (const glm::dvec3 side : across(vectors[which])) {
            auto turned = vectors;
            turned[which] = std::cos(turn) * vectors[which] + std::sin(turn) * side;
            const auto then = terms(reflector, turned[0], turned[1], turned[2]);
            for (std::size_t term = 0; term < now.size(); ++term) {
                const float moved = largest(then[term] - now[term]);
                float& need = needs[term].*members[which];
                if (moved > rounding * largest(now[term])) need = std::max(need, moved);
            }
        }
    return needs;
}

}  // namespace glint
