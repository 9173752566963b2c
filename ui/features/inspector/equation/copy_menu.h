#pragma once
// The menu of a read-only number: a right click copies it, or its line.

#include <string>

namespace glint {

/// Offers to copy from the item drawn last, on a right click. `number` is as written; an empty `line` is not
/// offered. `id` distinguishes numbers at the same position.
void copy_menu(int id, const std::string& number, const std::string& line);

}  // namespace glint
