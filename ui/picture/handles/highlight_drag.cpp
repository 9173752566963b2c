#include "ui/picture/handles/highlight_drag.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "models/scene/reflection.h"
#include "renderer/reflectance/highlight.h"
#include "ui/picture/handles/light_handles.h"

namespace glint {
namespace {

constexpr int patch_radius = 3;  // pixels
// Factors of the light's distance to try. Near the light's mirror image in a concave surface, the specular
// term hardly changes in one direction, and the slope of the falloff leaves no peak. The light is then moved
// nearer or farther, by as little as necessary.
constexpr double other_distances[] = {1, 1.25, 0.8, 1.6,  0.63, 2,  0.5,  3,    0.33, 4,    0.25,
                                      6, 0.16, 10,  0.13, 0.1,  16, 0.08, 0.06, 0.04, 0.025};

/// Turns a spot if necessary, so that `place` is well inside its cone. A highlight cut off by the cone's edge
/// would have its peak at that edge.
void aim_at(Light& light, glm::dvec3 place, const SurfaceView& view) {
    if (light.kind != LightKind::Spot || light.spot.cutoff_deg > 90) return;
    const glm::dvec3 way = glm::normalize(place - handle_of(light, view.dome, view.map));
    const glm::dvec3 axis = glm::normalize(to_world(light, light.spot.direction, 0, view.map));
    const double angle = std::acos(std::clamp(glm::dot(axis, way), -1.0, 1.0));
    const double inside = 0.6 * double(light.spot.cutoff_deg) * std::numbers::pi / 180;
    if (angle <= inside) return;
    const glm::dvec3 off = glm::cross(way, axis);
    const glm::dvec3 aim = glm::length(off) < 1e-9 ? way : rotated(way, glm::normalize(off), inside);
    turn_shape(light, rotation_between(axis, aim), view.map);
}

/// Searches for the light direction for which the specular term has zero slope at the centre of a patch.
class PeakSearch {
  public:
    PeakSearch(const HighlightDrag& drag, const SurfaceView& view, const SurfacePatch& patch, double nearer)
        : drag_(drag), view_(view), patch_(patch), nearer_(nearer) {
        place_ = in_world(view.map, patch.middle().position, 1);
    }

    [[nodiscard]] Light light(glm::dvec3 away) const { return carried(drag_, view_, place_, away, nearer_); }

    /// Takes Newton steps from `first` and returns the direction with the smallest slope found.
    [[nodiscard]] glm::dvec3 level_from(glm::dvec3 first, int radius) const {
        const auto [u, v] = across(first);
        const auto away = [&, u = u, v = v](glm::dvec2 tilt) {
            return glm::normalize(first + tilt.x * u + tilt.y * v);
        };
        glm::dvec2 tilt(0);
        glm::dvec2 now = slope(radius, away(tilt));
        for (int i = 0; i < 10 && glm::length(now) > 1e-7; ++i) {
            constexpr double h = 2e-3;
            const glm::dvec2 by_x = (slope(radius, away(tilt + glm::dvec2(h, 0))) - now) / h,
                             by_y = (slope(radius, away(tilt + glm::dvec2(0, h))) - now) / h;
            const glm::dmat2 jacobian(by_x, by_y);
            if (!(std::abs(glm::determinant(jacobian)) > 1e-12)) break;
            glm::dvec2 step = -(glm::inverse(jacobian) * now);
            step *= std::min(1.0, 0.3 / std::max(glm::length(step), 1e-12));
            double share = 1;
            glm::dvec2 next = slope(radius, away(tilt + step));
            for (; share > 0.05 && !(glm::length(next) < glm::length(now));
                 next = slope(radius, away(tilt + share * step)))
                share /= 2;
            if (!(glm::length(next) < glm::length(now))) break;
            tilt += share * step;
            now = next;
        }
        return away(tilt);
    }

    /// Returns the distance of the brightest point from the centre, in pixels; a large value if the centre is
    /// dark.
    [[nodiscard]] double miss(const Light& light) const {
        return patch_.distance_of_maximum(highlight_at(view_.scene, view_.map.size, light, patch_.points));
    }

  private:
    /// Returns the slope; a very large one if the centre is dark, since an unlit patch has no slope but is
    /// not a peak.
    [[nodiscard]] glm::dvec2 slope(int radius, glm::dvec3 away) const {
        const std::vector<double> values =
            highlight_at(view_.scene, view_.map.size, light(away), patch_.points);
        if (!(values[values.size() / 2] > 0)) return glm::dvec2(1e9);
        return patch_.slope_of_log(values, radius);
    }

    const HighlightDrag& drag_;
    const SurfaceView& view_;
    const SurfacePatch& patch_;
    double nearer_;
    glm::dvec3 place_;
};

/// The light whose peak is nearest to the cursor.
struct BestLight {
    std::optional<Light> light;
    double miss = 0;  // pixels

    void take(const PeakSearch& search, glm::dvec3 away) {
        const Light trial = search.light(away);
        const double by = search.miss(trial);
        if (light && by >= miss) return;
        light = trial;
        miss = by;
    }
};

/// Returns the directions to search from: the mirror direction, and for a panel those that put one of its
/// central samples, each of which has its own peak, in the mirror direction.
std::vector<glm::dvec3> first_directions(const HighlightDrag& drag, const SurfaceView& view, glm::dvec3 place,
                                         glm::dvec3 mirror, double nearer) {
    std::vector<glm::dvec3> all{mirror};
    if (drag.start.kind != LightKind::Area) return all;
    const Light light = carried(drag, view, place, mirror, nearer);
    const int n = static_cast<int>(std::lround(std::sqrt(light.area.samples)));
    const int low = (n - 1) / 2, high = n / 2;
    for (const int i : {low, high})
        for (const int j : {low, high}) {
            const glm::dvec3 own = ((2.0 * i + 1) / n - 1) * glm::dvec3(light.area.edge_u) +
                                   ((2.0 * j + 1) / n - 1) * glm::dvec3(light.area.edge_v);
            const glm::dvec3 sample = to_world(light, own, 0, view.map);
            all.push_back(glm::normalize(drag.distance * nearer * mirror - sample));
        }
    return all;
}

/// The point where the highlight's peak should be.
struct Sought {
    const SurfaceView& view;
    const SurfacePatch& patch;
    glm::dvec3 place, mirror;  // world coordinates; where Phong's factor is largest
};

void look_over_distances(const HighlightDrag& drag, const Sought& sought, BestLight& best) {
    for (const double farther : other_distances) {
        const double nearer = drag.nearer * farther;
        const PeakSearch search(drag, sought.view, sought.patch, nearer);
        best.take(search, sought.mirror);
        for (const glm::dvec3 first :
             first_directions(drag, sought.view, sought.place, sought.mirror, nearer))
            for (int radius = patch_radius; radius > 0 && best.miss > 1; --radius)
                best.take(search, search.level_from(first, radius));
        if (best.miss <= 1 || drag.start.kind == LightKind::Directional) return;
    }
}

/// Returns the same grab with the spot turned so that its axis passes through the grabbed point.
HighlightDrag aimed_at_grabbed(const HighlightDrag& drag, const SurfaceView& view) {
    HighlightDrag aimed = drag;
    const glm::dvec3 axis = glm::normalize(to_world(drag.start, drag.start.spot.direction, 0, view.map));
    const glm::dvec3 way = glm::normalize(drag.grabbed - handle_of(drag.start, view.dome, view.map));
    turn_shape(aimed.start, rotation_between(axis, way), view.map);
    return aimed;
}

}  // namespace

std::optional<HighlightDrag> grab_highlight(const SurfaceView& view, const Light& light, glm::dvec2 pixel) {
    const auto point = seen_at(view.renderer, view.map.size, pixel);
    if (!point) return {};
    return grab_highlight(view, light, *point);
}

HighlightDrag grab_highlight(const SurfaceView& view, const Light& light, const SeenPoint& point) {
    HighlightDrag drag;
    drag.start = light;
    drag.grabbed = in_world(view.map, point.position, 1);
    if (light.kind != LightKind::Directional)
        drag.distance = std::max(glm::length(handle_of(light, view.dome, view.map) - drag.grabbed), 1e-4);
    aim_at(drag.start, drag.grabbed, view);
    return drag;
}

Light carried(const HighlightDrag& drag, const SurfaceView& view, glm::dvec3 place, glm::dvec3 away,
              double nearer) {
    if (drag.start.kind == LightKind::Directional)
        return placed_at(drag.start, view.dome.centre + away, view.dome, view.map);
    Light light = placed_at(drag.start, place + drag.distance * nearer * away, view.dome, view.map);
    const glm::dvec3 before = (handle_of(drag.start, view.dome, view.map) - drag.grabbed) / drag.distance;
    if (glm::length(before) > 0.5) turn_shape(light, rotation_between(before, away), view.map);
    return light;
}

std::optional<Light> dragged_highlight(const HighlightDrag& drag, const SurfaceView& view, glm::dvec2 pixel) {
    const auto patch = surface_patch(view.renderer, view.map.size, pixel, patch_radius);
    if (!patch) return {};
    const glm::vec3 mirror = peak_direction(view.scene, view.map.size, patch->middle());
    if (mirror == glm::vec3(0)) return {};
    const Sought sought{view, *patch, in_world(view.map, patch->middle().position, 1),
                        in_world(view.map, mirror, 0)};
    BestLight best;
    look_over_distances(drag, sought, best);
    // Away from a spot's axis, its angular profile has a slope at every distance. So aim the spot
    // at the cursor.
    if (best.miss > 1 && drag.start.kind == LightKind::Spot)
        look_over_distances(aimed_at_grabbed(drag, view), sought, best);
    return best.light;
}

std::optional<Light> moved_highlight(HighlightDrag& drag, const SurfaceView& view, glm::dvec2 cursor_px,
                                     glm::dvec2 last_px, bool in_depth) {
    if (in_depth && drag.start.kind != LightKind::Directional) {
        if (!drag.stays_at) drag.stays_at = last_px + drag.beside;
        const double factor = std::exp(-3 * (cursor_px.y - last_px.y) / view.map.size.height);
        drag.nearer = std::clamp(drag.nearer * factor, 1e-3, 1e3);
        return dragged_highlight(drag, view, *drag.stays_at);
    }
    if (drag.stays_at) drag.beside = *drag.stays_at - last_px;  // restart here, so that nothing jumps
    drag.stays_at.reset();
    return dragged_highlight(drag, view, cursor_px + drag.beside);
}

namespace {

constexpr double enough_share = 0.5;  // fraction of the peak above which the highlight can be grabbed
constexpr double enough_light =
    0.15;  // a fainter one is hardly visible, so the user probably wants to turn the camera
constexpr double rim_share = 0.5;                   // fraction of the maximum at the rim
constexpr double sharpest = 10'000, dullest = 0.1;  // exponents
constexpr double smoothest = 0.02, roughest = 1;    // roughness
constexpr double radius_share = 0.3;  // the rim's reach inside a small highlight, as a fraction of its radius

/// The material parameter that sets a highlight's size, from the smallest to the largest.
struct Width {
    float Material::*number;
    double smallest, largest;

    [[nodiscard]] Material at(Material material, double share) const {
        material.*number = static_cast<float>(smallest * std::pow(largest / smallest, share));
        return material;
    }
};
Width width_of(const Material& material, const Scene& scene) {
    return info_of(reflection_of(material, scene.shading.reflection)).uses_shininess()
               ? Width{&Material::shininess, sharpest, dullest}
               : Width{&Material::roughness, smoothest, roughest};
}

/// Returns the brightest channel of the highlight as displayed; 1 is full brightness.
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
    if (!scene.shading.terms.specular) return {};
    const auto patch = surface_patch(view.renderer, view.map.size, pixel, 1);
    if (!patch) return {};
    const Material& material = scene.objects[static_cast<std::size_t>(patch->middle().object)].material;
    if (!info_of(reflection_of(material, scene.shading.reflection)).has_highlight) return {};
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
    const Width width = width_of(drag.start, view.scene);
    const auto share = [&](double at) {
        return highlight_share(view, drag.light, *point, width.at(drag.start, at));
    };
    if (!(share(1) > 0)) return {};
    double low = 0, high = 1;  // the value at the rim grows with the highlight's width
    if (share(low) >= rim_share) return width.at(drag.start, low);
    if (share(high) <= rim_share) return width.at(drag.start, high);
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (share(middle) < rim_share ? low : high) = middle;
    }
    return width.at(drag.start, (low + high) / 2);
}

}  // namespace glint
