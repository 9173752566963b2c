#pragma once
// JSON as Glint prints it, for people to read as well: an object's keys one a line, lists of plain values on
// one.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace glint {

/// Ends with a newline. Numbers in the shortest form that reads back equal; a `float` is printed as the
/// double that it is, so that nobody who adds the numbers meets a last bit that is not ours. Numbers that are
/// not finite become null, invalid UTF-8 the replacement character.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

}  // namespace glint
