#pragma once
// JSON as a value: what commands answer in, and what the window remembers. nlohmann's library reads and
// writes it, in json_value.cpp only, because it takes each file that includes it seconds to compile. Scene
// files are read more strictly: models/json/json_reader.h.

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "models/problem.h"

namespace glint {

class JsonValue {
  public:
    using Elements = std::vector<JsonValue>;
    using Members = std::vector<std::pair<std::string, JsonValue>>;  // in the order in which they were set

    JsonValue() = default;  // null
    JsonValue(const JsonValue& other);
    JsonValue(JsonValue&& other) noexcept = default;
    JsonValue& operator=(const JsonValue& other) { return *this = JsonValue(other); }
    JsonValue& operator=(JsonValue&& other) noexcept = default;
    ~JsonValue() = default;
    template <class Number>
    requires std::is_arithmetic_v<Number> JsonValue(Number value) {
        if constexpr (std::is_same_v<Number, bool>)
            value_ = value;
        else if constexpr (std::is_integral_v<Number>)
            value_ = static_cast<std::int64_t>(value);
        else
            value_ = static_cast<double>(value);  // a float as the double that it is
    }
    JsonValue(const char* text) : value_(std::string(text)) {}
    JsonValue(std::string_view text) : value_(std::string(text)) {}
    JsonValue(std::string text) : value_(std::move(text)) {}
    template <class T>
    JsonValue(const std::vector<T>& values) : value_(Elements(values.begin(), values.end())) {}
    template <class T, std::size_t n>
    JsonValue(const std::array<T, n>& values) : value_(Elements(values.begin(), values.end())) {}
    /// An object when every value is a pair whose first is text, {{"x", 1}, {"y", 2}}; else an array.
    JsonValue(std::initializer_list<JsonValue> values);
    explicit JsonValue(Elements elements) : value_(std::move(elements)) {}
    /// Precondition: no name stands twice.
    explicit JsonValue(Members members) : value_(std::move(members)) {}
    [[nodiscard]] static JsonValue array();
    [[nodiscard]] static JsonValue object();

    /// Reads text that anyone may have written; nothing when it is not JSON, is nested deeper than 64, which
    /// no document of ours is, or has more than 2,000,000 values. Of two members of one name the last counts.
    [[nodiscard]] static std::optional<JsonValue> parse(std::string_view text);
    /// Reads a file that a person may have changed: as strict as for a scene, and a problem says what
    /// is wrong in which line of `file`.
    [[nodiscard]] static Result<JsonValue> read(std::string_view text, const std::string& file);

    [[nodiscard]] bool is_boolean() const { return std::holds_alternative<bool>(value_); }
    [[nodiscard]] bool is_whole_number() const { return std::holds_alternative<std::int64_t>(value_); }
    [[nodiscard]] bool is_number() const {
        return is_whole_number() || std::holds_alternative<double>(value_);
    }
    [[nodiscard]] bool is_string() const { return std::holds_alternative<std::string>(value_); }
    [[nodiscard]] bool is_array() const { return std::holds_alternative<Elements>(value_); }
    [[nodiscard]] bool is_object() const { return std::holds_alternative<Members>(value_); }

    /// Precondition of each: the value has that type.
    [[nodiscard]] bool boolean() const { return std::get<bool>(value_); }
    [[nodiscard]] double number() const;
    [[nodiscard]] const std::string& string() const { return std::get<std::string>(value_); }
    /// Empty when it is not an array, or no object.
    [[nodiscard]] const Elements& elements() const;
    [[nodiscard]] const Members& members() const;

    /// The member of that name; null where there is none, or where this is not an object.
    [[nodiscard]] const JsonValue* find(std::string_view name) const;
    /// The member of that name, made where there is none. Precondition: this is an object or null, which
    /// becomes one.
    JsonValue& operator[](std::string_view name);
    /// Precondition: this is an array or null, which becomes one.
    void push_back(JsonValue value);

    /// Bytes that it holds beside its own size: of its texts, elements and members.
    [[nodiscard]] std::uint64_t memory() const;

    /// The value on one line without spaces. Numbers have the shortest form that reads back equal; those that
    /// are not finite become null, invalid UTF-8 the replacement character.
    [[nodiscard]] std::string text() const;

    /// Compares numbers by value (1 equals 1.0), and objects with their members in order.
    friend bool operator==(const JsonValue& a, const JsonValue& b) {
        return a.is_number() && b.is_number() ? a.number() == b.number() : a.value_ == b.value_;
    }

  private:
    std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, Elements, Members> value_{nullptr};
};

/// A JSON string; bytes that are not UTF-8 become U+FFFD, control characters (is_control()) escapes: what is
/// printed commands no terminal.
[[nodiscard]] std::string json_string(std::string_view text);

/// JSON as Glint prints it, for people to read as well: an object's keys one a line, lists of plain values on
/// one, and a newline at the end.
[[nodiscard]] std::string json_text(const JsonValue& json);

}  // namespace glint
