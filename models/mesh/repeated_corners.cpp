#include "models/mesh/repeated_corners.h"

#include <algorithm>

namespace glint {

bool RepeatedCorners::comes_back(const Mesh& mesh, const std::vector<std::uint32_t>& corners) {
    vertices_.clear();
    for (const std::uint32_t c : corners) vertices_.push_back(mesh.corner_position[c]);
    sorted_ = vertices_;
    std::sort(sorted_.begin(), sorted_.end());
    auto twin = std::adjacent_find(sorted_.begin(), sorted_.end());
    if (twin == sorted_.end()) return false;
    if (has_spike()) return true;
    sides_.clear();
    for (std::size_t i = 0; i < vertices_.size(); ++i)
        sides_.emplace_back(vertices_[i], vertices_[(i + 1) % vertices_.size()]);
    std::sort(sides_.begin(), sides_.end());
    while (twin != sorted_.end()) {
        if (!ends_bridge(*twin)) return true;
        twin = std::adjacent_find(std::upper_bound(twin, sorted_.end(), *twin), sorted_.end());
    }
    return false;
}

bool RepeatedCorners::has_spike() const {
    const std::size_t n = vertices_.size();
    for (std::size_t i = 0; i < n; ++i)
        if (vertices_[i] == vertices_[(i + 2) % n]) return true;
    return false;
}

bool RepeatedCorners::ends_bridge(std::uint32_t vertex) const {
    auto side = std::lower_bound(sides_.begin(), sides_.end(), std::pair(vertex, std::uint32_t{0}));
    for (; side != sides_.end() && side->first == vertex; ++side)
        if (std::binary_search(sides_.begin(), sides_.end(), std::pair(side->second, vertex))) return true;
    return false;
}

}  // namespace glint
