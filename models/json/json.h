#pragma once
// JSON: one tree for scenes, glTF, answers and the window's own files, strict reading, and writing for
// people. Source: RFC 8259; docs/scene_file.md.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "models/numbers.h"
#include "models/problem.h"

namespace glint {

/// Keeps the members of an object in their order. Looking a member up is linear; max_json_keys bounds it.
using Json = nlohmann::ordered_json;

inline constexpr std::size_t max_json_bytes = std::size_t{64} << 20;
inline constexpr std::size_t max_json_depth = 64;   // objects and arrays inside each other
inline constexpr std::size_t max_json_keys = 4096;  // in one object
/// No valid scene comes near it (10,000 objects of 40 values, 4096 lights of 50), and a text of nothing but
/// `[]` would take twenty times its size in memory.
inline constexpr std::size_t max_json_values = 2'000'000;

/// Reads a text that anyone may have written; a leading byte-order mark is skipped. Comments, duplicate keys,
/// invalid UTF-8, numbers that no double holds and more than the limits above are problems with `file`, the
/// line and, where there is one, the pointer.
[[nodiscard]] Result<Json> read_json(std::string_view text, const std::string& file);
/// Thrown by parsed_json() where the text is not JSON.
struct NotJson : ProblemFound {
    using ProblemFound::ProblemFound;
};
/// read_json(), but throws ProblemFound.
[[nodiscard]] Json parsed_json(std::string_view text, const std::string& file);

/// The value of a text that is known to be JSON, or whose damage does not matter: null where read_json()
/// refuses it.
[[nodiscard]] Json json_or_null(std::string_view text);

/// The member of that name; null if there is none or `json` is not an object.
[[nodiscard]] const Json* find_member(const Json& json, std::string_view name);
/// Its elements or members; none if it is not an array or not an object.
[[nodiscard]] const Json::array_t& elements_of(const Json& json);
[[nodiscard]] const Json::object_t& members_of(const Json& json);

/// A vector as an array of its components.
template <class T> [[nodiscard]] Json json_of(const glm::tvec2<T>& v) { return {v.x, v.y}; }
template <class T> [[nodiscard]] Json json_of(const glm::tvec3<T>& v) { return {v.x, v.y, v.z}; }

/// A float with the decimals of number_text(): 0.1, not 0.10000000149011612.
[[nodiscard]] inline Json number_json(float x) { return Json::parse(number_text(x)); }

/// A JSON string. Bytes that are not UTF-8 become U+FFFD and control characters (is_control()) escapes, so
/// that no printed text controls a terminal.
[[nodiscard]] std::string json_string(std::string_view text);
/// The value on one line without spaces. Numbers have the shortest form that reads back equal; those that are
/// not finite become null. Strings as json_string() writes them.
[[nodiscard]] std::string json_line(const Json& json);
/// The value for people to read: each key of an object on its own line, lists of plain values on one line, a
/// newline at the end.
[[nodiscard]] std::string json_text(const Json& json);

}  // namespace glint
