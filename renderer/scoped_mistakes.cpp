#include "renderer/scoped_mistakes.h"

#include <algorithm>
#include <utility>

#include "renderer/lighting/display.h"
#include "renderer/renderer.h"
#include "renderer/shade/lighting.h"

namespace glint {

namespace {

bool is_meant(const MistakeScope& scope, const Scene& scene, std::size_t light) {
    return (scope.light < 0 || static_cast<std::size_t>(scope.light) == light) &&
           (scope.lights == ScopeLights::All ||
            static_cast<int>(scene.lights[light].kind) + 1 == static_cast<int>(scope.lights));
}

}  // namespace

bool has_scope(const Scene& scene) {
    const Mistakes& mistakes = scene.shading.mistakes;
    return !mistakes.only.is_all() && !mistakes.culled_by_light;
}

Scene isolated(Scene scene, const MistakeScope& scope) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        scene.lights[i].enabled = scene.lights[i].enabled && is_meant(scope, scene, i);
    scene.global_ambient = glm::vec3(0);
    Terms& terms = scene.shading.terms;
    terms.emission = false;
    if (scope.term == ScopeTerm::All) return scene;
    terms.ambient = false;
    (scope.term == ScopeTerm::Diffuse ? terms.specular : terms.diffuse) = false;
    return scene;
}

namespace {

/// The mistakes that are conventions in many programs: if there are others as well, they are made everywhere.
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

/// The scene without its mistakes, and with them everywhere.
struct BothScenes {
    explicit BothScenes(const Scene& scene) : right(scene), wrong(scene) {
        right.shading.mistakes = conventions_of(scene.shading.mistakes);
        wrong.shading.mistakes.only = {};
    }
    Scene right, wrong;
};

/// Replaces the terms of the scope's lights with those of `wrong`, the same point with the mistakes.
void take_meant(ExplainedPoint& point, const ExplainedPoint& wrong, const Scene& scene) {
    const MistakeScope& scope = scene.shading.mistakes.only;
    for (ExplainedLight& light : point.lights) {
        if (!is_meant(scope, scene, static_cast<std::size_t>(light.index))) continue;
        const auto same = [&light](const ExplainedLight& other) { return other.index == light.index; };
        const auto found = std::ranges::find_if(wrong.lights, same);
        if (found == wrong.lights.end()) continue;
        const ExplainedLight right = std::exchange(light, *found);
        if (scope.term == ScopeTerm::All) continue;
        light.ambient = right.ambient;
        if (scope.term == ScopeTerm::Diffuse) light.specular = right.specular;
        if (scope.term == ScopeTerm::Specular) light.diffuse = right.diffuse;
        if (right.samples.empty()) light.share = light.ambient + light.diffuse + light.specular;
    }
}

}  // namespace

Explanation explain_scoped(const Renderer& renderer, const Scene& scene, int x, int y) {
    const MistakeScope scope = scene.shading.mistakes.only;
    const BothScenes both(scene);
    Explanation e = renderer.explain_as(both.right, x, y);
    if (!e.hit || (scope.object >= 0 && e.object_index != scope.object)) return e;
    Explanation wrong = renderer.explain_as(both.wrong, x, y);
    if (scope.is_of_light()) {
        take_meant(e.at, wrong.at, scene);
        for (std::size_t i = 0; i < std::min(e.corners.size(), wrong.corners.size()); ++i)
            take_meant(e.corners[i].at, wrong.corners[i].at, scene);
        const auto sum_of = [&](const Scene& part) {
            return renderer.explain_as(isolated(part, scope), x, y).sum;
        };
        e.sum = sum_of(both.wrong) + (e.sum - sum_of(both.right));
        if (!e.lit_per_corner) e.at.sum = e.sum;
    } else {
        e = std::move(wrong);
    }
    const DisplayJob job = display_job(scene.display, {});
    for (int i = 0; i < 3; ++i) {
        e.displayed[i] = displayed(job, e.sum[i]);
        e.byte[static_cast<std::size_t>(i)] = byte_of(e.displayed[i]);
    }
    return e;
}

Picture draw_scoped(Renderer& renderer, const Scene& scene, PictureSize size, int samples) {
    const MistakeScope scope = scene.shading.mistakes.only;
    const auto [right, wrong] = BothScenes(scene);
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
