#pragma once
// Where the tests find the project and the program. Only places.cpp is compiled with these paths, so that
// what a compiler's cache kept of the other tests serves in every checkout.

#include <string>

namespace glint {

/// The folder of the project, an absolute path without a slash behind it.
extern const char* const project_folder;

/// The path of a file in it, such as "assets/scenes/default.json".
[[nodiscard]] std::string project_file(const std::string& path);

/// The path of the program that is tested.
extern const char* const glint_program;

}  // namespace glint
