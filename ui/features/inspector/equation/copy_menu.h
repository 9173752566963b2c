#pragma once
// The context menu of a read-only number: copies the number, or the line that contains it.

#include <string>

namespace glint {

/// Opens on a right click on the item drawn last. `number`: as displayed. An empty `line` is not offered.
/// `id` distinguishes numbers at the same position.
void copy_menu(int id, const std::string& number, const std::string& line);

}  // namespace glint
