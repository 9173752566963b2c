#include <algorithm>

#include "ui/picture/orbit.h"

namespace glint {

void keep_view(std::vector<Camera>& views, const Camera& camera) {
    if (std::find(views.begin(), views.end(), camera) != views.end()) return;
    views.push_back(camera);
    if (views.size() > max_views) views.erase(views.begin());
}

std::optional<Camera> next_view(const std::vector<Camera>& views, const Camera& shown) {
    if (views.empty()) return {};
    const auto at = std::find(views.begin(), views.end(), shown);
    return at == views.end() || at + 1 == views.end() ? views.front() : *(at + 1);
}

}  // namespace glint
