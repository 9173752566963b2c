#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "models/json/json_value.h"
#include "models/scene_file/scene_file.h"
#include "ui/picture/orbit.h"
#include "ui/preferences/persistence.h"
#include "ui/ui.h"

namespace glint {
namespace {

using Json = JsonValue;

// Reads members of untrusted JSON: an invalid or missing one leaves the value as it is.

void read(const Json& json, const char* name, bool& value) {
    if (const Json* found = json.find(name); found != nullptr && found->is_boolean())
        value = found->boolean();
}

/// Brought into low .. high.
template <class Real> void read(const Json& json, const char* name, Real& value, Real low, Real high) {
    const Json* found = json.find(name);
    if (found == nullptr || !found->is_number()) return;
    const double number = found->number();
    if (!std::isfinite(number)) return;
    value = static_cast<Real>(std::clamp(number, static_cast<double>(low), static_cast<double>(high)));
}

/// A scene file that holds a camera and nothing else: its writer and its checks serve a kept view too.
Json camera_json(const Camera& camera) {
    Scene scene;
    scene.camera = camera;
    return *Json::parse(scene_text(scene))->find("camera");
}

std::optional<Camera> read_camera(const Json& json) {
    Json file = *Json::parse(scene_text({}));
    file["camera"] = json;
    const Result<Scene> scene = parse_scene(file.text(), "");
    if (const auto* read = std::get_if<Scene>(&scene)) return read->camera;
    return {};
}

void read_share(const Json& json, const char* name, glm::dvec2& value) {
    const Json* found = json.find(name);
    if (found == nullptr || found->elements().size() != 2) return;
    const Json both{{"x", found->elements()[0]}, {"y", found->elements()[1]}};
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
    if (!json.is_array() || json.elements().size() != choice.wipes.size()) return;
    std::vector<double> lines;
    for (const Json& line : json.elements()) {
        if (!line.is_number()) return;
        lines.push_back(line.number());
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
    if (const Json* found = json.find("parts"))
        for (const Json& part : found->elements())
            if (const auto setting = part.is_string() ? variant_named(part.string()) : std::nullopt)
                parts.push_back(*setting);
    if (parts.size() == 2 || parts.size() == 3) set_parts(choice, parts);
    if (const Json* found = json.find("lines")) read_lines(*found, choice);
    return choice;
}

Json to_json(bool on) { return on; }
Json to_json(glm::dvec2 share) {  // one that waits outside of the picture comes to its edge
    const glm::dvec2 inside = glm::clamp(share, 0.0, 1.0);
    return {inside.x, inside.y};
}
Json to_json(const CompareChoice& choice) { return compare_json(choice); }
Json to_json(const std::vector<Camera>& cameras) {
    Json all = Json::array();
    for (const Camera& camera : cameras) all.push_back(camera_json(camera));
    return all;
}

void read_from(const Json& json, const char* name, bool& on) { read(json, name, on); }
void read_from(const Json& json, const char* name, glm::dvec2& share) { read_share(json, name, share); }
void read_from(const Json& json, const char* name, CompareChoice& choice) {
    if (const Json* found = json.find(name)) choice = read_compare(*found);
}
void read_from(const Json& json, const char* name, std::vector<Camera>& cameras) {
    if (const Json* found = json.find(name))
        for (const Json& camera : found->elements())
            if (const auto view = read_camera(camera)) keep_view(cameras, *view);
}

/// Everything that is remembered of the views, once: visit(its name in the file, its member, a function that
/// leads to its place in the window).
template <class Memory, class Visit> void view_fields(Memory& m, const Visit& visit) {
    visit(
        "compare", m.compare, [](auto& s) -> auto& { return s.views.compare.choice; });
    visit(
        "scope_from", m.scope_from, [](auto& s) -> auto& { return s.views.scope.from; });
    visit(
        "scope_to", m.scope_to, [](auto& s) -> auto& { return s.views.scope.to; });
    visit(
        "scope_channels", m.scope_channels, [](auto& s) -> auto& { return s.views.scope.channels; });
    visit(
        "scope_eye", m.scope_eye, [](auto& s) -> auto& { return s.views.scope.eye; });
    visit(
        "kept_views", m.kept, [](auto& s) -> auto& { return s.kept_views; });
}

Json view_json(const ViewPreferences& memory) {
    Json json = Json::object();
    view_fields(memory, [&](const char* name, const auto& value, auto) { json[name] = to_json(value); });
    return json;
}

ViewPreferences read_view(const Json& json) {
    ViewPreferences memory;
    if (json.is_object())
        view_fields(memory, [&](const char* name, auto& value, auto) { read_from(json, name, value); });
    return memory;
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
    ViewPreferences memory;
    view_fields(memory, [&](const char*, auto& value, auto now) { value = now(state); });
    if (state.mine.shown) memory.compare = state.mine.compare_before;
    if (state.match.on) memory.compare = state.match.compare_before;
    memory.compare.stored.reset();  // a scene is not a preference
    memory.compare.shows_stored = memory.compare.on = false;
    return memory;
}

void recall_views(UiState& state, const ViewPreferences& memory) {
    std::shared_ptr<const Scene> stored = std::move(state.views.compare.choice.stored);
    std::shared_ptr<const Picture> mine = std::move(state.views.compare.choice.mine);
    view_fields(memory, [&](const char*, const auto& value, auto now) { now(state) = value; });
    state.views.compare.choice.stored = std::move(stored);
    state.views.compare.choice.mine = std::move(mine);
}

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
