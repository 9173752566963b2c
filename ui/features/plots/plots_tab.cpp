#include "ui/features/plots/plots_tab.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "ui/features/inspector/inspector.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

double degrees_of(double cosine) { return glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))); }

const ExplainedPoint& heaviest(const Explanation& explanation) {
    if (!explanation.lit_per_corner || explanation.corners.empty()) return explanation.at;
    const auto lighter = [](const ExplainedCorner& a, const ExplainedCorner& b) {
        return a.weight < b.weight;
    };
    return std::max_element(explanation.corners.begin(), explanation.corners.end(), lighter)->at;
}

}  // namespace

PlotPoint plot_point(const std::optional<Explanation>& explanation, int light) {
    PlotPoint point;
    if (!explanation || !explanation->hit) return point;
    point.at = &heaviest(*explanation);
    point.material = &explanation->material;
    for (const ExplainedLight& each : point.at->lights)
        if (each.index == light)
            point.light = each.samples.empty() ? &each : &each.samples[each.samples.size() / 2];
    return point;
}

glm::dvec2 falloff_mark(const PlotPoint& point) { return {point.light->distance, point.light->falloff}; }

glm::dvec2 spot_mark(const PlotPoint& point) { return {point.light->spot_angle_deg, point.light->spot}; }

glm::dvec2 highlight_mark(const PlotPoint& point, Reflection reflection) {
    const double deg = reflection == Reflection::BlinnPhong ? 2 * degrees_of(double(point.light->n_dot_h))
                                                            : degrees_of(double(point.light->r_dot_v));
    return {deg, point.light->specular_factor.x};
}

LocalDirections local_directions(const PlotPoint& point) {
    LocalDirections local;
    if (point.light == nullptr) return local;
    const glm::dvec3 n = point.at->normal.camera, l = point.light->l.camera, v = point.at->view.camera;
    glm::dvec3 x = n * glm::dot(n, l) - l;
    if (glm::length(x) < 1e-6) x = v - n * glm::dot(n, v);  // light along n: any plane works; use that of v
    if (glm::length(x) < 1e-6)
        x = glm::cross(n, std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    x = glm::normalize(x);
    const glm::dvec3 y = glm::cross(n, x);
    local.l = glm::vec3(glm::dot(l, x), glm::dot(l, y), glm::dot(l, n));
    local.v = glm::vec3(glm::dot(v, x), glm::dot(v, y), glm::dot(v, n));
    local.light_deg = degrees_of(double(local.l.z));
    local.view_deg = degrees_of(double(local.v.z)) * (local.v.x < 0 ? -1 : 1);
    return local;
}

Rect plot_room(float height) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, px(60)), px(height)};
    ImGui::Dummy(size);
    return {low, low + size};
}

int plotted_light(const UiState& state) {
    const std::vector<Light>& lights = explained_scene(state).lights;
    const auto exists = [&](int light) {
        return light >= 0 && static_cast<std::size_t>(light) < lights.size();
    };
    const Selection& selection = state.editor.selection;
    if (selection.kind == Selection::Kind::Light && exists(selection.index)) return selection.index;
    if (state.on_screen.explanation && state.on_screen.explanation->hit)
        if (const ExplainedLight* light =
                asked_light(state, asked_point(state.get<InspectorState>(), *state.on_screen.explanation));
            light != nullptr && exists(light->index))
            return light->index;
    return 0;
}

void plots_tab(UiState& state, const PictureView& view) {
    const Scene& scene = explained_scene(state);
    PlotsState& plots = state.get<PlotsState>();
    if (scene.lights.empty()) return wrapped_dim("The curves describe a light: add one (Shift+L).");
    const int light = plotted_light(state);
    int chosen = light;
    ImGui::SetNextItemWidth(label_cell("Light"));
    if (light_combo("##plot_light", chosen, scene.lights))
        tooltip("Light", "The light whose curves are drawn: the selected one");
    if (chosen != light) state.editor.selection = {Selection::Kind::Light, chosen};
    PlotSubject subject{scene, light, plot_point(state.on_screen.explanation, light), {}};
    if (subject.point.material != nullptr)
        subject.material = *subject.point.material;
    else if (!scene.objects.empty())
        subject.material = scene.objects.front().material;
    if (subject.point.at == nullptr) small_dim("Pick a pixel to see its position on each curve.");
    if (subject.point.at != nullptr && subject.point.light == nullptr) small_dim("This light is off.");
    falloff_section(subject);
    highlight_section(plots, subject);
    cosine_section(plots, subject);
    spot_section(subject);
    lobe_section(plots, subject);
    intensities_section(subject);
    kinds_section(subject, view);
    sketch_section(state, plots, subject);
    brdf_section(plots, subject);
    microfacet_section(plots, subject);
}

}  // namespace glint
