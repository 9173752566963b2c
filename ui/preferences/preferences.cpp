#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "models/json/json.h"
#include "models/scene_file/scene_file.h"
#include "models/utf8.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/games/match.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/scope.h"
#include "ui/picture/orbit.h"
#include "ui/preferences/persistence.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

// Reads members of untrusted JSON: an invalid or missing one leaves the value as it is.

void read(const Json& json, const char* name, bool& value) {
    if (const Json* found = find_member(json, name); found != nullptr && found->is_boolean())
        value = found->get<bool>();
}

/// Brought into low .. high.
template <class Real> void read(const Json& json, const char* name, Real& value, Real low, Real high) {
    const Json* found = find_member(json, name);
    if (found == nullptr || !found->is_number()) return;
    const double number = found->get<double>();
    if (!std::isfinite(number)) return;
    value = static_cast<Real>(std::clamp(number, static_cast<double>(low), static_cast<double>(high)));
}

/// A scene file that holds a camera and nothing else: its writer and its checks serve a kept view too.
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

void read_share(const Json& json, const char* name, glm::dvec2& value) {
    const Json* found = find_member(json, name);
    if (found == nullptr || elements_of(*found).size() != 2) return;
    const Json both{{"x", elements_of(*found)[0]}, {"y", elements_of(*found)[1]}};
    read(both, "x", value.x, 0.0, 1.0);
    read(both, "y", value.y, 0.0, 1.0);
}

Json compare_json(const CompareChoice& choice) {
    Json parts = Json::array();
    for (const Variant& part : choice.parts) parts.push_back(word_of(part));
    return {{"parts", parts},
            {"lines", choice.wipes},
            {"stacked", choice.stacked},
            {"difference", choice.difference},
            {"gain", choice.gain}};
}

/// Lines that rise, one fewer than parts; else they stay evenly spread.
void read_lines(const Json& json, CompareChoice& choice) {
    if (!json.is_array() || elements_of(json).size() != choice.wipes.size()) return;
    std::vector<double> lines;
    for (const Json& line : elements_of(json)) {
        if (!line.is_number()) return;
        lines.push_back(line.get<double>());
        if (!(lines.back() >= 0 && lines.back() <= 1)) return;
        if (lines.size() > 1 && !(lines.back() >= lines[lines.size() - 2])) return;
    }
    choice.wipes = lines;
}

CompareChoice read_compare(const Json& json) {
    CompareChoice choice;
    if (!json.is_object()) return choice;
    read(json, "stacked", choice.stacked);
    read(json, "difference", choice.difference);
    int gain = 1;
    read(json, "gain", gain, 1, max_gain);
    while (2 * choice.gain <= gain) choice.gain *= 2;
    std::vector<Variant> parts;
    if (const Json* found = find_member(json, "parts"))
        for (const Json& part : elements_of(*found))
            if (const auto setting =
                    part.is_string() ? variant_named(part.get_ref<const std::string&>()) : std::nullopt)
                parts.push_back(*setting);
    if (parts.size() == 2 || parts.size() == 3) set_parts(choice, parts);
    if (const Json* found = find_member(json, "lines")) read_lines(*found, choice);
    return choice;
}

// Recent files: absolute paths without control characters, each once, at most max_recent_files.

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
    for (const std::string& path : paths) list.push_back(escaped_bytes(path));  // a path need not be UTF-8
    return list;
}

std::vector<std::string> read_recent(const Json& list) {
    std::vector<std::string> paths;
    for (const Json& item : elements_of(list))
        if (item.is_string()) add_recent(paths, unescaped_bytes(item.get_ref<const std::string&>()));
    return paths;
}

Json share_json(glm::dvec2 share) {  // one that waits outside of the picture comes to its edge
    const glm::dvec2 inside = glm::clamp(share, 0.0, 1.0);
    return {inside.x, inside.y};
}

Json view_json(const ViewPreferences& views) {
    Json kept = Json::array();
    for (const Camera& camera : views.kept) kept.push_back(camera_json(camera));
    return {{"compare", compare_json(views.compare)}, {"scope_from", share_json(views.scope_from)},
            {"scope_to", share_json(views.scope_to)}, {"scope_channels", views.scope_channels},
            {"scope_eye", views.scope_eye},           {"kept_views", kept}};
}

ViewPreferences read_view(const Json& json) {
    ViewPreferences views;
    if (const Json* compare = find_member(json, "compare")) views.compare = read_compare(*compare);
    read_share(json, "scope_from", views.scope_from);
    read_share(json, "scope_to", views.scope_to);
    read(json, "scope_channels", views.scope_channels);
    read(json, "scope_eye", views.scope_eye);
    if (const Json* kept = find_member(json, "kept_views"))
        for (const Json& camera : elements_of(*kept))
            if (const auto view = read_camera(camera)) keep_view(views.kept, *view);
    return views;
}

struct Limits {
    float low, high;
};

/// Every number and switch of the preferences, once: its name in the file, its member, and its range.
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

ViewPreferences views_to_remember(const UiState& state) {
    const ScopeState& scope = state.get<ScopeState>();
    ViewPreferences views{
        state.get<CompareState>().choice, scope.from, scope.to, scope.channels, scope.eye, state.kept_views};
    if (state.get<MyPictureState>().shown) views.compare = state.get<MyPictureState>().compare_before;
    if (state.get<MatchState>().on) views.compare = state.get<MatchState>().compare_before;
    views.compare.stored.reset();  // a scene is not a preference
    views.compare.shows_stored = views.compare.on = false;
    return views;
}

void recall_views(UiState& state, const ViewPreferences& views) {
    CompareChoice& choice = state.get<CompareState>().choice;
    const auto stored = choice.stored;
    const auto mine = choice.mine;
    choice = views.compare;
    choice.stored = stored;
    choice.mine = mine;
    ScopeState& scope = state.get<ScopeState>();
    scope.from = views.scope_from;
    scope.to = views.scope_to;
    scope.channels = views.scope_channels;
    scope.eye = views.scope_eye;
    state.kept_views = views.kept;
}

std::string preferences_text(const Preferences& p) {
    Json json{{"theme", p.dark ? "dark" : "light"}};
    preference_fields(p, [&](const char* name, const auto& value, auto...) { json[name] = value; });
    json["view"] = view_json(p.views);
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
            read(json, name, value);
        else
            (read(json, name, value, static_cast<T>(range.low), static_cast<T>(range.high)), ...);
    });
    if (const Json* view = find_member(json, "view")) p.views = read_view(*view);
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
