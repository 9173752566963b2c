// The pixel asked about, and the one before.
#include <utility>

#include "ui/picture/viewport.h"

namespace glint {

void follow_shape(ViewportState& state, const Projection& projection, PictureSize size) {
    const PictureSize before = std::exchange(state.probe_size, size);
    if (before == size || before == PictureSize{0, 0}) return;
    // From shares to the plane at depth 1 and back: there the point has one place, whatever the picture's
    // shape.
    const glm::dmat4 from = clip_from_view(projection, before), to = clip_from_view(projection, size);
    const glm::dvec2 scale(to[0][0] / from[0][0], to[1][1] / from[1][1]);
    for (std::optional<glm::dvec2>* probe : {&state.probe, &state.probe_before})
        if (*probe) **probe = (**probe - 0.5) * scale + 0.5;
}

void ask_about(ViewportState& state, std::optional<glm::dvec2> probe) {
    if (state.probe) state.probe_before = state.probe;
    state.probe = probe;
}

void ask_as_before(ViewportState& state) {
    const std::optional<glm::dvec2> before = state.probe_before;
    if (before) ask_about(state, before);
}

std::optional<glm::ivec2> probe_pixel(const ViewportState& state, PictureSize size) {
    if (!state.probe || !is_inside(size, *state.probe * glm::dvec2(size.width, size.height))) return {};
    return nearest_pixel(size, *state.probe * glm::dvec2(size.width, size.height));
}

}  // namespace glint
