// Writes JSON.
#include <fmt/core.h>

#include <algorithm>

#include "models/json/json.h"
#include "models/utf8.h"

namespace glint {
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
