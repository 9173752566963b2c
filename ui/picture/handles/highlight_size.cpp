#include "ui/picture/handles/highlight_size.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/scene/reflection.h"
#include "renderer/reflectance/highlight.h"
#include "ui/picture/handles/highlight_drag.h"

namespace glint {
namespace {

constexpr double enough_share = 0.5;   // of the peak: the part that can be grabbed
constexpr double enough_light = 0.15;  // fainter: hardly visible, so the user means to turn the camera
constexpr double rim_share = 0.5;      // of the maximum, at the rim
constexpr double sharpest = 10'000, dullest = 0.1;  // exponents
constexpr double smoothest = 0.02, roughest = 1;    // roughness
constexpr double radius_share = 0.3;  // share of a small highlight's inside that belongs to its rim

/// The material parameter that sets a highlight's size, from the smallest to the largest.
struct Width {
    float Material::*number;
    double smallest, largest;

    [[nodiscard]] Material at(Material material, double share) const {
        material.*number = static_cast<float>(smallest * std::pow(largest / smallest, share));
        return material;
    }
};
Width width_of(Reflection reflection) {
    return info_of(reflection).uses_shininess() ? Width{&Material::shininess, sharpest, dullest}
                                                : Width{&Material::roughness, smoothest, roughest};
}

/// The brightest channel of the highlight as displayed: 1 is full brightness.
double seen_brightness(const SurfaceView& view, const Light& light, const SeenPoint& point) {
    const Material& material = view.scene.objects[static_cast<std::size_t>(point.object)].material;
    const std::vector<SeenPoint> points{point};
    const glm::vec3 colour = material.specular * light.specular * light.intensity;
    return highlight_at(view.scene, view.map.size, light, points)[0] / 3 *
           double(std::max({colour.x, colour.y, colour.z}));
}

}  // namespace

double highlight_share(const SurfaceView& view, const Light& light, const SeenPoint& point,
                       const Material& material) {
    const std::vector<SeenPoint> points{point};
    const double here = highlight_at(view.scene, view.map.size, light, points, material)[0];
    const glm::vec3 mirror = peak_direction(view.scene, view.map.size, point);
    if (!(here > 0) || mirror == glm::vec3(0)) return 0;
    const HighlightDrag at = grab_highlight(view, light, point);
    const Light best = carried(at, view, at.grabbed, in_world(view.map, mirror, 0));
    const double most = highlight_at(view.scene, view.map.size, best, points, material)[0];
    return most > 0 ? here / most : 0;
}

std::optional<HoveredHighlight> highlight_under(const SurfaceView& view, glm::dvec2 pixel) {
    const Scene& scene = view.scene;
    const auto point = seen_at(view.renderer, view.map.size, pixel);
    if (!point || !scene.shading.terms.specular) return {};
    const Material& material = scene.objects[static_cast<std::size_t>(point->object)].material;
    std::optional<HoveredHighlight> best;
    double brightest = enough_light;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        if (!light.enabled) continue;
        const double seen = seen_brightness(view, light, *point);
        if (!(seen > brightest)) continue;
        const double share = highlight_share(view, light, *point, material);
        if (share < enough_share) continue;
        brightest = seen;
        best = {static_cast<int>(i), std::min(share, 1.0)};
    }
    return best;
}

std::optional<int> highlight_rim_under(const SurfaceView& view, glm::dvec2 pixel, double reach) {
    const Scene& scene = view.scene;
    if (!scene.shading.terms.specular || !info_of(scene.shading.reflection).has_highlight) return {};
    const auto patch = surface_patch(view.renderer, view.map.size, pixel, 1);
    if (!patch) return {};
    const Material& material = scene.objects[static_cast<std::size_t>(patch->middle().object)].material;
    std::optional<int> best;
    double nearest = reach;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        if (!light.enabled || !(seen_brightness(view, light, patch->middle()) > enough_light)) continue;
        const double share = highlight_share(view, light, patch->middle(), material);
        if (share < 0.1 || share > 0.8) continue;
        const double steep = patch->steepness(
            [&](const SeenPoint& seen) { return highlight_share(view, light, seen, material); });
        if (!(steep > 1e-6)) continue;
        // A bell 2^-(d/R)² has the slope ln 2 / R at its rim.
        const double radius = std::log(2.0) / steep, away = std::abs(share - rim_share) / steep;
        const double most = share > rim_share ? std::min(nearest, radius_share * radius) : nearest;
        if (away > most) continue;
        nearest = away;
        best = static_cast<int>(i);
    }
    return best;
}

std::optional<Material> sized_highlight(const SizeDrag& drag, const SurfaceView& view, glm::dvec2 pixel) {
    const auto point = seen_at(view.renderer, view.map.size, pixel);
    if (!point || point->object != drag.object) return {};
    const Width width = width_of(view.scene.shading.reflection);
    const auto share = [&](double at) {
        return highlight_share(view, drag.light, *point, width.at(drag.start, at));
    };
    if (!(share(1) > 0)) return {};
    double low = 0, high = 1;  // the share grows with the highlight's width
    if (share(low) >= rim_share) return width.at(drag.start, low);
    if (share(high) <= rim_share) return width.at(drag.start, high);
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (share(middle) < rim_share ? low : high) = middle;
    }
    return width.at(drag.start, (low + high) / 2);
}

}  // namespace glint
