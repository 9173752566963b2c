#include "models/json/json_node.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "models/json/json_pointer.h"
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

}  // namespace glint
