#pragma once
// What comes with the program: scenes, lessons.

#include <string>

namespace glint {

/// The file or folder of that path below `assets`: beside the program, where it is installed, or in the
/// source whose build/PRESET/app it lies in. Empty where there is none.
[[nodiscard]] std::string asset_path(const std::string& relative);

}  // namespace glint
