// Finds what blocks the line from the picked point to a light, under the local model, which ignores it.
#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "models/scene/transform.h"
#include "ui/features/inspector/equation/equation_tab.h"
#include "ui/features/inspector/inspector.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"

namespace glint {
namespace {

/// Whether the object only marks a light's position, with the light at its centre.
bool marks(const Object& object, glm::vec3 light) {
    const Bounds& box = object.mesh->bounds;
    const glm::vec3 middle =
        glm::vec3(world_from_object(object.transform) * glm::vec4((box.min + box.max) / 2.0f, 1));
    const float size = glm::length(object.transform.scale * (box.max - box.min));
    return glm::distance(middle, light) < 0.1f * size;
}

}  // namespace

std::string blocked_words(const UiState& state, const Explanation& explanation, std::size_t which) {
    const Scene& scene = explained_scene(state);
    const std::vector<TracedLight>& rays = state.get<InspectorState>().rays;
    // Under the other models, the light's own line names the object that casts the shadow.
    if (scene.transport.model != TransportModel::Local || which >= rays.size()) return "";
    const TracedLight& ray = rays[which];
    const auto blocker = static_cast<std::size_t>(ray.object);  // -1 becomes the largest value
    if (!ray.in_front || blocker >= scene.objects.size() || marks(scene.objects[blocker], ray.to)) return "";
    const std::string name = ray.object == explanation.object_index
                                 ? "Its own surface"
                                 : fmt::format("“{}”", scene.objects[blocker].name);
    return fmt::format(
        "{} is between this light and the point, but the local model lights each point on its own.", name);
}

}  // namespace glint
