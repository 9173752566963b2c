#pragma once
// A picture and the command line that draws it, in one step.

#include "ui/features/export/export_picture.h"

namespace glint {

/// Draws the picture into a new file of pictures_folder() and copies the command for it to the clipboard.
void save_with_command(UiState& state, const ExportOptions& options);
/// The same with the options of the scene's last export, or for the shown picture if there was none.
/// Precondition: the picture is drawn.
void save_with_command(UiState& state);

}  // namespace glint
