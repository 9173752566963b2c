#include "ui/preferences/settings.h"

#include "ui/preferences/view_json.h"

namespace glint {

std::string preferences_text(const Preferences& s) {
    const Json json{{"theme", s.dark ? "dark" : "light"},
                    {"scene_column", s.layout.left},
                    {"why_column", s.layout.right},
                    {"scene_width", s.layout.left_width},
                    {"why_width", s.layout.right_width},
                    {"scope", s.layout.scope},
                    {"scope_height", s.layout.scope_height},
                    {"width", s.width},
                    {"height", s.height},
                    {"maximized", s.maximized},
                    {"view", view_json(s.views)}};
    return json_text(json);
}

Preferences read_preferences(const std::string& text) {
    Preferences s;
    const Json json = Json::parse(text).value_or(Json());
    if (!json.is_object()) return s;
    if (const Json* theme = json.find("theme")) s.dark = *theme != "light";
    read(json, "scene_column", s.layout.left);
    read(json, "why_column", s.layout.right);
    read(json, "scene_width", s.layout.left_width, least_column_width, most_column_width);
    read(json, "why_width", s.layout.right_width, least_column_width, most_column_width);
    read(json, "scope", s.layout.scope);
    read(json, "scope_height", s.layout.scope_height, 80.0f, 1000.0f);
    read(json, "width", s.width, 0, 16384);
    read(json, "height", s.height, 0, 16384);
    read(json, "maximized", s.maximized);
    if (const Json* view = json.find("view")) s.views = read_view(*view);
    return s;
}

}  // namespace glint
