#pragma once
// The menu of a number that can only be read: a right click copies it, or the line that it stands in.

#include <string>

namespace glint {

/// Offers to copy from the item drawn last, on a right click. `number` is as it is written; an empty `line`
/// is not offered. `id` tells the numbers of one position apart.
void copy_menu(int id, const std::string& number, const std::string& line);

}  // namespace glint
