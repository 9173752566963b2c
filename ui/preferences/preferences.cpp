#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "models/json/json.h"
#include "models/scene_file/scene_file.h"
#include "models/utf8.h"
#include "ui/picture/orbit.h"
#include "ui/preferences/persistence.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// Writes a scene file that contains only a camera, so that the writer and the checks of scene files also
/// serve saved views.
Json camera_json(const Camera& camera) {
    Scene scene;
    scene.camera = camera;
    return json_or_null(scene_text(scene))["camera"];
}

std::optional<Camera> read_camera(const Json& json) {
    Json file = json_or_null(scene_text({}));
    file["camera"] = json;
    const Result<Scene> scene = parse_scene(json_line(file), "");
    if (const auto* read = std::get_if<Scene>(&scene)) return read->camera;
    return {};
}

// Recent files: absolute paths without control characters or duplicates, at most max_recent_files.

constexpr std::size_t longest_path = 4096;  // PATH_MAX

bool can_be_shown(const std::string& path) {
    const auto control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    return path.size() <= longest_path && fs::path(path).is_absolute() &&
           std::none_of(path.begin(), path.end(), control);
}

void add_recent(std::vector<std::string>& paths, const std::string& path) {
    if (paths.size() >= max_recent_files || !can_be_shown(path)) return;
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
}

Json recent_json(const std::vector<std::string>& paths) {
    Json list = Json::array();
    for (const std::string& path : paths) list.push_back(escaped_bytes(path));  // paths are not always UTF-8
    return list;
}

std::vector<std::string> read_recent(const Json& list) {
    std::vector<std::string> paths;
    for (const Json& item : elements_of(list))
        if (item.is_string()) add_recent(paths, unescaped_bytes(item.get_ref<const std::string&>()));
    return paths;
}

Json view_json(const Preferences& p) {
    Json json = p.features;
    Json kept = Json::array();
    for (const Camera& camera : p.kept_views) kept.push_back(camera_json(camera));
    json["kept_views"] = kept;
    return json;
}

void read_view(const Json& json, Preferences& p) {
    for (const auto& [name, value] : members_of(json))
        if (name != "kept_views") p.features[name] = value;
    if (const Json* kept = find_member(json, "kept_views"))
        for (const Json& camera : elements_of(*kept))
            if (const auto view = read_camera(camera)) keep_view(p.kept_views, *view);
}

struct Limits {
    float low, high;
};

/// Visits each number and switch of the preferences: its name in the file, its member, and its range.
template <class P, class Visit> void preference_fields(P& p, const Visit& visit) {
    constexpr Limits column{least_column_width, max_column_width}, why{least_why_width, max_column_width},
        window{0, 16384};
    visit("scene_column", p.layout.left);
    visit("why_column", p.layout.right);
    visit("scene_width", p.layout.left_width, column);
    visit("lesson_width", p.layout.lesson_width, column);
    visit("why_width", p.layout.right_width, why);
    visit("caption", p.layout.caption);
    visit("scope_height", p.layout.scope_height, Limits{80, 1000});
    visit("width", p.width, window);
    visit("height", p.height, window);
    visit("maximized", p.maximized);
}

}  // namespace

void read_member(const Json& json, const char* name, bool& value) {
    if (const Json* found = find_member(json, name); found != nullptr && found->is_boolean())
        value = found->get<bool>();
}

namespace {

template <class Real>
void read_number(const Json& json, const char* name, Real& value, double low, double high) {
    const Json* found = find_member(json, name);
    if (found == nullptr || !found->is_number()) return;
    if (const double number = found->get<double>(); std::isfinite(number))
        value = static_cast<Real>(std::clamp(number, low, high));
}

}  // namespace

void read_member(const Json& json, const char* name, int& value, int low, int high) {
    read_number(json, name, value, low, high);
}

void read_member(const Json& json, const char* name, float& value, float low, float high) {
    read_number(json, name, value, double(low), double(high));
}

Json share_json(glm::dvec2 share) {
    const glm::dvec2 inside = glm::clamp(share, 0.0, 1.0);
    return {inside.x, inside.y};
}

void read_share(const Json& json, const char* name, glm::dvec2& value) {
    const Json* found = find_member(json, name);
    if (found == nullptr || elements_of(*found).size() != 2) return;
    const Json both{{"x", elements_of(*found)[0]}, {"y", elements_of(*found)[1]}};
    read_number(both, "x", value.x, 0, 1);
    read_number(both, "y", value.y, 0, 1);
}

std::string preferences_text(const Preferences& p) {
    Json json{{"theme", p.dark ? "dark" : "light"}};
    preference_fields(p, [&](const char* name, const auto& value, auto...) { json[name] = value; });
    json["view"] = view_json(p);
    json["recent"] = recent_json(p.recent);
    return json_text(json);
}

Preferences read_preferences(const std::string& text) {
    Preferences p;
    const Json json = json_or_null(text);
    if (!json.is_object()) return p;
    if (const Json* theme = find_member(json, "theme")) p.dark = *theme != "light";
    preference_fields(p, [&]<class T>(const char* name, T& value, auto... range) {
        if constexpr (sizeof...(range) == 0)
            read_member(json, name, value);
        else
            (read_member(json, name, value, static_cast<T>(range.low), static_cast<T>(range.high)), ...);
    });
    if (const Json* view = find_member(json, "view")) read_view(*view, p);
    if (const Json* recent = find_member(json, "recent")) p.recent = read_recent(*recent);
    return p;
}

std::vector<std::string> with_recent_file(const std::vector<std::string>& paths, const std::string& path) {
    if (path.empty() || path == "-") return paths;
    std::error_code failed;
    const std::string full = fs::absolute(path, failed).lexically_normal().string();
    if (failed || !can_be_shown(full)) return paths;
    std::vector<std::string> list{full};
    for (const std::string& other : paths) add_recent(list, other);
    return list;
}

}  // namespace glint
