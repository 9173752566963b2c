#include "renderer/explain/explain_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <vector>

#include "models/problem.h"

namespace glint {
namespace {

bool points_away(const ExplainedPoint& at) { return glm::dot(at.normal.camera, at.view.camera) < 0; }

}  // namespace

bool is_plain_front(const Explanation& explanation) {
    return explanation.front_facing && !points_away(explanation.at);
}

std::string side_words(const Explanation& explanation) {
    const bool away = points_away(explanation.at);
    if (explanation.front_facing) return away ? "front side, n points away from the eye" : "front side";
    return away ? "back side" : "back side, n turned to the eye";
}

std::string dark_reason(const ExplainedLight& explained, const Light& light) {
    if (light.kind == LightKind::Area) {
        const auto in_front = std::count_if(explained.samples.begin(), explained.samples.end(),
                                            [](const ExplainedLight& sample) { return sample.n_dot_l > 0; });
        const auto all = static_cast<std::ptrdiff_t>(explained.samples.size());
        if (in_front == 0) return "behind the surface: n·l < 0 for all samples";
        if (explained.reached < 1) {
            const auto reach = std::lround(explained.reached * static_cast<float>(in_front));
            return reach == 0 ? "in the shadow of " + on_one_line(explained.blocked_by)
                              : fmt::format("{} of {} samples reach the point, the others are blocked by {}",
                                            reach, in_front, on_one_line(explained.blocked_by));
        }
        return in_front < all ? fmt::format("{} of {} samples are behind the surface", all - in_front, all)
                              : "";
    }
    const bool cone = light.kind == LightKind::Spot && light.spot.cutoff_deg <= 90;
    const bool is_outside = cone && explained.spot_angle_deg > light.spot.cutoff_deg;
    if (is_outside && explained.spot == 0)  // a mistake may widen the cone
        return fmt::format("outside the cone by {:.1f}°", explained.spot_angle_deg - light.spot.cutoff_deg);
    const bool adds = explained.diffuse + explained.specular != glm::vec3(0);  // a mistake may light the back
    if (explained.n_dot_l < 0 && !adds) return "behind the surface: n·l < 0";
    if (explained.reached == 0) return "in the shadow of " + on_one_line(explained.blocked_by);
    if (explained.n_dot_l == 0 && !adds) return "grazes the surface: n·l = 0";
    const float arrives = light.intensity * explained.falloff;  // a strong light has a long range
    if (arrives < 0.01f && explained.falloff < 0.01f)
        return fmt::format("hardly reaches: falloff {:.2g}", explained.falloff);
    if (arrives * explained.spot < 0.01f && explained.spot < 0.01f)
        return fmt::format("its cone lets through {:.2g}", explained.spot);
    return {};
}

std::string shadow_sentence(const ExplainedPoint& point, const Scene& scene) {
    constexpr std::size_t max_lights = 4;
    const bool blocked = std::any_of(point.lights.begin(), point.lights.end(),
                                     [](const ExplainedLight& light) { return light.reached < 1; });
    if (!blocked) return {};
    std::vector<std::string> reasons;
    for (const ExplainedLight& light : point.lights)
        if (const std::string reason =
                dark_reason(light, scene.lights[static_cast<std::size_t>(light.index)]);
            !reason.empty())
            reasons.push_back(on_one_line(light.name) + ": " + reason);
    if (reasons.size() > max_lights) {
        const std::size_t others = reasons.size() - max_lights;
        reasons.resize(max_lights);
        reasons.push_back(fmt::format("{} other light{}", others, others == 1 ? "" : "s"));
    }
    return fmt::format("{}.", fmt::join(reasons, "; "));
}

}  // namespace glint
