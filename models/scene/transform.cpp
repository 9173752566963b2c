#include "models/scene/transform.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

namespace glint {
namespace {

/// The matrix of a single step, rotation or scale, without the translation.
glm::dmat3 linear_part(const Transform& written, TransformStep step) {
    Transform alone;
    if (step == TransformStep::Rotate) alone.rotate_deg = written.rotate_deg;
    if (step == TransformStep::Scale) alone.scale = written.scale;
    return {world_from_object(alone)};
}

bool are_alike(const glm::dmat3& a, const glm::dmat3& b, double size) {
    constexpr double error = 1e-9;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (!(std::abs(a[c][r] - b[c][r]) <= error * size)) return false;
    return true;
}

}  // namespace

glm::dmat4 world_from_object(const Transform& transform) {
    const glm::dvec3 angle = glm::radians(glm::dvec3(transform.rotate_deg));
    glm::dmat4 m = glm::translate(glm::dmat4(1.0), glm::dvec3(transform.translate));
    m = glm::rotate(m, angle.z, {0, 0, 1});
    m = glm::rotate(m, angle.y, {0, 1, 0});
    m = glm::rotate(m, angle.x, {1, 0, 0});
    return glm::scale(m, glm::dvec3(transform.scale));
}

std::optional<Transform> in_file_order(const Transform& written, const TransformOrder& order) {
    const glm::dmat3 rotate = linear_part(written, TransformStep::Rotate);
    const glm::dmat3 scale = linear_part(written, TransformStep::Scale);
    glm::dmat3 linear(1), before_translate(1);
    for (const TransformStep step : order) {
        if (step == TransformStep::Translate) before_translate = linear;
        linear = linear * linear_part(written, step);
    }
    const glm::dvec3 s = glm::abs(glm::dvec3(written.scale));
    if (!are_alike(linear, rotate * scale, s.x + s.y + s.z)) return std::nullopt;
    Transform transform = written;
    transform.translate = glm::vec3(before_translate * glm::dvec3(written.translate));
    return transform;
}

}  // namespace glint
