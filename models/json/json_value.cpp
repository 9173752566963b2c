#include "models/json/json_value.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "models/io/utf8.h"
#include "models/json/json_reader.h"
#include "models/memory_limit.h"

namespace glint {
namespace {

/// Builds a value from the parser's events, whose names are the library's.
class ValueBuilder {
  public:
    [[nodiscard]] JsonValue take() && { return std::move(root_); }

    bool null() { return put({}); }
    bool boolean(bool b) { return put(b); }
    bool number_integer(std::int64_t n) { return put(n); }
    bool number_unsigned(std::uint64_t n) {
        return n <= std::uint64_t{INT64_MAX} ? put(n) : put(static_cast<double>(n));
    }
    bool number_float(double n, const std::string&) { return put(n); }
    bool string(std::string& s) { return put(std::move(s)); }
    bool binary(nlohmann::json::binary_t&) { return false; }  // not in JSON text

    bool start_object(std::size_t) { return open(true); }
    bool start_array(std::size_t) { return open(false); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        key_ = std::move(name);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) { return false; }

  private:
    /// An object or an array that is not closed yet.
    struct Open {
        std::string key;  // under which it will stand; unused in an array
        bool is_object = false;
        JsonValue::Elements elements;
        JsonValue::Members members;
        std::unordered_map<std::string, std::size_t> places;  // of the members, however many they are
    };

    bool put(JsonValue value) {
        if (++count_ > max_json_values) return false;
        if (open_.empty()) {
            root_ = std::move(value);
        } else if (Open& in = open_.back(); !in.is_object) {
            in.elements.push_back(std::move(value));
        } else if (const auto [place, is_new] = in.places.try_emplace(key_, in.members.size()); is_new) {
            in.members.emplace_back(key_, std::move(value));
        } else {
            in.members[place->second].second = std::move(value);
        }
        return true;
    }
    bool open(bool is_object) {
        open_.push_back({std::move(key_), is_object, {}, {}, {}});
        return open_.size() <= max_json_depth;
    }
    /// Puts a container where it belongs when it is complete, so that nothing moves while it is built.
    bool close() {
        Open done = std::move(open_.back());
        open_.pop_back();
        key_ = std::move(done.key);
        return put(done.is_object ? JsonValue(std::move(done.members)) : JsonValue(std::move(done.elements)));
    }

    std::vector<Open> open_;  // outermost first
    std::string key_;
    JsonValue root_;
    std::size_t count_ = 0;
};

/// Writes the shortest form that reads back equal; null when it is not finite.
std::string number_text(double value) { return nlohmann::json(value).dump(); }

bool is_structured(const JsonValue& json) { return json.is_array() || json.is_object(); }

bool is_row(const JsonValue& json) {
    return json.is_array() && std::none_of(json.elements().begin(), json.elements().end(), is_structured);
}

std::string row(const JsonValue& json) {
    std::string text = "[";
    for (const JsonValue& item : json.elements())
        text.append(text.size() > 1 ? ", " : "").append(item.text());
    return text + "]";
}

/// Writes one entry per line after its indentation, with write(), between two brackets.
template <class Entries, class Write>
void append_lines(std::string& text, const Entries& entries, std::string_view brackets, std::size_t indent,
                  Write write) {
    text += brackets[0];
    text += '\n';
    std::size_t left = entries.size();
    for (const auto& entry : entries) {
        text.append(indent + 2, ' ');
        write(entry);
        text += --left > 0 ? ",\n" : "\n";
    }
    text.append(indent, ' ') += brackets[1];
}

void append(std::string& text, const JsonValue& json, std::size_t indent) {
    if (is_row(json)) {
        text += row(json);
    } else if (!json.elements().empty()) {
        append_lines(text, json.elements(), "[]", indent,
                     [&](const JsonValue& item) { append(text, item, indent + 2); });
    } else if (!json.members().empty()) {
        append_lines(text, json.members(), "{}", indent, [&](const auto& member) {
            text += json_string(member.first) + ": ";
            append(text, member.second, indent + 2);
        });
    } else {
        text += json.text();
    }
}

}  // namespace

/// The variant's own copy is not used: where every alternative moves without throwing, libstdc++ 12 treats a
/// variant whose copying ran out of memory as complete, and destroys a value that does not exist.
JsonValue::JsonValue(const JsonValue& other) {
    std::visit([this](auto copy) { value_ = std::move(copy); }, other.value_);
}

JsonValue::JsonValue(std::initializer_list<JsonValue> values) {
    const bool is_object = std::all_of(values.begin(), values.end(), [](const JsonValue& v) {
        return v.elements().size() == 2 && v.elements().front().is_string();
    });
    if (!is_object) {
        value_ = Elements(values);
        return;
    }
    value_ = Members();
    for (const JsonValue& pair : values) (*this)[pair.elements()[0].string()] = pair.elements()[1];
}

JsonValue JsonValue::array() { return JsonValue(Elements()); }
JsonValue JsonValue::object() { return JsonValue(Members()); }

std::optional<JsonValue> JsonValue::parse(std::string_view text) {
    if (text.find('\0') != std::string_view::npos) return std::nullopt;  // the library would end there
    ValueBuilder builder;
    if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) return std::nullopt;
    return std::move(builder).take();
}

Result<JsonValue> JsonValue::read(std::string_view text, const std::string& file) {
    try {
        Json strict = read_json(text, file);
        take_apart(strict);
    } catch (ProblemFound& found) {
        return std::move(found.problem);
    }
    if (std::optional<JsonValue> value = parse(text)) return *std::move(value);
    return Problem{file, "", "this is not JSON", "JSON"};
}

double JsonValue::number() const {
    const auto* whole = std::get_if<std::int64_t>(&value_);
    return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(value_);
}

const JsonValue::Elements& JsonValue::elements() const {
    static const Elements none;
    return is_array() ? std::get<Elements>(value_) : none;
}

const JsonValue::Members& JsonValue::members() const {
    static const Members none;
    return is_object() ? std::get<Members>(value_) : none;
}

const JsonValue* JsonValue::find(std::string_view name) const {
    for (const auto& [key, value] : members())
        if (key == name) return &value;
    return nullptr;
}

JsonValue& JsonValue::operator[](std::string_view name) {
    if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Members();
    auto& members = std::get<Members>(value_);
    for (auto& [key, value] : members)
        if (key == name) return value;
    return members.emplace_back(name, JsonValue()).second;
}

void JsonValue::push_back(JsonValue value) {
    if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Elements();
    std::get<Elements>(value_).push_back(std::move(value));
}

std::string JsonValue::text() const {
    if (is_boolean()) return boolean() ? "true" : "false";
    if (is_whole_number()) return std::to_string(std::get<std::int64_t>(value_));
    if (is_number()) return number_text(number());
    if (is_string()) return json_string(string());
    if (!is_array() && !is_object()) return "null";
    std::string text(1, is_array() ? '[' : '{');
    const auto separate = [&text] {
        if (text.size() > 1) text += ',';
    };
    for (const JsonValue& item : elements()) {
        separate();
        text += item.text();
    }
    for (const auto& [name, value] : members()) {
        separate();
        text.append(json_string(name)).append(1, ':').append(value.text());
    }
    text += is_array() ? ']' : '}';
    return text;
}

std::uint64_t JsonValue::memory() const {
    if (is_string()) return bytes_outside(string());
    std::uint64_t bytes = 0;
    if (const auto* elements = std::get_if<Elements>(&value_)) {
        bytes = elements->capacity() * sizeof(JsonValue);
        for (const JsonValue& element : *elements) bytes += element.memory();
    } else if (const auto* members = std::get_if<Members>(&value_)) {
        bytes = members->capacity() * sizeof(Members::value_type);
        for (const auto& [name, value] : *members) bytes += bytes_outside(name) + value.memory();
    }
    return bytes;
}

std::string json_string(std::string_view raw) {
    std::string text = "\"";
    for (std::size_t i = 0; i < raw.size();) {
        const std::size_t length = utf8_length(raw.substr(i, 4));
        const char c = raw[i];
        if (length == 0)
            text += "\uFFFD";
        else if (c == '"' || c == '\\')
            text.append(1, '\\').append(1, c);
        else if (c == '\n')
            text += "\\n";
        else if (c == '\t')
            text += "\\t";
        else if (is_control(raw.substr(i, length)))
            text += fmt::format("\\u{:04x}", static_cast<unsigned>(code_point(raw.substr(i, length))));
        else
            text += raw.substr(i, length);
        i += std::max<std::size_t>(1, length);
    }
    return text + "\"";
}

std::string json_text(const JsonValue& json) {
    // A value takes about as many bytes as its text does, which is there twice while it grows. What is small,
    // such as the window's own files, is not asked for.
    constexpr std::uint64_t small = 1 << 20;
    const std::uint64_t bytes = json.memory();
    const MemoryShare share(memory_need(MemoryUse::Output, bytes > small ? 3 * bytes : 0));
    std::string text;
    append(text, json, 0);
    text += '\n';
    return text;
}

}  // namespace glint
