#pragma once
// Which of the picked point's lights another object would keep away, if illumination here were not local.

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "renderer/inspect/explain/explanation.h"

namespace glint {

struct UiState;

struct BlockedState {
    std::uint64_t serial = 0;  // UiState::picture_serial, pixel and corner that `by` is of
    glm::ivec2 pixel{-1};
    int corner = -1;
    std::vector<int> by;  // per light of the point: the object's index, or -1
};

/// "Teapot stands in the way: no shadow is cast, light here is local"; empty where the way is free, where the
/// light is behind the surface anyway, and while the mouse drags something in a scene so large that asking
/// would take time. `which`: index into `point.lights`.
[[nodiscard]] std::string blocked_words(UiState& state, const Explanation& explanation,
                                        const ExplainedPoint& point, std::size_t which);

}  // namespace glint
