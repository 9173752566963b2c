#include "renderer/inspect/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace glint {
namespace {

using Json = nlohmann::ordered_json;

std::string plain(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

bool is_row(const Json& json) {
    return json.is_array() &&
           std::none_of(json.begin(), json.end(), [](const Json& item) { return item.is_structured(); });
}

std::string row(const Json& json) {
    std::string text = "[";
    for (const Json& item : json) text += (text.size() > 1 ? ", " : "") + plain(item);
    return text + "]";
}

void append(std::string& text, const Json& json, std::size_t indent) {
    if (!json.is_structured() || json.empty()) {
        text += plain(json);
    } else if (is_row(json)) {
        text += row(json);
    } else {
        const bool keyed = json.is_object();
        text += keyed ? "{\n" : "[\n";
        std::size_t left = json.size();
        for (const auto& [key, value] : json.items()) {
            text.append(indent + 2, ' ');
            if (keyed) text += plain(key) + ": ";
            append(text, value, indent + 2);
            text += --left > 0 ? ",\n" : "\n";
        }
        text.append(indent, ' ') += keyed ? '}' : ']';
    }
}

}  // namespace

std::string json_text(const Json& json) {
    std::string text;
    append(text, json, 0);
    return text + "\n";
}

}  // namespace glint
