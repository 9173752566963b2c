#pragma once
// Finds how a picture differs apart from its surfaces' colours: background, anti-aliased edges, shift.

#include "diagnose/diagnose.h"

namespace glint {

/// `drawn`: the drawing that explains the picture under `change`.
[[nodiscard]] DisplayFinding display_finding(const Exhibit& exhibit, const Drawing& drawn,
                                             const DisplayChange& change);

/// Whether the picture's background is neither the drawing's nor what the change makes of that.
[[nodiscard]] bool has_other_background(const Exhibit& exhibit, const Drawing& drawn,
                                        const DisplayChange& change);

/// Whether the picture, turned so, shows something in much of what is background in the scene.
[[nodiscard]] bool covers_background(const Exhibit& exhibit, const DisplayChange& turned);

/// Why the picture cannot be of this scene; nothing where its outline is the scene's, or cannot be told.
[[nodiscard]] std::optional<std::string> other_outline(const Exhibit& exhibit);

}  // namespace glint
