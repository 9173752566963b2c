#pragma once
// The vectors of the equation at the picked point: in both frames, in the plane of incidence, and how r and
// the facet's normal come about.

#include <imgui.h>

#include "renderer/inspect/explain/explanation.h"
#include "ui/inspector/state.h"

namespace glint {

struct UiState;
struct PictureView;

void vectors_tab(UiState& state, const PictureView& view);

// r = 2 n (n·l) − l in four steps, with a slider for the length of n.

/// Numbers in the frame that the column shows; the picture draws the chosen step.
void mirror_section(InspectorState& state, const ExplainedPoint& point, const ExplainedLight& light);

// The plane of incidence at the picked point, seen from the side: n up, l, r, h and v with their angles, and
// the lobe of what this surface reflects of this light.

/// Draws it as wide as the column. The lobe is that of renderer/inspect/lobes, in the channel chosen in the
/// equation.
void lobe_diagram(const UiState& state, const ExplainedPoint& point, const ExplainedLight& light);

// n, l, v and r or h drawn at the picked point in the picture, with their angles; the corners that a Gouraud
// pixel is mixed from; the facet's edges and normal.

/// Nothing while they are switched off or no object is picked. They are drawn over what stands before them.
void draw_point_vectors(ImDrawList& list, const UiState& state, const PictureView& view);

}  // namespace glint
