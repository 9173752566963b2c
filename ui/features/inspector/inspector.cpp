#include "ui/features/inspector/inspector.h"

#include <imgui.h>

#include <algorithm>

#include "ui/picture/handles/light_effects.h"
#include "ui/ui.h"

namespace glint {

extern const Feature inspector_feature;

const ExplainedPoint& asked_point(const InspectorState& state, const Explanation& explanation) {
    if (!explanation.lit_per_corner || explanation.corners.empty()) return explanation.at;
    const auto last = static_cast<int>(explanation.corners.size()) - 1;
    return explanation.corners[static_cast<std::size_t>(std::clamp(state.corner, 0, last))].at;
}

const ExplainedLight* asked_light(const UiState& state, const ExplainedPoint& point) {
    const auto find = [&](int index) {
        return std::find_if(point.lights.begin(), point.lights.end(),
                            [index](const ExplainedLight& light) { return light.index == index; });
    };
    if (point.lights.empty()) return nullptr;
    if (const auto it = find(state.get<InspectorState>().pointed_light); it != point.lights.end())
        return &*it;
    const Selection& selection = state.editor.selection;
    if (selection.kind == Selection::Kind::Light)
        if (const auto it = find(selection.index); it != point.lights.end()) return &*it;
    const auto adds = [](const ExplainedLight& light) {
        const glm::vec3 share = added_by(light);
        return share.x + share.y + share.z;
    };
    return &*std::max_element(
        point.lights.begin(), point.lights.end(),
        [&](const ExplainedLight& a, const ExplainedLight& b) { return adds(a) < adds(b); });
}

Scene with_term_alone(Scene scene, Symbol term) {
    scene.shading.terms = {term == Symbol::Emission, term == Symbol::Ambient, term == Symbol::Diffuse,
                           term == Symbol::Specular};
    return scene;
}

void show_instead(UiState& state, const Scene& scene, const std::string& name, bool rests) {
    if (same_description(scene, state.editor.scene())) return;  // a click has just applied it
    if (!has_turn(state, inspector_feature)) return;
    InspectorState& inspector = state.get<InspectorState>();
    inspector.instead = scene;
    inspector.instead_rests = rests;
    inspector.preview_name = name;
}

Scene with_light_alone(Scene scene, int light) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        scene.lights[i].enabled = static_cast<int>(i) == light;
    scene.global_ambient = glm::vec3(0);
    scene.shading.terms.emission = false;
    return scene;
}

}  // namespace glint
