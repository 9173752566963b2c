#pragma once
// What palette_entries() is put together from.

#include "ui/commands/menus.h"

namespace glint {

/// A name as files and commands write it, "spot-cone" or "lit_in_srgb", in words.
[[nodiscard]] std::string with_spaces(std::string name);

/// Adds an entry for each field of the scene: it shows the panel and puts the keyboard into the field.
void add_fields(std::vector<PaletteEntry>& entries, const UiState& state);

/// An entry for each switch and each choice of shading, strokes and display that no command sets.
void add_settings(std::vector<PaletteEntry>& entries, const UiState& state);

}  // namespace glint
