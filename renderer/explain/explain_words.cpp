#include "renderer/explain/explain_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "models/problem.h"

namespace glint {
namespace {

/// " (4 of 64 samples so far)"; empty for all samples.
std::string so_far(const ExplainedLight& explained, const Light& area) {
    const std::string count = sample_count(explained, area);
    return count.ends_with("so far") ? fmt::format(" ({})", count) : "";
}

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

std::string sample_count(const ExplainedLight& explained, const Light& area) {
    const auto side = static_cast<std::size_t>(std::lround(std::sqrt(area.area.samples)));
    const std::size_t count = explained.samples.size(), all = side * side;
    return count < all ? fmt::format("{} of {} samples so far", count, all)
                       : fmt::format("{} samples", count);
}

std::string dark_reason(const ExplainedLight& explained, const Light& light) {
    if (light.kind == LightKind::Area) {
        const auto in_front = std::count_if(explained.samples.begin(), explained.samples.end(),
                                            [](const ExplainedLight& sample) { return sample.n_dot_l > 0; });
        const auto all = static_cast<std::ptrdiff_t>(explained.samples.size());
        if (in_front == 0)
            return std::string("behind the surface: n·l < 0 for all samples") + so_far(explained, light);
        if (explained.reached < 1) {
            const auto reach = std::lround(explained.reached * static_cast<float>(in_front));
            const std::string blocker = on_one_line(explained.blocked_by);
            return (reach == 0 ? "in the shadow of " + blocker
                               : fmt::format("{} of {} samples reach the point, the others are blocked by {}",
                                             reach, in_front, blocker)) +
                   so_far(explained, light);
        }
        if (in_front == all) return {};
        return fmt::format("{} of {} samples are behind the surface", all - in_front, all) +
               so_far(explained, light);
    }
    const bool cone = light.kind == LightKind::Spot && light.spot.cutoff_deg <= 90;
    const bool is_outside = cone && explained.spot_angle_deg > light.spot.cutoff_deg;
    if (is_outside && explained.spot == 0)  // a mistake may widen the cone
        return fmt::format("outside the cone by {:.1f}°", explained.spot_angle_deg - light.spot.cutoff_deg);
    const glm::vec3 added = explained.diffuse + explained.specular;
    const bool adds = std::max({added.r, added.g, added.b}) > grazing_cosine;  // a mistake may light the back
    if (std::abs(explained.n_dot_l) <= grazing_cosine && !adds) return "grazes the surface: n·l = 0";
    if (explained.n_dot_l < 0 && !adds) return "behind the surface: n·l < 0";
    if (explained.reached == 0) return "in the shadow of " + on_one_line(explained.blocked_by);
    const float arrives = light.intensity * explained.falloff;  // a strong light has a long range
    if (arrives < 0.01f && explained.falloff < 0.01f)
        return fmt::format("hardly reaches: falloff {:.2g}", explained.falloff);
    if (arrives * explained.spot < 0.01f && explained.spot < 0.01f)
        return fmt::format("its cone lets through {:.2g}", explained.spot);
    return {};
}

}  // namespace glint
