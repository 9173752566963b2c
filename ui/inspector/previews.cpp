#include "ui/inspector/previews.h"

#include "ui/ui.h"

namespace glint {

Scene with_term_alone(Scene scene, Symbol term) {
    Terms& terms = scene.shading.terms;
    switch (term) {
    case Symbol::Ambient:
        terms = {false, true, false, false};
        break;
    case Symbol::Diffuse:
        terms = {false, false, true, false};
        break;
    case Symbol::Specular:
        terms = {false, false, false, true};
        break;
    case Symbol::Emission:
        terms = {true, false, false, false};
        break;
    case Symbol::N:
    case Symbol::L:
    case Symbol::V:
    case Symbol::R:
    case Symbol::H:
        break;
    }
    return scene;
}

void show_instead(UiState& state, const Scene& scene, const std::string& name) {
    state.why_column.instead = scene;
    state.why_column.preview_name = name;
}

Scene with_light_alone(Scene scene, int light) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        scene.lights[i].enabled = static_cast<int>(i) == light;
    scene.global_ambient = glm::vec3(0);
    scene.shading.terms.emission = false;
    return scene;
}

}  // namespace glint
