// What blocks the line from the picked point to a light.
#include <fmt/core.h>
#include <imgui.h>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "models/scene/transform.h"
#include "renderer/debug_views/blocker.h"
#include "ui/features/inspector/equation/equation_tab.h"
#include "ui/features/inspector/inspector.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"

namespace glint {
namespace {

/// Triangles times lights that can be tested within a millisecond or two.
constexpr std::size_t at_once = 250'000;

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Object& object : scene.objects) count += object.mesh ? object.mesh->triangles.size() : 0;
    return count;
}

/// Whether the object only marks a light's position: the light is in its centre.
bool marks(const Object& object, glm::vec3 light) {
    const Bounds& box = object.mesh->bounds;
    const glm::vec3 middle =
        glm::vec3(world_from_object(object.transform) * glm::vec4((box.min + box.max) / 2.0f, 1));
    const float size = glm::length(object.transform.scale * (box.max - box.min));
    return glm::distance(middle, light) < 0.1f * size;
}

/// The object between the point and the light, or -1.
int blocker_index(const Scene& scene, const ExplainedPoint& point, const ExplainedLight& light) {
    const bool area = scene.lights[static_cast<std::size_t>(light.index)].kind == LightKind::Area;
    // The middle sample of an area light represents all: a point light in the centre of the panel.
    const ExplainedLight& asked =
        area && !light.samples.empty() ? light.samples[light.samples.size() / 2] : light;
    if (!(asked.n_dot_l > 0)) return -1;
    const int found = blocker(scene, point.point.world, asked.l.world, double(asked.distance)).value_or(-1);
    const glm::vec3 place = point.point.world + asked.distance * asked.l.world;
    return found >= 0 && marks(scene.objects[static_cast<std::size_t>(found)], place) ? -1 : found;
}

/// Per light of the point.
std::vector<int> blocker_indices(const Scene& scene, const ExplainedPoint& point) {
    std::vector<int> all;
    for (const ExplainedLight& light : point.lights) all.push_back(blocker_index(scene, point, light));
    return all;
}

}  // namespace

std::string blocked_words(UiState& state, const Explanation& explanation, const ExplainedPoint& point,
                          std::size_t which) {
    const Scene& scene = explained_scene(state);
    const BlockedKey key{
        state.picture_serial, {explanation.x, explanation.y}, state.get<InspectorState>().corner};
    auto& blocked = state.get<InspectorState>().blocked;
    const bool slow = triangle_count(scene) * point.lights.size() > at_once;
    if (slow && ImGui::IsAnyMouseDown() && !blocked.is_of(key)) return "";
    const std::vector<int>& by = blocked.of(key, [&] { return blocker_indices(scene, point); });
    if (which >= by.size() || by[which] < 0) return "";
    const auto object = static_cast<std::size_t>(by[which]);
    if (object >= scene.objects.size()) return "";
    const std::string name = by[which] == explanation.object_index
                                 ? "Its own surface"
                                 : fmt::format("“{}”", scene.objects[object].name);
    return fmt::format(
        "{} is between this light and the point, but Glint casts no shadows: each point is lit on its own.",
        name);
}

}  // namespace glint
