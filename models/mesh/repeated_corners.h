#pragma once
// Polygons that come back to a corner which they have had. Inside models/ only.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "models/mesh/mesh.h"

namespace glint {

/// Looks for them; keeps its buffers from one polygon to the next.
class RepeatedCorners {
  public:
    /// Whether a vertex comes twice in the polygon of these corners, other than at the ends of a bridge: an
    /// edge that is gone both ways, but not straight back, joins a hole to the outline. Precondition: no
    /// vertex comes twice in a row. Time: n log n.
    [[nodiscard]] bool comes_back(const Mesh& mesh, const std::vector<std::uint32_t>& corners);

  private:
    [[nodiscard]] bool has_spike() const;
    [[nodiscard]] bool ends_bridge(std::uint32_t vertex) const;

    std::vector<std::uint32_t> vertices_, sorted_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides_;  // from, to; sorted
};

}  // namespace glint
