#pragma once
// A picture and the command line that draws it, in one step.

#include "ui/export/export_picture.h"

namespace glint {

/// Draws the picture into a new file of the working directory and puts the command for it onto the clipboard.
void save_with_command(UiState& state, const ExportOptions& options);
/// The same as it was exported last, else as it is shown. Precondition: it is drawn.
void save_with_command(UiState& state);

}  // namespace glint
