#include "ui/picture/handles/light_effects.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "models/numbers.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/handles/light_place.h"

namespace glint {
namespace {

constexpr double faint = 0.01;  // initial intensity when a light of intensity 0 is raised

constexpr LightEffectInfo infos[] = {
    {LightEffect::Brightest, "brightest here, n·l = 1", "The light is in the direction of n",
     "No surface there: the light stays as it is"},
    {LightEffect::Rim, "behind, as a rim light", "The light comes from behind, 75° off n: the outline is lit",
     "No light from behind can reach that: the light stays as it is"},
};

/// The unit vector towards the eye, world coordinates.
glm::dvec3 towards_eye(const SurfaceView& view, glm::dvec3 place) {
    return -ray_through(view.map, project(view.map, place).pixel).direction;
}

/// The unit vector from the point to the light's target direction; nothing if there is none.
std::optional<glm::dvec3> way_to_light(LightEffect effect, const SurfaceView& view, glm::dvec3 place,
                                       glm::dvec3 n) {
    if (effect == LightEffect::Brightest) return n;
    const glm::dvec3 v = towards_eye(view, place);
    const double facing = glm::dot(n, v);
    if (facing > std::sin(rim_light_deg * degree)) return {};
    const glm::dvec3 away = facing * n - v;  // along the surface, away from the viewer
    const double length = glm::length(away);
    if (length < 1e-6) return {};
    return std::cos(rim_light_deg * degree) * n + std::sin(rim_light_deg * degree) / length * away;
}

double sum_of(glm::vec3 c) { return double(c.x) + double(c.y) + double(c.z); }

}  // namespace

const LightEffectInfo& info_of(LightEffect effect) { return infos[static_cast<std::size_t>(effect)]; }

std::optional<Light> with_effect(LightEffect effect, const Light& light, const SurfaceView& view,
                                 glm::dvec2 pixel) {
    const auto point = seen_at(view.renderer, view.map.size, pixel);
    if (!point) return {};
    const glm::dvec3 place = in_world(view.map, point->position, 1);
    const auto way = way_to_light(effect, view, place, glm::normalize(in_world(view.map, point->normal, 0)));
    if (!way) return {};
    if (light.kind == LightKind::Directional)
        return placed_at(light, view.dome.centre + *way, view.dome, view.map);
    const double distance = std::max(glm::distance(handle_of(light, view.dome, view.map), place), 1e-4);
    const Light moved = placed_at(light, place + distance * *way, view.dome, view.map);
    return aimed_at(moved, place, {view.map, view.dome});
}

glm::vec3 added_by(const ExplainedLight& light) {
    glm::vec3 sum = light.share;
    for (const ExplainedLight& sample : light.samples) sum += sample.share;
    return sum;
}

std::map<int, glm::vec3> added_to_pixel(const Explanation& explanation) {
    std::map<int, glm::vec3> adds;
    const auto add = [&adds](const ExplainedPoint& at, float weight) {
        for (const ExplainedLight& light : at.lights) adds[light.index] += weight * added_by(light);
    };
    if (!explanation.lit_per_corner) add(explanation.at, 1);
    for (const ExplainedCorner& corner : explanation.corners)
        if (explanation.lit_per_corner) add(corner.at, corner.weight);
    return adds;
}

double share_of_pixel(const Explanation& explanation, glm::vec3 added) {
    const double sum = sum_of(explanation.sum);
    return sum > 0 ? std::clamp(sum_of(added) / sum, 0.0, 1.0) : 0;
}

std::optional<MainLight> main_light(const Explanation& explanation) {
    const std::map<int, glm::vec3> adds = added_to_pixel(explanation);
    const auto most = std::max_element(adds.begin(), adds.end(), [](const auto& a, const auto& b) {
        return sum_of(a.second) < sum_of(b.second);
    });
    const double share = most == adds.end() ? 0 : share_of_pixel(explanation, most->second);
    return share > 0 ? std::optional(MainLight{most->first, share}) : std::nullopt;
}

float dimmed(float intensity, double up_px, int height) {
    const double factor = std::exp(std::clamp(3 * up_px / height, -7.0, 7.0));
    if (intensity == 0 && up_px > 0) return static_cast<float>(faint * factor);
    return static_cast<float>(std::min(double(intensity) * factor, 1e6));
}

}  // namespace glint
