#include <algorithm>

#include "ui/picture/orbit.h"

namespace glint {

void keep_view(std::vector<Camera>& views, const Camera& camera) {
    if (std::find(views.begin(), views.end(), camera) != views.end()) return;
    views.push_back(camera);
    if (views.size() > max_views) views.erase(views.begin());
}

std::vector<Camera> with_changed_views(std::vector<Camera> kept, const std::vector<Camera>& before,
                                       const std::vector<Camera>& now) {
    const auto is_in = [](const std::vector<Camera>& views, const Camera& view) {
        return std::find(views.begin(), views.end(), view) != views.end();
    };
    std::erase_if(kept, [&](const Camera& view) { return is_in(before, view) && !is_in(now, view); });
    for (const Camera& view : now)
        if (!is_in(before, view)) keep_view(kept, view);
    return kept;
}

std::optional<Camera> next_view(const std::vector<Camera>& views, const Camera& shown) {
    if (views.empty()) return {};
    const auto at = std::find(views.begin(), views.end(), shown);
    return at == views.end() || at + 1 == views.end() ? views.front() : *(at + 1);
}

}  // namespace glint
