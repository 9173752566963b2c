// The picked pixel, and the one picked before.
#include <glm/common.hpp>
#include <utility>

#include "ui/feature.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/viewport.h"
#include "ui/ui.h"

namespace glint {

void follow_shape(UiState& state, PictureSize size) {
    const PictureSize before = std::exchange(state.viewport.shares_of, size);
    if (before == size || before == PictureSize{0, 0}) return;
    // Converts shares to the plane at depth 1 and back. In that plane a point's position does not depend on
    // the picture's shape.
    const Projection& projection = state.editor.scene().camera.projection;
    const glm::dmat4 from = clip_from_view(projection, before), to = clip_from_view(projection, size);
    const glm::dvec2 scale(to[0][0] / from[0][0], to[1][1] / from[1][1]);
    const auto aspect = [](PictureSize of) { return double(of.width) / of.height; };
    const Reshape reshape{scale, {scale.x * aspect(size) / aspect(before), scale.y}};
    for (std::optional<glm::dvec2>* probe : {&state.viewport.probe, &state.viewport.probe_before})
        if (*probe) reshape.follow(**probe);
    for (const Feature* feature : features())
        if (feature->reshape != nullptr) feature->reshape(state, reshape);
}

void ask_about(ViewportState& state, std::optional<glm::dvec2> probe) {
    if (state.probe) state.probe_before = state.probe;
    state.probe = probe;
}

void ask_as_before(ViewportState& state) {
    const std::optional<glm::dvec2> before = state.probe_before;
    if (before) ask_about(state, before);
}

void step_probe(ViewportState& state, PictureSize size, glm::ivec2 step) {
    const std::optional<glm::ivec2> from = probe_pixel(state, size);
    const glm::ivec2 last(size.width - 1, size.height - 1);
    const glm::ivec2 to = from ? glm::clamp(*from + step, glm::ivec2(0), last) : (last + 1) / 2;
    const glm::dvec2 share = (glm::dvec2(to) + 0.5) / glm::dvec2(size.width, size.height);
    if (from)
        state.probe = share;  // stepping does not change the previously picked pixel
    else
        ask_about(state, share);
    state.touched = true;
}

std::optional<glm::ivec2> probe_pixel(const ViewportState& state, PictureSize size) {
    if (!state.probe || !is_inside(size, *state.probe * glm::dvec2(size.width, size.height))) return {};
    return nearest_pixel(size, *state.probe * glm::dvec2(size.width, size.height));
}

namespace {

bool forget_probe(UiState& state) {
    if (!state.viewport.probe) return false;
    ask_about(state.viewport, {});
    return true;
}

}  // namespace

extern const Feature probe_feature;
const Feature probe_feature{.escape = forget_probe};

}  // namespace glint
