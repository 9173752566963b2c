#include "ui/animate/animation.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>

#include "models/json_value.h"
#include "models/scene_variant.h"

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

void append_numbers(std::vector<MovableNumber>& numbers, const JsonValue& json, const std::string& pointer) {
    if (json.is_number()) {
        numbers.push_back({pointer, json.number()});
        return;
    }
    for (const auto& [name, value] : json.members())
        if (name != "glint") append_numbers(numbers, value, pointer + "/" + name);
    for (std::size_t i = 0; i < json.elements().size(); ++i)
        append_numbers(numbers, json.elements()[i], fmt::format("{}/{}", pointer, i));
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
    // Whole numbers where the scene has whole numbers: samples of an area light, the detail of a shape.
    const double value = value_at(animation, frame);
    const JsonValue scene = *JsonValue::parse(scene_text(document.scene));
    const JsonValue* old = scene.at_pointer(animation.pointer);
    const bool whole = old != nullptr && old->is_whole_number() &&
                       (animation.pointer.ends_with("/detail") || animation.pointer.ends_with("/samples"));
    const std::string text = whole ? std::to_string(std::lround(value)) : JsonValue(value).text();
    return scene_variant(document, {{animation.pointer, text}});
}

std::vector<MovableNumber> numbers_of(const Scene& scene) {
    std::vector<MovableNumber> numbers;
    append_numbers(numbers, *JsonValue::parse(scene_text(scene)), "");
    return numbers;
}

}  // namespace glint
