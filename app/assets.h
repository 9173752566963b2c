#pragma once
// What comes with the program: scenes, lessons.

#include <string>

namespace glint {

/// Returns the path of that file or folder below `assets`: beside the program, where it is installed, or in
/// the source tree whose build/PRESET/app holds the program. Empty if there is none.
[[nodiscard]] std::string asset_path(const std::string& relative);
/// Where asset_path() looks for it in an installed program, for messages.
[[nodiscard]] std::string asset_places(const std::string& relative);

}  // namespace glint
