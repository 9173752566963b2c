#include "ui/export/animation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>
#include <optional>

#include "models/fields/scene_numbers.h"

namespace glint {
namespace {

/// 0 .. frames - 1.
int within_period(const Animation& animation, int frame) {
    const int period = std::max(animation.frames, 1);
    return ((frame % period) + period) % period;
}

Scene turned(Scene scene, double angle) {
    Camera& camera = scene.camera;
    const glm::dvec3 axis = glm::normalize(glm::dvec3(camera.up)), target(camera.target);
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), angle, axis);
    camera.eye = glm::vec3(target + glm::dvec3(turn * glm::dvec4(glm::dvec3(camera.eye) - target, 0)));
    return scene;
}

}  // namespace

double value_at(const Animation& animation, int frame) {
    const double share = double(within_period(animation, frame)) / std::max(animation.frames, 1);
    return animation.from + (animation.to - animation.from) * (1 - std::abs(1 - 2 * share));
}

Result<Scene> scene_at(const SceneDocument& document, const Animation& animation, int frame) {
    const int at = within_period(animation, frame);
    if (animation.motion == Motion::Turntable)
        return at == 0 ? document.scene
                       : turned(document.scene, 2 * std::numbers::pi * at / std::max(animation.frames, 1));
    Scene scene = document.scene;
    const std::optional<SceneNumber> number = number_at(scene, animation.pointer);
    const double value = value_at(animation, frame);
    if (const auto problem =
            set_number(scene, animation.pointer, number && number->is_whole ? std::round(value) : value))
        return *problem;
    const Result<Warnings> warned = load_meshes(scene, document.path, document.mesh_dir);
    if (const Problem* problem = problem_of(warned)) return *problem;
    return scene;
}

}  // namespace glint
