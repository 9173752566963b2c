// The rays behind the equation of the picked pixel: to the lights, and one path of bounced light.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "ui/features/inspector/equation/words.h"
#include "ui/features/inspector/inspector.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/ui.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// The end point for drawing a ray that hits nothing.
glm::dvec3 far_along(const PictureView& view, glm::vec3 from, glm::vec3 to) {
    return glm::dvec3(from) + 2 * view.dome.radius * glm::normalize(glm::dvec3(to - from));
}

void draw_ray(const WorldPen& pen, const TracedLight& ray, bool directional, ImU32 colour) {
    const glm::dvec3 light = directional ? far_along(pen.view, ray.from, ray.to) : glm::dvec3(ray.to);
    if (ray.reached()) return pen.cased(glm::dvec3(ray.from), light, colour, 1);
    pen.cased(glm::dvec3(ray.hit), light, colour, 0.3f, 0.8f);
    pen.cased(glm::dvec3(ray.from), glm::dvec3(ray.hit), colour, 1);
    pen.mark(glm::dvec3(ray.hit), colour, 1, true);
    const ProjectedPoint at = project(pen.view.map, glm::dvec3(ray.hit));
    if (!at.in_front) return;
    const ImVec2 place = pen.view.to_window(at.pixel);
    list_control("first hit", "", {place - px(1) * ImVec2(5, 5), place + px(1) * ImVec2(5, 5)});
}

void draw_path(const WorldPen& pen, const Scene& scene, const std::vector<PathStep>& path) {
    const ImU32 colour = to_u32(dark_theme()[Symbol::Ambient]);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const PathStep& step = path[i];
        const glm::dvec3 from(step.from), to(step.to);
        if (step.object < 0) {
            pen.cased(from, far_along(pen.view, step.from, step.to), colour, 0.4f, 0.8f);
            continue;
        }
        pen.cased(from, to, colour, 1);
        if (step.reached && static_cast<std::size_t>(step.light) < scene.lights.size()) {
            const Light& light = scene.lights[static_cast<std::size_t>(step.light)];
            pen.cased(to, handle_of(light, pen.view.dome, pen.view.map), to_u32(colour_of(light)), 0.5f,
                      0.8f);
        }
        pen.mark(to, colour, 1, false);
        const ProjectedPoint at = project(pen.view.map, to);
        if (at.in_front)
            rimmed_text(pen.list, pen.view.to_window(at.pixel) - ImVec2(0, px(12)), {1, 1, 1, 1},
                        std::to_string(i + 1));
    }
}

void path_rows(const Scene& scene, const std::vector<PathStep>& path) {
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const PathStep& step = path[i];
        const auto object = static_cast<std::size_t>(step.object),
                   light = static_cast<std::size_t>(step.light);
        if (object >= scene.objects.size()) {
            small_dim(fmt::format("{}  hits nothing: the path ends", i + 1));
            continue;
        }
        const glm::vec3 adds = step.throughput * (step.emission + step.direct);
        sum += adds;
        ImGui::TextUnformatted(whole_label(fmt::format("{}  {}", i + 1, scene.objects[object].name)).c_str());
        small_dim(fmt::format("throughput {}", shown_vector(step.throughput)));
        small_dim(fmt::format("adds {}", shown_vector(adds)));
        if (light < scene.lights.size())
            small_dim(
                fmt::format("{} {}", step.reached ? "lit by" : "not reached by", scene.lights[light].name));
    }
    small_dim(fmt::format("Light from this path: {}", shown_vector(sum)));
}

}  // namespace

void trace_shown(UiState& state) {
    const OnScreen& shown = state.on_screen;
    InspectorState& inspector = state.get<InspectorState>();
    if (shown.passing) return;  // the numbers remain those of the previous scene
    inspector.rays.clear();
    inspector.path.clear();
    const Renderer* renderer = shown.explained_by;
    if (inspector.tab != InspectorTab::Equation || renderer == nullptr || !shown.explanation ||
        !shown.explanation->hit)
        return;
    if (ImGui::IsAnyMouseDown() && !renderer->has_rays()) return;  // building them would delay a drag
    const Explanation& e = *shown.explanation;
    inspector.rays = renderer->shadow_rays(e.x, e.y, inspector.corner);
    if (inspector.shows_path && asked_point(inspector, e).bounces.used)
        inspector.path = renderer->bounce_path(e.x, e.y, inspector.path_number - 1, inspector.corner);
}

void draw_traced(ImDrawList& list, const UiState& state, const PictureView& view) {
    const InspectorState& inspector = state.get<InspectorState>();
    if (!state.on_screen.explanation || !state.on_screen.explanation->hit) return;
    const WorldPen pen{list, view};
    draw_path(pen, explained_scene(state), inspector.path);
    const std::vector<ExplainedLight>& lights = asked_point(inspector, *state.on_screen.explanation).lights;
    const ExplainedLight* light = asked_light(state, asked_point(inspector, *state.on_screen.explanation));
    if (!inspector.shows_ray || light == nullptr || lights.size() != inspector.rays.size()) return;
    draw_ray(pen, inspector.rays[static_cast<std::size_t>(light - lights.data())],
             light->samples.empty() && light->distance == 0, to_u32(dark_theme()[Symbol::L]));
}

void traced_controls(UiState& state, const ExplainedPoint& point) {
    InspectorState& inspector = state.get<InspectorState>();
    const ExplainedBounces& bounces = point.bounces;
    const int all = explained_scene(state).transport.paths;
    std::string text = fmt::format("Bounced light: {}", bounces.paths);
    text += bounces.paths < all  ? fmt::format(" of {} paths so far", all)
            : bounces.paths == 1 ? " path"
                                 : " paths";
    // One path has no variance.
    if (bounces.paths > 1) text += ", standard error " + shown_vector(bounces.standard_error);
    if (bounces.used) small_dim(text);
    inspector.shows_ray ^= small_chosen_button("Show the ray", inspector.shows_ray);
    tooltip("Show the ray", "From the point to the selected light, and what it hits first");
    if (!bounces.used) return;
    ImGui::SameLine();
    inspector.shows_path ^= small_chosen_button("Show a path", inspector.shows_path);
    tooltip("Show a path", "One of the random paths of bounced light, step by step");
    if (!inspector.shows_path) return;
    integer_field("Path", inspector.path_number, {1, bounces.paths}, 1, {"Which of the paths is shown", ""});
    inspector.path_number = std::clamp(inspector.path_number, 1, bounces.paths);
    path_rows(explained_scene(state), inspector.path);
}

}  // namespace glint
