#pragma once
// The paths of the project and of the program under test. Only places.cpp is compiled with these paths, so
// that the compiler cache for the other tests works in every checkout.

#include <string>

namespace glint {

/// The folder of the project, an absolute path without a trailing slash.
extern const char* const project_folder;

/// The path of a file in this folder, such as "assets/scenes/default.json".
[[nodiscard]] std::string project_file(const std::string& path);

/// The path of the program under test.
extern const char* const glint_program;

}  // namespace glint
