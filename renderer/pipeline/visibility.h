#pragma once
// Stage 2. Which triangle is at each sample: an exact fill rule on integers, nearest wins, ties go to the
// lower object and then the lower face. Inputs: the geometry and `cull`.

#include <cstdint>
#include <vector>

#include "renderer/pipeline/geometry.h"

namespace glint {

struct Visibility {
    Cull cull = Cull::None;
    std::vector<std::uint64_t>
        keys;  // width x height: nearness bits above, inverted triangle number below; 0: none
    std::vector<std::uint8_t>
        back;  // width x height: 1 where the triangle seen is wound clockwise on the screen

    [[nodiscard]] std::uint32_t triangle_at(std::size_t pixel) const {
        return keys[pixel] ? ~static_cast<std::uint32_t>(keys[pixel]) : no_triangle;
    }
};

/// Does the stage again when the geometry was redone or `cull` differs; true when it did.
bool update_visibility(Visibility& kept, const Geometry& geometry, Cull cull, bool geometry_redone);

}  // namespace glint
