#include "ui/picture/camera_views.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "ui/document/limits.h"
#include "ui/fields/camera_panel.h"
#include "ui/picture/orbit.h"

namespace glint {
namespace {

glm::dvec3 way_to_eye(ViewFrom from) {
    constexpr double off_pole = 2e-3;  // a tenth of a degree
    switch (from) {
    case ViewFrom::Front:
        return {0, 0, 1};
    case ViewFrom::Back:
        return {0, 0, -1};
    case ViewFrom::Right:
        return {1, 0, 0};
    case ViewFrom::Left:
        return {-1, 0, 0};
    case ViewFrom::Top:
        return {0, 1, off_pole};
    case ViewFrom::Bottom:
        return {0, -1, off_pole};
    }
    return {0, 0, 1};  // not reached
}

}  // namespace

Camera seen_from(Camera camera, ViewFrom from) {
    const Camera before = camera;
    const glm::dvec3 way = glm::normalize(way_to_eye(from));
    camera.eye = glm::vec3(glm::dvec3(camera.target) + target_depth(camera) * way);
    camera.up = {0, 1, 0};
    return violation_of(camera) ? before : camera;
}

Camera other_projection(Camera camera, PictureSize size) {
    camera.projection = as_projection(
        camera,
        is_orthographic(camera.projection) ? ProjectionKind::Perspective : ProjectionKind::Orthographic,
        size);
    return camera;
}

void keep_view(std::vector<Camera>& views, const Camera& camera) {
    if (std::find(views.begin(), views.end(), camera) != views.end()) return;
    views.push_back(camera);
    if (views.size() > most_views) views.erase(views.begin());
}

std::optional<Camera> next_view(const std::vector<Camera>& views, const Camera& shown) {
    if (views.empty()) return {};
    const auto at = std::find(views.begin(), views.end(), shown);
    return at == views.end() || at + 1 == views.end() ? views.front() : *(at + 1);
}

}  // namespace glint
