#pragma once
// What a killed process has left: temporary files (models/io/temporary.h) that nobody writes any more.

#include <string>

namespace glint {

/// Removes those of this user in `directory`, a path that ends with "/", or "" for the working directory; once
/// for each directory. Where memory runs out, a later process does.
void remove_left_files(const std::string& directory) noexcept;

}  // namespace glint
