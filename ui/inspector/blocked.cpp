#include "ui/inspector/blocked.h"

#include <fmt/core.h>
#include <imgui.h>

#include "renderer/inspect/debug_views/blocker.h"
#include "ui/ui.h"

namespace glint {
namespace {

/// Triangles times lights that are asked within a millisecond or two.
constexpr std::size_t at_once = 250'000;

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Object& object : scene.objects) count += object.mesh ? object.mesh->triangles.size() : 0;
    return count;
}

int blocker_index(const Scene& scene, const ExplainedPoint& point, const ExplainedLight& light) {
    const bool area = scene.lights[static_cast<std::size_t>(light.index)].kind == LightKind::Area;
    // Of an area light the middle sample speaks for all: a point light in the middle of the panel.
    const ExplainedLight& asked =
        area && !light.samples.empty() ? light.samples[light.samples.size() / 2] : light;
    if (!(asked.n_dot_l > 0)) return -1;
    return blocker(scene, point.point.world, asked.l.world, double(asked.distance)).value_or(-1);
}

void update(UiState& state, const Explanation& explanation, const ExplainedPoint& point) {
    BlockedState& blocked = state.inspector.blocked;
    const glm::ivec2 pixel(explanation.x, explanation.y);
    const int corner = state.inspector.corner;
    if (blocked.serial == state.picture_serial && blocked.pixel == pixel && blocked.corner == corner) return;
    blocked.by.clear();
    const Scene& scene = state.editor.scene();
    if (ImGui::IsAnyMouseDown() && triangle_count(scene) * point.lights.size() > at_once) return;
    for (const ExplainedLight& light : point.lights) blocked.by.push_back(blocker_index(scene, point, light));
    blocked.serial = state.picture_serial;
    blocked.pixel = pixel;
    blocked.corner = corner;
}

}  // namespace

std::string blocked_words(UiState& state, const Explanation& explanation, const ExplainedPoint& point,
                          std::size_t which) {
    update(state, explanation, point);
    const std::vector<int>& by = state.inspector.blocked.by;
    const Scene& scene = state.editor.scene();
    if (which >= by.size() || by[which] < 0) return "";
    const auto object = static_cast<std::size_t>(by[which]);
    if (object >= scene.objects.size()) return "";
    const std::string name =
        by[which] == explanation.object_index ? "Its own surface" : scene.objects[object].name;
    return fmt::format("{} stands in the way: no shadow, light here is local", name);
}

}  // namespace glint
