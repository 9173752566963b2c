#pragma once
// Checked access to a JSON document: every value is read with its type and range. An error is thrown as a
// ProblemFound with the value's pointer; the catching function adds the file.

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "models/json/json.h"
#include "models/range.h"

namespace glint {

/// A value in a document, with its path from the root. It lives on the stack, in a scope inside its parent's.
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
    /// Calls f(Node) with the value of that key, if it exists. Precondition: allow_keys has passed.
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

/// The number as a float. Both the written number and the float are checked: 1e-50 is above 0, its float is
/// not.
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
