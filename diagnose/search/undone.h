#pragma once
// A wrong picture as it would be if nothing had happened to it at the display.

#include "diagnose/search/display_change.h"
#include "renderer/picture.h"

namespace glint {

/// The bytes of the picture the right way up, its channels in the scene's order, each level the one that the
/// change brings nearest to what stands there. What a change clamped or darkened away does not come back.
/// `linear` stays empty; what is soft stays so.
[[nodiscard]] Picture undone(const Picture& wrong, const DisplayChange& change);

}  // namespace glint
