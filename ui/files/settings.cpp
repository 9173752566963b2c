#include "ui/files/settings.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace glint {
namespace {

using Json = nlohmann::ordered_json;

/// The member, if there is one of that kind.
void read(const Json& json, const char* name, bool& value) {
    if (const auto found = json.find(name); found != json.end() && found->is_boolean()) value = *found;
}
void read(const Json& json, const char* name, float& value, float low, float high) {
    const auto found = json.find(name);
    if (found == json.end() || !found->is_number()) return;
    const double number = found->get<double>();
    if (std::isfinite(number)) value = static_cast<float>(std::clamp<double>(number, low, high));
}
void read(const Json& json, const char* name, int& value, int low, int high) {
    float number = static_cast<float>(value);
    read(json, name, number, static_cast<float>(low), static_cast<float>(high));
    value = static_cast<int>(number);
}

}  // namespace

std::string settings_text(const Settings& s) {
    const Json json{{"theme", s.dark ? "dark" : "light"},
                    {"scene_column", s.layout.left},
                    {"why_column", s.layout.right},
                    {"scene_width", s.layout.left_width},
                    {"why_width", s.layout.right_width},
                    {"scope", s.layout.scope},
                    {"scope_height", s.layout.scope_height},
                    {"width", s.width},
                    {"height", s.height},
                    {"maximized", s.maximized}};
    return json.dump(1) + "\n";
}

Settings read_settings(const std::string& text) {
    Settings s;
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) return s;
    if (const auto theme = json.find("theme"); theme != json.end()) s.dark = *theme != "light";
    read(json, "scene_column", s.layout.left);
    read(json, "why_column", s.layout.right);
    read(json, "scene_width", s.layout.left_width, least_column_width, most_column_width);
    read(json, "why_width", s.layout.right_width, least_column_width, most_column_width);
    read(json, "scope", s.layout.scope);
    read(json, "scope_height", s.layout.scope_height, 80, 1000);
    read(json, "width", s.width, 0, 16384);
    read(json, "height", s.height, 0, 16384);
    read(json, "maximized", s.maximized);
    return s;
}

}  // namespace glint
