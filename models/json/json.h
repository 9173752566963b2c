#pragma once
// JSON: one representation for scenes, glTF, output of commands and the window's own files. Reads strictly
// and writes readable text. Source: RFC 8259; docs/scene_file.md.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "models/numbers.h"
#include "models/problem.h"

namespace glint {

/// Keeps the members of an object in their order. Looking up a member is linear; max_json_keys bounds it.
using Json = nlohmann::ordered_json;

inline constexpr std::size_t max_json_bytes = std::size_t{64} << 20;
inline constexpr std::size_t max_json_depth = 64;   // nested objects and arrays
inline constexpr std::size_t max_json_keys = 4096;  // in one object
/// Valid scenes stay far below this (10,000 objects of 40 values, 4096 lights of 50), and a text made only of
/// `[]` would take twenty times its size in memory.
inline constexpr std::size_t max_json_values = 2'000'000;

/// Reads an untrusted text; a leading byte-order mark is skipped. Comments, duplicate keys, invalid UTF-8,
/// numbers that a double cannot represent and more than the limits above are problems with `file`, the line
/// and, if known, the pointer.
[[nodiscard]] Result<Json> read_json(std::string_view text, const std::string& file);
/// Thrown by parsed_json() if the text is not JSON.
struct NotJson : ProblemFound {
    using ProblemFound::ProblemFound;
};
/// Like read_json(), but throws ProblemFound.
[[nodiscard]] Json parsed_json(std::string_view text, const std::string& file);

/// The value of a text that is known to be JSON, or that may be ignored if damaged: null if read_json()
/// rejects it.
[[nodiscard]] Json json_or_null(std::string_view text);

/// The member with that name; null if it does not exist or `json` is not an object.
[[nodiscard]] const Json* find_member(const Json& json, std::string_view name);
/// The elements or members of a value; empty unless it is an array or an object.
[[nodiscard]] const Json::array_t& elements_of(const Json& json);
[[nodiscard]] const Json::object_t& members_of(const Json& json);

/// A vector as an array of its components.
template <class T> [[nodiscard]] Json json_of(const glm::tvec2<T>& v) { return {v.x, v.y}; }
template <class T> [[nodiscard]] Json json_of(const glm::tvec3<T>& v) { return {v.x, v.y, v.z}; }

/// A float with the decimals of number_text(): 0.1 instead of 0.10000000149011612.
[[nodiscard]] inline Json number_json(float x) { return Json::parse(number_text(x)); }

/// A JSON string. Invalid UTF-8 becomes U+FFFD and control characters (is_control()) become escapes, so that
/// no printed text controls a terminal.
[[nodiscard]] std::string json_string(std::string_view text);
/// The value on one line without spaces. Numbers have the shortest form that reads back equal; those that are
/// not finite become null. Strings are written by json_string().
[[nodiscard]] std::string json_line(const Json& json);
/// The value as readable text: each key of an object on its own line, lists of plain values on one line, a
/// newline at the end.
[[nodiscard]] std::string json_text(const Json& json);

}  // namespace glint
