#include "ui/features/inspector/label_room.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint {
namespace {

constexpr int directions = 16;
constexpr int rings = 8;  // from the preferred position out to the maximum distance

Rect about(ImVec2 middle, ImVec2 size) {
    return {{middle.x - size.x / 2, middle.y - size.y / 2}, {middle.x + size.x / 2, middle.y + size.y / 2}};
}

}  // namespace

ImVec2 LabelRoom::inside(ImVec2 middle, ImVec2 size) const {
    if (!bounds_) return middle;
    const auto within = [](float at, float length, float low, float high) {
        return std::max(std::min(at, high - length / 2), low + length / 2);
    };
    return {within(middle.x, size.x, bounds_->low.x, bounds_->high.x),
            within(middle.y, size.y, bounds_->low.y, bounds_->high.y)};
}

bool LabelRoom::is_free(const Rect& area) const {
    return std::none_of(taken_.begin(), taken_.end(),
                        [&area](const Rect& other) { return overlap(area, other); });
}

std::optional<ImVec2> LabelRoom::place(ImVec2 wanted, ImVec2 size, float reach) {
    for (int ring = 0; ring <= rings; ++ring) {
        const float away = reach * float(ring) / rings;
        for (int i = 0; i < (ring == 0 ? 1 : directions); ++i) {
            const float angle = 2 * std::numbers::pi_v<float> * float(i) / directions;
            const ImVec2 middle =
                inside({wanted.x + away * std::sin(angle), wanted.y - away * std::cos(angle)}, size);
            const Rect area = about(middle, size);
            if (!is_free(area)) continue;
            taken_.push_back(area);
            return middle;
        }
    }
    return {};
}

ImVec2 LabelRoom::place_anyhow(ImVec2 wanted, ImVec2 size, float reach) {
    if (const auto middle = place(wanted, size, reach)) return *middle;
    const ImVec2 middle = inside(wanted, size);
    taken_.push_back(about(middle, size));
    return middle;
}

}  // namespace glint
