#pragma once
// What the tabs of WHY are made of.

#include <string>

#include "models/scene/scene.h"
#include "ui/widgets/theme.h"

namespace glint {

struct UiState;

/// A word in its symbol's colour.
void coloured(Symbol symbol, const char* text);
/// A word that warns.
void warning_text(const std::string& text);
void wrapped_dim(const std::string& text);
/// In the small font.
void small_dim(const std::string& text);

/// A row: a name in its symbol's colour, and three figures.
void vector_line(Symbol symbol, const char* name, glm::vec3 v);

/// True when the mouse rests on the item drawn last and nothing is being dragged: then a panel may show
/// another scene than the edited one.
[[nodiscard]] bool is_pointed_at();
/// Whether a rectangle of the window drawn into is pointed at.
[[nodiscard]] bool is_pointed_at(ImVec2 low, ImVec2 high);

}  // namespace glint
