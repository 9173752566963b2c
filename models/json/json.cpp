#include "models/json/json.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "models/numbers.h"
#include "models/progress.h"
#include "models/utf8.h"

namespace glint {
namespace {

double checked_number(const Node& node, const Range& range, std::string_view expected) {
    if (!node.value().is_number()) node.wrong_type(std::string(expected));
    const double x = node.value().get<double>();
    if (!range.contains(x) || !range.contains(static_cast<float>(x)))
        node.fail(fmt::format("{} is out of range", x), std::string(range.words));
    return x;
}

}  // namespace

std::string Node::pointer() const {
    if (parent_ == nullptr) return "";
    const bool in_array = parent_->value_.is_array();
    return parent_->pointer() + "/" + (in_array ? std::to_string(index_) : escaped_token(key_));
}

void Node::fail(std::string what, std::string expected) const {
    throw ProblemFound({"", pointer(), std::move(what), std::move(expected)});
}

void Node::wrong_type(std::string expected) const {
    const auto what = [this]() -> std::string {
        switch (value_.type()) {
        case Json::value_t::object:
            return "the value is an object";
        case Json::value_t::array:
            return "the value is an array";
        case Json::value_t::string:
            return in_quotes(value_.get_ref<const std::string&>()) + " is a string";
        case Json::value_t::boolean:
            return value_.get<bool>() ? "true is not allowed here" : "false is not allowed here";
        case Json::value_t::null:
            return "null is not a value";
        default:
            return fmt::format("{} is a number", value_.get<double>());
        }
    };
    fail(what(), std::move(expected));
}

void Node::allow_keys(const std::vector<std::string>& known) const {
    if (!value_.is_object()) wrong_type("an object");
    for (const auto& [key, value] : value_.items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        const std::string near = nearest(key, known);
        Node(value, *this, key)
            .fail("unknown key " + in_quotes(key), near.empty() ? "no key at all" : in_quotes(near));
    }
}

void Node::require_array(std::size_t max, std::string_view things) const {
    if (!value_.is_array()) wrong_type(fmt::format("an array of {}", things));
    if (value_.size() > max)
        fail(fmt::format("{} {}", value_.size(), things), fmt::format("at most {}", max));
}

float number(const Node& node, const Range& range) {
    return static_cast<float>(checked_number(node, range, "a number"));
}

std::vector<double> numbers(const Node& node, std::size_t least, std::size_t most, const Range& range) {
    const std::string expected =
        least == most ? fmt::format("{} numbers", least) : fmt::format("{} or {} numbers", least, most);
    const Json& value = node.value();
    if (!value.is_array()) node.wrong_type("an array of " + expected);
    if (value.size() < least || value.size() > most)
        node.fail(fmt::format("an array of {}", value.size()), expected);
    std::vector<double> result;
    for (std::size_t i = 0; i < value.size(); ++i)
        result.push_back(checked_number(Node(value[i], node, i), range, "a number"));
    return result;
}

const std::string& text(const Node& node, std::string_view expected) {
    if (!node.value().is_string()) node.wrong_type(std::string(expected));
    return node.value().get_ref<const std::string&>();
}

void read(const Node& object, std::string_view key, bool& to) {
    object.with(key, [&to](const Node& node) {
        if (!node.value().is_boolean()) node.wrong_type("true or false");
        to = node.value().get<bool>();
    });
}

void read(const Node& object, std::string_view key, std::string& to, std::size_t max_characters) {
    object.with(key, [&](const Node& node) {
        to = text(node);
        if (max_characters == 0) return;
        const std::size_t count = count_characters(to);
        if (count > max_characters)
            node.fail(fmt::format("has {} characters", count), fmt::format("at most {}", max_characters));
    });
}

void read(const Node& object, std::string_view key, float& to, const Range& range) {
    object.with(key, [&](const Node& node) { to = number(node, range); });
}

void read(const Node& object, std::string_view key, glm::vec3& to, const Range& range) {
    object.with(key, [&](const Node& node) {
        const std::vector<double> v = numbers(node, 3, 3, range);
        to = glm::vec3(v[0], v[1], v[2]);
    });
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
        text += words[i];
    }
    return text;
}

// Writes JSON.

namespace {

bool is_row(const Json& json) {
    return json.is_array() &&
           std::none_of(json.begin(), json.end(), [](const Json& item) { return item.is_structured(); });
}

void append_line(std::string& text, const Json& json, std::string_view comma) {
    auto separate = [&text, comma, is_first = true]() mutable {
        if (!std::exchange(is_first, false)) text += comma;
    };
    if (json.is_string()) {
        text += json_string(json.get_ref<const std::string&>());
    } else if (json.is_array()) {
        text += '[';
        for (const Json& item : json) {
            separate();
            append_line(text, item, comma);
        }
        text += ']';
    } else if (json.is_object()) {
        text += '{';
        for (const auto& [name, value] : json.items()) {
            separate();
            text.append(json_string(name)).append(1, ':');
            append_line(text, value, comma);
        }
        text += '}';
    } else {
        text += json.dump();
    }
}

/// Writes one entry per line with write(), indented and between two brackets.
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

void append(std::string& text, const Json& json, std::size_t indent) {
    if (is_row(json)) {
        append_line(text, json, ", ");
    } else if (json.is_array()) {
        append_lines(text, json, "[]", indent, [&](const Json& item) { append(text, item, indent + 2); });
    } else if (json.is_object() && !json.empty()) {
        append_lines(text, json.get_ref<const Json::object_t&>(), "{}", indent, [&](const auto& member) {
            text += json_string(member.first) + ": ";
            append(text, member.second, indent + 2);
        });
    } else {
        append_line(text, json, ",");
    }
}

}  // namespace

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

std::string json_line(const Json& json) {
    std::string text;
    append_line(text, json, ",");
    return text;
}

std::string json_text(const Json& json) {
    std::string text;
    append(text, json, 0);
    text += '\n';
    return text;
}

// Strict reading: finds where the library stopped, and describes the error in our own messages.

namespace {

constexpr std::string_view white_space = " \t\r\n";

/// The last item that the parser accepted.
enum class JsonEvent { Nothing, Key, Value, OpenedObject, OpenedArray };
enum class JsonContainer { None, Object, Array };

/// The position at which the parser stopped.
struct JsonStop {
    std::string_view text;
    std::size_t understood = 0;  // end of the accepted text
    std::size_t reached = 0;     // end of the text read
    JsonEvent last = JsonEvent::Nothing;
    JsonContainer container = JsonContainer::None;  // around that position
};

struct Fault {
    std::size_t place;  // the first unexpected character
    std::string_view expected;
    bool string_fits;  // a string is allowed here
};

/// The first character at or after `place` that is not white space.
std::size_t skip_space(std::string_view text, std::size_t place) {
    return std::min(text.find_first_not_of(white_space, place), text.size());
}

/// A key must be followed by a colon, and a value in a container by a comma. The fault is the character found
/// instead, or the text after it.
Fault fault_of(const JsonStop& stop) {
    const std::size_t next = skip_space(stop.text, stop.understood);
    const char c = next < stop.text.size() ? stop.text[next] : '\0';
    const bool in_object = stop.container == JsonContainer::Object;
    switch (stop.last) {
    case JsonEvent::Nothing:
        return {next, "an object, such as {\"glint\": 1}", true};
    case JsonEvent::OpenedObject:
        return {next, "a key in quotes or \"}\"", true};
    case JsonEvent::OpenedArray:
        return {next, "a value or \"]\"", true};
    case JsonEvent::Key:
        if (c != ':') return {next, "\":\" after the key", false};
        return {skip_space(stop.text, next + 1), "a value", true};
    case JsonEvent::Value:
        if (stop.container == JsonContainer::None) return {next, "the end of the text", false};
        if (c != ',') return {next, in_object ? "\",\" or \"}\"" : "\",\" or \"]\"", false};
        return {skip_space(stop.text, next + 1), in_object ? "a key in quotes" : "a value", true};
    }
    return {};  // not reached
}

/// The word or number that starts here, or a single character.
std::string_view word_at(std::string_view text) {
    const auto in_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' ||
               c == '-';
    };
    const auto length = std::find_if_not(text.begin(), text.end(), in_word) - text.begin();
    return length > 0 ? text.substr(0, static_cast<std::size_t>(length)) : text.substr(0, utf8_length(text));
}

/// Whether the string that starts here has its closing quote.
bool is_closed(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); i += text[i] == '\\' ? 2 : 1)
        if (text[i] == '"') return true;
    return false;
}

/// `rest`: the text from the beginning of the string on.
Problem broken_string(const JsonStop& stop, std::string_view rest) {
    if (stop.reached >= stop.text.size() && !is_closed(rest))
        return {"", "", "a string that does not end", "\" after it"};
    if (static_cast<unsigned char>(stop.text[stop.reached - 1]) < 0x20)
        return {"", "", "a control character in a string", "an escape: \\n, \\t, or \\u and four hex digits"};
    return {"", "", "an escape that JSON does not have",
            "\\\", \\\\, \\/, \\b, \\f, \\n, \\r, \\t, or \\u and four hex digits, surrogates in pairs"};
}

/// The line, the error and the expected text; without the file.
Problem syntax_problem(const JsonStop& stop) {
    const Fault fault = fault_of(stop);
    const std::string_view rest = stop.text.substr(fault.place);
    const std::string expected(fault.expected);
    const auto problem = [&]() -> Problem {
        if (rest.empty() && stop.last == JsonEvent::Nothing) return {"", "", "the text is empty", expected};
        if (rest.empty()) return {"", "", "the text ends too early", expected};
        if (rest.starts_with('/'))
            return {"", "", "a comment or a stray slash", "JSON, which has no comments"};
        if (!rest.starts_with('"')) return {"", "", "unexpected " + in_quotes(word_at(rest)), expected};
        if (fault.string_fits) return broken_string(stop, rest);
        return {"", "", "unexpected " + in_quotes(rest.substr(1, rest.find('"', 1) - 1)), expected};
    }();
    const std::size_t last = stop.text.find_last_not_of(white_space);  // for a text that ends too early
    const int line = line_of(stop.text, last == std::string_view::npos ? 0 : std::min(fault.place, last));
    return {"", "", problem.what, problem.expected, line};
}

/// An iterator that reports its position: the library's events have no positions.
struct CountingIterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at = nullptr;
    const char** reached = nullptr;

    reference operator*() const { return *at; }
    CountingIterator& operator++() {
        *reached = ++at;
        return *this;
    }
    bool operator==(const CountingIterator& o) const { return at == o.at; }
};

/// Builds the document from the parser's events and rejects anything that a document must not contain. The
/// library defines the names of the events.
class Builder {
  public:
    Builder(std::string_view text, const std::string& file)
        : text_(text), file_(file), reached_(text.data()), parsed_(text.size()) {}

    Json take() && { return std::move(root_); }
    [[nodiscard]] CountingIterator begin() { return {text_.data(), &reached_}; }
    [[nodiscard]] CountingIterator end() { return {text_.data() + text_.size(), &reached_}; }

    bool null() { return put(nullptr); }
    bool boolean(bool b) { return put(b); }
    bool number_integer(std::int64_t n) { return number(n); }
    bool number_unsigned(std::uint64_t n) { return number(n); }
    bool number_float(double n, const std::string&) { return number(n); }
    bool string(std::string& s) { return put(std::move(s)); }
    bool binary(Json::binary_t&) { return false; }  // does not occur in JSON text

    bool start_object(std::size_t) { return open(JsonContainer::Object); }
    bool start_array(std::size_t) { return open(JsonContainer::Array); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        understood(JsonEvent::Value);
        Open& object = open_.back();
        if (!object.keys.insert(name).second)
            fail({"", "", fmt::format("duplicate key {}", in_quotes(name)), "it only once"});
        if (object.keys.size() > max_json_keys)
            fail({"", "", "too many keys", fmt::format("at most {} in an object", max_json_keys)});
        key_ = std::move(name);
        understood(JsonEvent::Key);
        return true;
    }

    bool parse_error(std::size_t, const std::string& token, const Json::exception& error) {
        constexpr int number_overflow = 406;  // its documented error id
        if (error.id == number_overflow)
            fail({"", "", shortened(token) + " is out of range", std::string(any_number.words)});
        const JsonContainer container = open_.empty() ? JsonContainer::None : open_.back().kind;
        Problem problem = syntax_problem({text_, understood_, place(), last_, container});
        problem.file = file_;
        throw NotJson(std::move(problem));
    }

  private:
    /// An object or an array that has not been closed yet. It becomes a Json once complete: the library's
    /// objects copy their members when they grow.
    struct Open {
        JsonContainer kind = JsonContainer::None;
        std::string key;  // its key in the enclosing object; unused in an array
        std::vector<Json> elements;
        std::vector<std::pair<std::string, Json>> members;
        std::set<std::string> keys;

        Json take() {
            if (kind == JsonContainer::Array) return Json(std::move(elements));
            Json::object_t object;
            object.reserve(members.size());
            for (auto& [name, value] : members) object.emplace_back(std::move(name), std::move(value));
            return Json(std::move(object));
        }
    };

    [[nodiscard]] std::size_t place() const { return static_cast<std::size_t>(reached_ - text_.data()); }

    void understood(JsonEvent event) {
        last_ = event;
        understood_ = place();
    }

    /// Adds the value to the key that was read last, appends it to the innermost array, or makes it the root.
    bool put(Json v) {
        if (++count_ > max_json_values)
            fail({"", "", "too many values", fmt::format("at most {} in a scene", max_json_values)});
        parsed_.at(place());
        understood(JsonEvent::Value);
        if (open_.empty())
            root_ = std::move(v);
        else if (open_.back().kind == JsonContainer::Array)
            open_.back().elements.push_back(std::move(v));
        else
            open_.back().members.emplace_back(std::move(key_), std::move(v));
        return true;
    }
    template <class Number> bool number(Number n) {
        put(n);
        // The parser finds the end of a number by reading the next character, unless the text ends. That
        // character can be a digit only after a 0, as in 01.
        const bool digit = std::isdigit(static_cast<unsigned char>(reached_[-1])) != 0;
        const bool after_zero = std::is_integral_v<Number> && n == 0 && place() > 1 && reached_[-2] == '0';
        if (!digit || after_zero) --understood_;
        return true;
    }
    bool open(JsonContainer kind) {
        if (open_.size() == max_json_depth)
            fail({"", "", "nested too deeply", fmt::format("at most {} deep", max_json_depth)});
        open_.push_back({kind, std::exchange(key_, {}), {}, {}, {}});
        understood(kind == JsonContainer::Object ? JsonEvent::OpenedObject : JsonEvent::OpenedArray);
        return true;
    }
    bool close() {
        Open done = std::move(open_.back());
        open_.pop_back();
        key_ = std::move(done.key);
        return put(done.take());
    }

    [[nodiscard]] std::string pointer() const {
        std::string text;
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const bool last = i + 1 == open_.size();
            if (open_[i].kind == JsonContainer::Array)
                text += fmt::format("/{}", open_[i].elements.size());
            else if (!last || last_ == JsonEvent::Key)
                text.append("/").append(escaped_token(last ? key_ : open_[i + 1].key));
        }
        return text;
    }
    [[noreturn]] void fail(Problem problem) const {
        problem.file = file_;
        problem.pointer = pointer();
        problem.line = line_of(text_, place() == 0 ? 0 : place() - 1);
        throw ProblemFound(std::move(problem));
    }

    std::string_view text_;
    const std::string& file_;
    const char* reached_;
    ParsedBytes parsed_;
    Json root_;
    std::vector<Open> open_;  // the enclosing ones, outermost first
    std::string key_;         // the key read last
    JsonEvent last_ = JsonEvent::Nothing;
    std::size_t understood_ = 0;  // end of the last accepted token
    std::size_t count_ = 0;
};

}  // namespace

Json parsed_json(std::string_view text, const std::string& file) {
    const auto refuse = [&file](std::string what, std::string expected, int line = 0) {
        throw ProblemFound({file, "", std::move(what), std::move(expected), line});
    };
    if (text.size() > max_json_bytes) refuse(fmt::format("{} bytes of text", text.size()), "at most 64 MiB");
    if (const std::size_t bad = first_invalid_utf8(text); bad < text.size())
        refuse(fmt::format("the byte 0x{:02x} is not UTF-8", static_cast<unsigned char>(text[bad])),
               "UTF-8 text", line_of(text, bad));
    text = without_byte_order_mark(text);
    if (text.starts_with(byte_order_mark))  // the library would skip this mark
        refuse("a second byte-order mark", "at most one before the text", 1);
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)  // the library would stop
        refuse("the byte 0x00", "JSON text, which never contains it", line_of(text, zero));
    Builder builder(text, file);
    Json::sax_parse(builder.begin(), builder.end(), &builder);  // an error throws
    return std::move(builder).take();
}

Result<Json> read_json(std::string_view text, const std::string& file) {
    return result_of(file, [&] { return parsed_json(text, file); });
}

Json json_or_null(std::string_view text) {
    Result<Json> read = read_json(text, "");
    auto* json = std::get_if<Json>(&read);
    return json != nullptr ? std::move(*json) : Json();
}

const Json* find_member(const Json& json, std::string_view name) {
    if (!json.is_object()) return nullptr;
    const auto found = json.find(name);
    return found == json.end() ? nullptr : &*found;
}

const Json::array_t& elements_of(const Json& json) {
    static const Json::array_t none;
    return json.is_array() ? json.get_ref<const Json::array_t&>() : none;
}

const Json::object_t& members_of(const Json& json) {
    static const Json::object_t none;
    return json.is_object() ? json.get_ref<const Json::object_t&>() : none;
}

std::string escaped_token(std::string_view token) {
    std::string text;
    for (const char c : token) {
        if (c == '~') text += "~0";
        if (c == '/') text += "~1";
        if (c != '~' && c != '/') text += c;
    }
    return text;
}

}  // namespace glint
