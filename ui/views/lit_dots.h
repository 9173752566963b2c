#pragma once
// Where the equation is evaluated: a dot at each face's point, corner or pixel, thinned; its normal as a
// needle; and how often it is evaluated a frame. Lecture: "Flat Shading", "Gouraud Shading", "Phong Shading".

#include <imgui.h>

#include <cstdint>
#include <vector>

#include "renderer/renderer.h"
#include "ui/picture/picture_view.h"

namespace glint {

struct LitDot {
    glm::vec3 place{0}, normal{0};  // world
    glm::vec3 color{0};             // what the equation gives there, linear
};

struct LitDotsState {
    bool dots = false, needles = false;
    std::vector<LitDot> found;
    std::uint64_t found_for = 0;  // the picture's serial; 0: none yet
    bool thinned = false;         // not every place is among them
};

/// The places at which the equation was evaluated for pixels of a grid of about `across` columns over the
/// last picture: each corner or face's point once.
[[nodiscard]] std::vector<LitDot> lit_dots(const Renderer& renderer, PictureSize size, int across);

/// Looks for them again when the picture is another.
void update_lit_dots(LitDotsState& state, const Renderer& renderer, PictureSize size, std::uint64_t serial);

/// "corners: 5 321 × 4 lights = 21 284 evaluations a frame".
[[nodiscard]] std::string evaluations_text(const Renderer& renderer, const Scene& scene);

void draw_lit_dots(ImDrawList& list, const LitDotsState& state, const Renderer& renderer, const Scene& scene,
                   const PictureView& view);

}  // namespace glint
