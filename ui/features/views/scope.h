#pragma once
// The scan-line scope samples a line over the picture and plots its intensity with first and second
// differences below the picture, so that Mach bands can be read off. Lecture: "Gouraud Shading
// Artifacts".

#include <imgui.h>

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "renderer/debug_views/profile.h"
#include "ui/picture/screen.h"
#include "ui/picture/tool.h"
#include "ui/widgets/area.h"

namespace glint {

struct ScopeState {
    enum class Hand { None, From, To, Line, New, Card };

    bool open = false;   // the line and the panel are shown
    bool armed = false;  // the next drag over the picture draws the line
    // Ends of the line, and the grey card's centre and size, as fractions of the picture's size.
    glm::dvec2 from{0.02, 0.5}, to{0.98, 0.5};
    bool card = false;
    glm::dvec2 card_at{0.5}, card_size{0.1, 0.3};
    bool channels = false;    // red, green and blue separately, in place of luminance
    bool eye = false;         // also plots the perceived curve
    double surround_px = 12;  // standard deviation of the wide mean in the eye model
    int hovered = -1;         // index of the hovered sample in the panel
    // The part that is being dragged:
    Hand hand = Hand::None;
    Hand under = Hand::None;  // what a press would grab
    glm::dvec2 last{0};       // the last cursor position, as a fraction

    std::vector<ProfileSample> samples;  // samples of the picture on the screen
    std::vector<double> seen;            // perceived intensity; empty unless requested
};

/// Draws the panel below the picture, with intensity along the scope's line, over `area`. `size` is
/// that of the sampled picture. True if the command line should be copied.
[[nodiscard]] bool scope_panel(ScopeState& scope, const Rect& area, PictureSize size);

/// The pixel at a position that is given as a fraction of the picture's size.
[[nodiscard]] glm::ivec2 pixel_of(glm::dvec2 share, PictureSize size);

/// Resets the line to horizontal through the picture's centre, since its old position has no meaning in a
/// different scene.
void lay_level(ScopeState& scope);

extern const Tool scope_tool;
/// Draws the line, its ends, the card, and the sample hovered in the panel.
void draw_scope_line(ImDrawList& list, UiState& state, const PictureView& view);

/// Opens the scope with its tool active, or closes it.
void toggle_scope(ScopeState& scope);

/// Samples the line in a picture that was drawn with `linear`.
void update_scope(ScopeState& scope, const Renderer& renderer, const Picture& picture);

/// Places the card to the right of the sharpest bend of the curve, with its edge on the pixel of the bend.
void place_card(ScopeState& scope, PictureSize size);
/// Shows the card, placed by place_card(), or hides it.
void switch_card(ScopeState& scope, PictureSize size);

/// A position along the line, between two samples, at which the visible triangle changes.
struct ScopeEdge {
    double position = 0;       // measured like ProfileSample::position
    bool is_diagonal = false;  // within a polygon: an edge of its triangulation
    bool operator==(const ScopeEdge&) const = default;
};
[[nodiscard]] std::vector<ScopeEdge> edges_along(const std::vector<ProfileSample>& samples);

/// Describes the samples: "384 pixels, 1 edge, 2 diagonals".
[[nodiscard]] std::string edge_words(const std::vector<ProfileSample>& samples);

}  // namespace glint
