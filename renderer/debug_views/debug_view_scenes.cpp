// Scenes whose pictures measure a quantity.
#include "models/scene/mistakes.h"
#include "renderer/debug_views/debug_view.h"
#include "renderer/reflectance/lobes.h"

namespace glint {
namespace {

/// Switches off the mistakes for which keep(mistake) is false.
template <class Keep> void keep_mistakes(Mistakes& mistakes, const Keep& keep) {
    for (const MistakeName& m : mistake_names()) mistakes.*m.flag &= keep(m);
}

/// Whether a mistake affects normals or the position of a light.
bool shows_in_measures(const MistakeName& m) {
    const bool reach = m.seen_as == SeenAs::WrongReach || m.seen_as == SeenAs::WrongBrightness;
    return m.stage == MistakeStage::Normals || m.stage == MistakeStage::Viewer ||
           (m.stage == MistakeStage::Lights && !reach);
}

/// A white surface under Lambert's law without clamping, with nothing else in the picture.
Scene measuring_scene(const Scene& scene) {
    Scene s = scene;
    s.lights.clear();
    s.global_ambient = glm::vec3(0);
    s.npr = {};
    s.display = {};
    s.display.background = glm::vec3(0);
    s.shading.reflection = Reflection::Lambert;
    s.shading.rules = Rules::Lecture;
    s.shading.terms = {false, false, true, false};
    keep_mistakes(s.shading.mistakes, [](const MistakeName& m) { return shows_in_measures(m); });
    s.shading.mistakes.no_clamp_of_cosine = true;
    s.shading.mistakes.lit_after_projection = false;
    for (Object& object : s.objects) {
        object.material = {};
        object.material.diffuse = glm::vec3(1);
    }
    return s;
}

Light sun_along(glm::vec3 axis) {
    Light sun;
    sun.kind = LightKind::Directional;
    sun.space = LightSpace::Camera;
    sun.position = {axis, 0};
    sun.diffuse = axis;
    return sun;
}

}  // namespace

Scene normal_scene(const Scene& scene, bool facet) {
    Scene s = measuring_scene(scene);
    s.shading.mode = facet ? ShadingMode::Facet : ShadingMode::Phong;
    keep_mistakes(s.shading.mistakes, [](const MistakeName& m) { return m.stage != MistakeStage::Lights; });
    // Cook-Torrance also has Lambert's diffuse term, but its light contributions are not rounded
    // (rounding.h).
    s.shading.reflection = Reflection::CookTorrance;
    s.lights = {sun_along({1, 0, 0}), sun_along({0, 1, 0}), sun_along({0, 0, 1})};
    return s;
}

Scene n_dot_l_scene(const Scene& scene, int light) {
    Scene s = measuring_scene(scene);
    Light l = white(scene.lights[static_cast<std::size_t>(light)]);
    if (l.kind != LightKind::Directional) l.kind = LightKind::Point;
    l.falloff = {};
    s.lights = {l};
    return s;
}

Scene silhouette_scene(const Scene& scene) {
    Scene s = scene;
    s.npr.silhouettes = true;
    s.npr.creases = false;
    s.npr.stroke_width_px = 2;
    s.npr.stroke = {1, 0.25f, 0.6f};  // a hue that is rare among materials
    return s;
}

Scene term_scene(const Scene& scene, DebugView term) {
    Scene s = scene;
    s.shading.terms = {term == DebugView::Emission, term == DebugView::Ambient, term == DebugView::Diffuse,
                       term == DebugView::Specular};
    return s;
}

}  // namespace glint
