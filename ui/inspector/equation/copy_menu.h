#pragma once
// The menu of a number that can only be read: a right click copies it, or the line that it stands in.

#include <string>

namespace glint {

/// Of the item drawn last. `number` is as it is written; an empty `line` is not offered. `id` tells numbers
/// of one place apart.
void copy_menu(int id, const std::string& number, const std::string& line);

}  // namespace glint
