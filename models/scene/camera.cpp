#include "models/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "models/numbers.h"

namespace glint {
namespace {

struct Axes {
    glm::dvec3 u, v, w;  // right, up, backwards: unit vectors in world coordinates
};

Axes camera_axes(const Camera& camera) {
    const glm::dvec3 w = glm::normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
    const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(camera.up), w));
    return {u, glm::cross(w, u), w};
}

}  // namespace

glm::dmat4 view_from_world(const Camera& camera) {
    const Axes a = camera_axes(camera);
    const glm::dvec3 eye(camera.eye);
    return {{a.u.x, a.v.x, a.w.x, 0},
            {a.u.y, a.v.y, a.w.y, 0},
            {a.u.z, a.v.z, a.w.z, 0},
            {-glm::dot(a.u, eye), -glm::dot(a.v, eye), -glm::dot(a.w, eye), 1}};
}

glm::dmat4 world_from_view(const Camera& camera) {
    const Axes a = camera_axes(camera);
    return {{a.u, 0}, {a.v, 0}, {a.w, 0}, {glm::dvec3(camera.eye), 1}};
}

Projection fitted(const Projection& projection, PictureSize size) {
    constexpr double widest_deg = 179.9;
    const double aspect = static_cast<double>(size.width) / size.height;
    if (!is_widened(size)) return projection;
    Projection shown = projection;
    if (auto* p = std::get_if<Perspective>(&shown)) {
        const double half = std::tan(p->fov_y_deg * std::numbers::pi / 360) * composed_aspect / aspect;
        const double fov_y_deg = std::min(std::atan(half) * 360 / std::numbers::pi, widest_deg);
        p->fov_y_deg = std::max(static_cast<float>(fov_y_deg), p->fov_y_deg);
    } else if (auto* o = std::get_if<Orthographic>(&shown)) {
        o->height = static_cast<float>(std::min(o->height * composed_aspect / aspect, max_number));
    }
    return shown;
}

glm::dmat4 clip_from_view(const Projection& as_written, PictureSize size) {
    const Projection projection = fitted(as_written, size);
    const double aspect = static_cast<double>(size.width) / size.height;
    if (const auto* p = std::get_if<Perspective>(&projection)) {
        const double top = p->near * std::tan(p->fov_y_deg * std::numbers::pi / 360);
        return glm::frustumRH_NO<double>(-top * aspect, top * aspect, -top, top, p->near, p->far);
    }
    if (const auto* o = std::get_if<Orthographic>(&projection)) {
        const double top = o->height / 2.0;
        return glm::orthoRH_NO<double>(-top * aspect, top * aspect, -top, top, o->near, o->far);
    }
    const auto& f = std::get<Frustum>(projection);
    return glm::frustumRH_NO<double>(f.left, f.right, f.bottom, f.top, f.near, f.far);
}

}  // namespace glint
