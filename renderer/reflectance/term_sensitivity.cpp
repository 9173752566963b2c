#include "renderer/reflectance/term_sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <vector>

#include "renderer/lighting/illuminate.h"
#include "renderer/reflectance/lobes.h"
#include "renderer/shade/light_sources.h"
#include "renderer/simd/glm_vec3.h"
#include "renderer/simd/vec3.h"

namespace glint {
namespace {

constexpr double turn = std::numbers::pi / 180;  // one degree

/// Two unit vectors perpendicular to `a` and to each other.
std::array<glm::dvec3, 2> across(glm::dvec3 a) {
    const Vec3<double> p = any_perpendicular(Vec3<double>{a.x, a.y, a.z});
    const glm::dvec3 first(p.x, p.y, p.z);
    return {first, glm::cross(a, first)};
}

/// The three terms for these vectors in the frame where n is (0, 0, 1).
std::array<glm::vec3, 3> terms(const Reflector& reflector, glm::dvec3 n, glm::dvec3 l, glm::dvec3 v) {
    const auto [x, y] = across(n);
    const glm::dmat3 local = glm::transpose(glm::dmat3(x, y, n));
    const Reflected r = reflected(reflector, glm::vec3(local * l), glm::vec3(local * v));
    return {r.ambient, r.diffuse, r.specular};
}

float largest(glm::vec3 d) { return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}); }

/// The relative change that rounding may cause in a term that is independent of a vector.
constexpr float rounding = 2e-6f;

}  // namespace

std::array<TermSensitivity, 3> term_sensitivity(const Reflector& reflector, glm::vec3 n, glm::vec3 l,
                                                glm::vec3 v) {
    const std::array<glm::dvec3, 3> vectors{glm::dvec3(n), glm::dvec3(l), glm::dvec3(v)};
    const auto now = terms(reflector, vectors[0], vectors[1], vectors[2]);
    std::array<TermSensitivity, 3> sensitivity;
    constexpr std::array members{&TermSensitivity::normal, &TermSensitivity::light, &TermSensitivity::viewer};
    for (std::size_t which = 0; which < vectors.size(); ++which)
        for (const glm::dvec3 side : across(vectors[which])) {
            auto turned = vectors;
            turned[which] = std::cos(turn) * vectors[which] + std::sin(turn) * side;
            const auto then = terms(reflector, turned[0], turned[1], turned[2]);
            for (std::size_t term = 0; term < now.size(); ++term) {
                const float moved = largest(then[term] - now[term]);
                float& need = sensitivity[term].*members[which];
                if (moved > rounding * largest(now[term])) need = std::max(need, moved);
            }
        }
    return sensitivity;
}

namespace {

using Vec = Vec3<float>;
constexpr float step = 0.1f;                                  // relative change of a distance
constexpr float turn_step = std::numbers::pi_v<float> / 180;  // one degree

std::array<Vec, 2> across(Vec a) {
    const Vec first = any_perpendicular(a);
    return {first, cross(a, first)};
}

struct TwoTerms {
    Vec diffuse, specular;
};

/// The sum of the terms over all sources.
TwoTerms terms_of(const LightAlone& lit, const PointAt<float>& at) {
    TwoTerms sum;
    for (const LightSource& source : lit.sources()) {
        const LightTerms<float> t = lit.terms(source, at);
        sum.diffuse = sum.diffuse + t.diffuse;
        sum.specular = sum.specular + t.specular;
    }
    return sum;
}

float largest(Vec a, Vec b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

}  // namespace

LightSensitivity light_sensitivity(const Scene& scene, PictureSize size, const Light& light,
                                   const Material& material, glm::vec3 place, glm::vec3 normal) {
    const LightAlone lit(scene, size, light, material);
    const Vec p = to_vec(place), n = to_vec(normal);
    const PointAt<float> at = lit.seen(place, normal);
    const TwoTerms now = terms_of(lit, at);
    const LightTerms<float> middle = lit.middle(at);
    LightSensitivity sensitivity;
    sensitivity.falloff = middle.falloff;
    sensitivity.spot = middle.spot;
    const auto note = [&](float Moved::*what, const PointAt<float>& then_at) {
        const TwoTerms then = terms_of(lit, then_at);
        sensitivity.diffuse.*what = std::max(sensitivity.diffuse.*what, largest(then.diffuse, now.diffuse));
        sensitivity.specular.*what =
            std::max(sensitivity.specular.*what, largest(then.specular, now.specular));
    };
    // A directional light has no distance; uses the distance to the eye instead.
    const bool has_place = light.kind != LightKind::Directional;
    const float eye = square_root(dot(p, p)), away = step * (has_place ? middle.distance : eye);
    const Vec l = middle.directions.l;
    for (const Vec way : {l, -1.0f * l, across(l)[0], across(l)[1]})
        note(&Moved::light, PointAt<float>(p + away * way, n, at.v));
    for (const Vec way : across(unit(p)))
        note(&Moved::viewer, PointAt<float>(p, n, lit.seen(to_glm(p + step * eye * way), normal).v));
    for (const Vec way : across(n))
        note(&Moved::surface,
             PointAt<float>(p, unit(std::cos(turn_step) * n + std::sin(turn_step) * way), at.v));
    return sensitivity;
}

}  // namespace glint
