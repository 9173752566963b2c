#pragma once
// Which mistakes are made together: none, one, or two. Numbers are places in mistake_names().

#include <cstddef>
#include <string>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

using MistakeSet = std::vector<std::size_t>;  // ascending

/// The scene under these mistakes and no others.
[[nodiscard]] Scene under_mistakes(Scene scene, const MistakeSet& mistakes);
/// "unnormalized_light", "a + b"; "right" for none.
[[nodiscard]] std::string name_of(const MistakeSet& mistakes);

}  // namespace glint
