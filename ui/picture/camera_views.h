#pragma once
// Ways to look at the scene: from the front, the side or above, in perspective or in parallel, and views kept
// by hand. Pure functions of a camera.

#include <optional>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// Front looks along -z, Right along -x, Top along -y; the others from the opposite sides.
enum class ViewFrom { Front, Back, Right, Left, Top, Bottom };

/// The camera at the same distance from its target, on that side of it, y up. Above and below it stays a
/// tenth of a degree off the pole, where up would be along the view. Unchanged where `up` is not y and
/// the view would be along it.
[[nodiscard]] Camera seen_from(Camera camera, ViewFrom from);

/// Perspective and frustum become orthographic, orthographic becomes perspective; what is at the target's
/// depth keeps its size in the picture.
[[nodiscard]] Camera other_projection(Camera camera, PictureSize size);

inline constexpr std::size_t most_views = 8;

/// Keeps a view; one that is kept already is not kept twice, and the oldest of nine is forgotten.
void keep_view(std::vector<Camera>& views, const Camera& camera);

/// The view after the one that shows, from the first on again; nothing when none is kept.
[[nodiscard]] std::optional<Camera> next_view(const std::vector<Camera>& views, const Camera& shown);

}  // namespace glint
