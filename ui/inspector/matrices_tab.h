#pragma once
// The matrices of the camera with their numbers, and what they do: each light's position carried into camera
// coordinates, the picked point on its way from the mesh to its pixel, with lighting's place marked.

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "models/scene/camera.h"
#include "models/scene/light.h"

namespace glint {

struct UiState;
struct PictureView;

void matrices_tab(UiState& state, const PictureView& view);

/// A light's position in both frames, w as in the scene: a direction stays a direction.
struct CarriedLight {
    glm::dvec4 world{0}, camera{0};
};
[[nodiscard]] CarriedLight carried(const Light& light, const Camera& camera);

}  // namespace glint
