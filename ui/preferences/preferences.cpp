#include "ui/preferences/preferences.h"

#include "ui/preferences/view_json.h"

namespace glint {

namespace {

struct Limits {
    float low, high;
};

/// Every number and switch of the preferences, once: its name in the file, its member, and its range.
template <class P, class Visit> void preference_fields(P& p, const Visit& visit) {
    constexpr Limits column{least_column_width, most_column_width}, window{0, 16384};
    visit("scene_column", p.layout.left);
    visit("why_column", p.layout.right);
    visit("scene_width", p.layout.left_width, column);
    visit("why_width", p.layout.right_width, column);
    visit("scope", p.layout.scope);
    visit("scope_height", p.layout.scope_height, Limits{80, 1000});
    visit("width", p.width, window);
    visit("height", p.height, window);
    visit("maximized", p.maximized);
}

}  // namespace

std::string preferences_text(const Preferences& p) {
    Json json{{"theme", p.dark ? "dark" : "light"}};
    preference_fields(p, [&](const char* name, const auto& value, auto...) { json[name] = value; });
    json["view"] = view_json(p.views);
    return json_text(json);
}

Preferences read_preferences(const std::string& text) {
    Preferences p;
    const Json json = Json::parse(text).value_or(Json());
    if (!json.is_object()) return p;
    if (const Json* theme = json.find("theme")) p.dark = *theme != "light";
    preference_fields(p, [&]<class T>(const char* name, T& value, auto... range) {
        if constexpr (sizeof...(range) == 0)
            read(json, name, value);
        else
            (read(json, name, value, static_cast<T>(range.low), static_cast<T>(range.high)), ...);
    });
    if (const Json* view = json.find("view")) p.views = read_view(*view);
    return p;
}

}  // namespace glint
