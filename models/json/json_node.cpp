#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/json/json.h"
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
            return value_.get<bool>() ? "true does not fit here" : "false does not fit here";
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

}  // namespace glint
