#pragma once
// A face in front of the near plane, on the screen: what interpolation on the screen works with.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory_resource>
#include <span>
#include <vector>

#include "renderer/geometry/geometry.h"

namespace glint {

/// A corner of the cut face. It lies between two of the face's own corners (or on `a`, with t = 0), at the
/// perspective-correct share t from a to b.
struct ClippedCorner {
    glm::dvec2 pixel{0};  // on the screen, in pixels, y down
    std::uint32_t a = 0, b = 0;
    double t = 0;
};

/// Memory for one face of usual size on the stack, so that a pixel costs no allocation.
struct ClipMemory {
    std::array<std::byte, 4096> bytes;
    std::pmr::monotonic_buffer_resource pool{bytes.data(), bytes.size()};
};

/// The part of a face in front of the near plane. `corners`: indices into Mesh::corner_position, in order.
[[nodiscard]] std::pmr::vector<ClippedCorner> clip_at_near(const Geometry& geometry, std::uint32_t object,
                                                           std::span<const std::uint32_t> corners,
                                                           ClipMemory& memory);

}  // namespace glint
