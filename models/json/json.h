#pragma once
// JSON: one representation for scenes, glTF, command output and the window's own files. Reads strictly and
// writes readable text. Source: RFC 8259; docs/scene_file.md.

#include <array>
#include <charconv>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/numbers.h"
#include "models/problem.h"

namespace glint {

/// Keeps the members of an object in order. Looking up a member takes linear time, bounded by max_json_keys.
using Json = nlohmann::ordered_json;

inline constexpr std::size_t max_json_bytes = std::size_t{64} << 20;
inline constexpr std::size_t max_json_depth = 64;   // nested objects and arrays
inline constexpr std::size_t max_json_keys = 4096;  // in one object
/// Valid scenes stay far below this (10,000 objects with 40 values each, 4096 lights with 50), and the limit
/// matters because a text of nothing but `[]` takes twenty times its size in memory.
inline constexpr std::size_t max_json_values = 2'000'000;

/// Reads an untrusted text; a leading byte-order mark is skipped. Comments, duplicate keys, invalid UTF-8,
/// numbers that a double cannot represent and texts that exceed the limits above are problems with `file`,
/// the line and, if known, the pointer.
[[nodiscard]] Result<Json> read_json(std::string_view text, const std::string& file);
/// Thrown by parsed_json() if the text is not JSON.
struct NotJson : ProblemFound {
    using ProblemFound::ProblemFound;
};
/// Like read_json(), but throws ProblemFound.
[[nodiscard]] Json parsed_json(std::string_view text, const std::string& file);

/// The value of a text that is known to be JSON, or that may be ignored if damaged: null if read_json()
/// rejects the text.
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

/// A JSON string. Invalid UTF-8 becomes U+FFFD and control characters (is_control()) become escapes, so
/// printed text cannot control a terminal.
[[nodiscard]] std::string json_string(std::string_view text);
/// The value on one line without spaces. Numbers have the shortest form from which the same value is read;
/// those that are not finite become null. Strings are written by json_string().
[[nodiscard]] std::string json_line(const Json& json);
/// The value as readable text: each key of an object on its own line, lists of plain values on one line, a
/// newline at the end.
[[nodiscard]] std::string json_text(const Json& json);

// JSON pointers, which also name a scene's numbers. Source: RFC 6901.

/// A reference token as it is escaped in a pointer: ~ as ~0, / as ~1.
[[nodiscard]] std::string escaped_token(std::string_view token);

/// Whether a pointer is `outer` or points into it: "/lights/0/position/1" is within "/lights/0".
[[nodiscard]] inline bool is_within(std::string_view pointer, std::string_view outer) {
    return pointer.starts_with(outer) && (pointer.size() == outer.size() || pointer[outer.size()] == '/');
}

/// An item of a list, and the rest of the pointer.
struct ListItem {
    int place = 0;
    std::string_view rest;
};

/// Returns the item of `list` that a pointer names or points into: 3 and "/position" for "/lights/3/position"
/// in "/lights/"; nullopt if it points elsewhere. Does not check the length of the list.
[[nodiscard]] inline std::optional<ListItem> item_in(std::string_view pointer, std::string_view list) {
    if (!pointer.starts_with(list)) return {};
    const char* const end = pointer.data() + pointer.size();
    ListItem item;
    const auto [rest, error] = std::from_chars(pointer.data() + list.size(), end, item.place);
    if (error != std::errc() || item.place < 0 || (rest != end && *rest != '/')) return {};
    item.rest = {rest, static_cast<std::size_t>(end - rest)};
    return item;
}

// Checked access to a JSON document: every value is read with its type and range. An error is thrown as a
// ProblemFound with the value's pointer; the catching function adds the file.

/// A value in a document, with its path from the root. A node lives on the stack, in a scope inside that of
/// its parent.
class Node {
  public:
    explicit Node(const Json& root) : value_(root) {}
    Node(const Json& value, const Node& parent, std::string_view key)
        : value_(value), parent_(&parent), key_(key) {}
    Node(const Json& value, const Node& parent, std::size_t index)
        : value_(value), parent_(&parent), index_(index) {}

    [[nodiscard]] const Json& value() const { return value_; }
    [[nodiscard]] std::string pointer() const;
    [[noreturn]] void fail(std::string what, std::string expected) const;
    /// Throws an error saying that the value has an unexpected type: `"abc" is a string; expected ...`.
    [[noreturn]] void wrong_type(std::string expected) const;

    /// Fails unless this is an object with no keys but these.
    void allow_keys(const std::vector<std::string>& known) const;
    [[nodiscard]] bool has(std::string_view key) const { return value_.contains(key); }
    /// Calls f(Node) with the value of that key, if the key exists. Precondition: allow_keys has passed.
    template <class F> void with(std::string_view key, F f) const {
        if (const auto found = value_.find(key); found != value_.end()) f(Node(*found, *this, key));
    }
    /// Calls f(Node) with every element. Fails unless this is an array of at most `max` elements.
    template <class F> void each(std::size_t max, std::string_view expected, F f) const {
        require_array(max, expected);
        for (std::size_t i = 0; i < value_.size(); ++i) f(Node(value_[i], *this, i));
    }

  private:
    void require_array(std::size_t max, std::string_view things) const;

    const Json& value_;
    const Node* parent_ = nullptr;
    std::string_view key_;
    std::size_t index_ = 0;
};

/// The number as a float. Both the written number and the float are checked: 1e-50 is above 0, but its float
/// is not.
[[nodiscard]] float number(const Node& node, const Range& range = any_number);
/// Reads an array of `least` to `most` numbers within `range`, unrounded.
[[nodiscard]] std::vector<double> numbers(const Node& node, std::size_t least, std::size_t most,
                                          const Range& range = any_number);
[[nodiscard]] const std::string& text(const Node& node, std::string_view expected = "a string");

/// Each of these reads the value of a key into `to`, and leaves `to` unchanged if the key is missing. A
/// string with more than `max_characters` fails; 0: unlimited.
void read(const Node& object, std::string_view key, bool& to);
void read(const Node& object, std::string_view key, std::string& to, std::size_t max_characters = 0);
void read(const Node& object, std::string_view key, float& to, const Range& range = any_number);
void read(const Node& object, std::string_view key, glm::vec3& to, const Range& range = any_number);

/// "a, b or c"
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

}  // namespace glint
