#include "renderer/scoped_mistakes.h"

#include <utility>

#include "renderer/lighting/display.h"
#include "renderer/renderer.h"
#include "renderer/shade/lighting.h"

namespace glint {

Scene isolated(Scene scene, const MistakeScope& scope) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        Light& light = scene.lights[i];
        const bool is_meant = (scope.light < 0 || static_cast<std::size_t>(scope.light) == i) &&
                              (scope.lights == ScopeLights::All ||
                               static_cast<int>(light.kind) + 1 == static_cast<int>(scope.lights));
        light.enabled = light.enabled && is_meant;
    }
    scene.global_ambient = glm::vec3(0);
    Terms& terms = scene.shading.terms;
    terms.emission = false;
    if (scope.term == ScopeTerm::All) return scene;
    terms.ambient = false;
    (scope.term == ScopeTerm::Diffuse ? terms.specular : terms.diffuse) = false;
    return scene;
}

namespace {

/// The mistakes that are conventions of many programs: together with others, they are made everywhere.
Mistakes conventions_of(const Mistakes& all) {
    Mistakes conventions;
    conventions.specular_behind_surface = all.specular_behind_surface;
    conventions.interpolated_lengths = all.interpolated_lengths;
    conventions.highlight_normalized = all.highlight_normalized;
    conventions.highlight_form = all.highlight_form;
    Mistakes others = all;
    others.only = {};
    return others == conventions ? Mistakes{} : conventions;
}

}  // namespace

Picture draw_scoped(Renderer& renderer, const Scene& scene, PictureSize size, int samples) {
    const MistakeScope scope = scene.shading.mistakes.only;
    Scene right = scene, wrong = scene;
    right.shading.mistakes = conventions_of(scene.shading.mistakes);
    wrong.shading.mistakes.only = {};
    const auto linear_of = [&](const Scene& of) { return renderer.render(of, size, true, samples).linear; };
    Picture picture = renderer.render(right, size, true, samples);
    std::vector<float>& sum = picture.linear;
    std::vector<float> edited;
    if (scope.is_of_light()) {
        const std::vector<float> before = linear_of(isolated(right, scope));
        edited = linear_of(isolated(wrong, scope));
        for (std::size_t i = 0; i < sum.size(); ++i) edited[i] += sum[i] - before[i];
    }
    const Picture& everywhere = renderer.render(wrong, size, true, samples);  // explain() refers to it
    if (!scope.is_of_light()) edited = everywhere.linear;
    const DisplayJob job = display_job(scene.display, {});
    for (std::size_t i = 0; i < size.pixels(); ++i) {
        const int x = static_cast<int>(i % std::size_t(size.width));
        const int y = static_cast<int>(i / std::size_t(size.width));
        const int object = renderer.object_at(x, y);
        if (object < 0 || (scope.object >= 0 && object != scope.object)) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            sum[3 * i + c] = edited[3 * i + c];
            picture.rgba[4 * i + c] = static_cast<std::uint8_t>(byte_of(displayed(job, edited[3 * i + c])));
        }
    }
    return picture;
}

}  // namespace glint
