#pragma once
// Simulates a drag, frame by frame, for benchmarks.

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "models/scene/scene.h"

namespace glint {

enum class Drag { Light, Material, Camera, Object };

/// Sets the dragged part of `scene` to its state at `frame`, starting from `start`; consecutive frames always
/// differ. Moves the first light or object along a circle. Precondition: the scene has one.
inline void drag_to(Scene& scene, const Scene& start, Drag drag, int frame) {
    const auto turn = 0.1f * static_cast<float>(frame);
    const glm::vec3 circle{std::cos(turn), std::sin(turn), 0};
    switch (drag) {
    case Drag::Light: {
        const glm::vec4 at = start.lights.front().position;
        const float reach = 0.1f * (glm::length(glm::vec3(at)) + at.w);
        scene.lights.front().position = at + glm::vec4(reach * circle, 0);
        break;
    }
    case Drag::Material:
        scene.objects.front().material.diffuse = glm::vec3(0.5f + 0.4f * circle.x);
        break;
    case Drag::Camera: {
        const Camera& camera = start.camera;
        const glm::dmat4 turned = glm::rotate(glm::dmat4(1), 0.1 * frame, glm::dvec3(camera.up));
        const glm::dvec4 arm{glm::dvec3(camera.eye) - glm::dvec3(camera.target), 0};
        scene.camera.eye = glm::vec3(glm::dvec3(camera.target) + glm::dvec3(turned * arm));
        break;
    }
    case Drag::Object: {
        const glm::vec3 at = start.objects.front().transform.translate;
        const float reach = 0.02f * glm::distance(start.camera.eye, start.camera.target);
        scene.objects.front().transform.translate = at + reach * circle;
        break;
    }
    }
}

}  // namespace glint
