#pragma once
// One light's part of the equation at the picked point, its numbers where they stand.

#include "renderer/inspect/explain/explanation.h"

namespace glint {

struct UiState;
struct TermLine;

/// Name, angles, what all terms are multiplied by, and the three terms as products of the chosen channel.
/// `which`: of point.lights. Numbers of the scene can be dragged; pointing at the name shows the light alone,
/// at a term that term of this light alone, at a letter its arrow.
void light_card(UiState& state, const Explanation& why, const ExplainedPoint& point, std::size_t which);

/// letter = factor × factor … = result. True when a number was edited.
bool draw_term_line(const TermLine& line);

}  // namespace glint
