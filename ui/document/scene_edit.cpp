#include "ui/document/scene_edit.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>

#include "models/fields/choices.h"
#include "models/json/json.h"
#include "models/utf8.h"
#include "ui/feature.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/screen.h"
#include "ui/ui.h"

namespace glint {
namespace {

const char* name_of(LightKind kind) {
    switch (kind) {
    case LightKind::Directional:
        return "Sun";
    case LightKind::Point:
        return "Bulb";
    case LightKind::Spot:
        return "Lamp";
    case LightKind::Area:
        return "Panel";
    }
    return "Light";  // not reached
}

/// Returns a name for an object with that source: "Square" for meshes/square.obj.
std::string object_name(const MeshSource& source) {
    std::string name = short_name(source);
    if (std::holds_alternative<MeshFile>(source))
        name = with_invalid_replaced(name.substr(0, name.find_last_of('.')));
    if (name.empty()) return "Object";
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
}

template <class Item> auto place_after(std::vector<Item>& items, int index) {
    return items.begin() + index + 1;
}

/// Aims a light of any kind at the centre of the scene.
void aim(Light& light, glm::vec3 place, glm::vec3 middle, float radius) {
    const glm::vec3 towards = middle - place;
    light.position = {place, 1};
    light.spot.direction = glm::normalize(towards);
    light.spot.exponent = 4;
    const glm::vec3 side = glm::normalize(glm::cross(towards, glm::vec3(0.0123f, 1, 0.0456f)));
    light.area.edge_u = 0.25f * radius * side;
    light.area.edge_v = 0.25f * radius * glm::normalize(glm::cross(side, towards));
    if (light.kind == LightKind::Directional) light.position = {-glm::normalize(towards), 0};
}

}  // namespace

std::optional<Selection> selection_in(std::string_view pointer) {
    if (const auto light = item_in(pointer, "/lights/"))
        return Selection{Selection::Kind::Light, light->place};
    if (const auto object = item_in(pointer, "/objects/"))
        return Selection{Selection::Kind::Object, object->place};
    return {};
}

Selection valid_selection(const Selection& selection, const Scene& scene) {
    Selection valid = selection;
    const auto within = [&valid](std::size_t count) {
        if (count == 0) return Selection{};
        valid.index = std::clamp(valid.index, 0, static_cast<int>(count) - 1);
        return valid;
    };
    if (selection.kind == Selection::Kind::Light) return within(scene.lights.size());
    if (selection.kind == Selection::Kind::Object) return within(scene.objects.size());
    return valid;
}

std::string free_name(const std::string& wanted, const Scene& scene) {
    std::unordered_set<std::string_view> taken;
    for (const Light& light : scene.lights) taken.insert(light.name);
    for (const Object& object : scene.objects) taken.insert(object.name);
    if (!taken.contains(wanted)) return wanted;
    // "Bulb 2" is followed by "Bulb 3", not by "Bulb 2 2".
    const std::size_t digits = wanted.find_last_not_of("0123456789");
    const bool numbered = digits != std::string::npos && digits + 1 < wanted.size() && wanted[digits] == ' ';
    constexpr std::size_t number_room = 8;
    const std::string stem = numbered ? wanted.substr(0, digits) : wanted;
    const std::string_view base = first_characters(stem, max_name_characters - number_room);
    for (int i = 2;; ++i)
        if (std::string name = fmt::format("{} {}", base, i); !taken.contains(name)) return name;
}

std::string short_name(const MeshSource& source) {
    const std::string name = source_name(source);
    return name.substr(name.find_last_of('/') + 1);
}

bool add_light(Scene& scene, Selection& selection, LightKind kind) {
    if (scene.lights.size() >= max_lights) return false;
    const Bounds bounds = scene_bounds(scene);
    const glm::vec3 middle = (bounds.min + bounds.max) / 2.0f;
    const float radius = std::max(glm::length(bounds.max - bounds.min) / 2, 1e-3f);
    // In front of the scene, in the upper half of the picture even if it is square. No two lights get the
    // same position.
    const ScreenMap map = screen_map(scene.camera, {512, 512});
    const double away = project(map, middle).depth,
                 depth = std::max(away - 0.75 * radius, 0.35 * std::abs(away));
    const double turn = 0.9 * static_cast<double>(scene.lights.size());
    const glm::dvec2 pixel{256 + 150 * std::cos(turn + 0.6), 130 + 40 * std::sin(turn)};
    const glm::vec3 place(unproject(map, pixel, depth));
    Light light;
    light.name = free_name(name_of(kind), scene);
    light.kind = kind;
    aim(light, place, middle, radius);
    scene.lights.push_back(light);
    selection = {Selection::Kind::Light, static_cast<int>(scene.lights.size()) - 1};
    return true;
}

bool add_object(Scene& scene, Selection& selection, const MeshSource& source) {
    if (scene.objects.size() >= max_objects) return false;
    Object object;
    object.name = free_name(object_name(source), scene);
    object.source = source;
    if (!scene.objects.empty()) object.transform.translate.x = scene_bounds(scene).max.x + 1.2f;
    scene.objects.push_back(object);
    selection = {Selection::Kind::Object, static_cast<int>(scene.objects.size()) - 1};
    return true;
}

void duplicate(Scene& scene, Selection& selection) {
    if (selection.kind == Selection::Kind::Light && scene.lights.size() < max_lights) {
        Light copy = scene.lights[static_cast<std::size_t>(selection.index)];
        copy.name = free_name(copy.name, scene);
        const Bounds bounds = scene_bounds(scene);
        const float step = copy.position.w == 0 ? 0.2f : 0.1f * glm::length(bounds.max - bounds.min);
        copy.position.x += step;
        scene.lights.insert(place_after(scene.lights, selection.index++), copy);
    } else if (selection.kind == Selection::Kind::Object && scene.objects.size() < max_objects) {
        Object copy = scene.objects[static_cast<std::size_t>(selection.index)];
        copy.name = free_name(copy.name, scene);
        scene.objects.insert(place_after(scene.objects, selection.index++), copy);
    }
}

void remove(Scene& scene, Selection& selection) {
    if (selection.kind == Selection::Kind::Light && !scene.lights.empty())
        scene.lights.erase(scene.lights.begin() + selection.index);
    if (selection.kind == Selection::Kind::Object && !scene.objects.empty())
        scene.objects.erase(scene.objects.begin() + selection.index);
    selection = valid_selection(selection, scene);
}

bool ItemPlaces::follow_light(int& light) const {
    if (light < 0 || light >= static_cast<int>(before.lights.size())) return true;
    const int place = place_in(before.lights, after.lights, light);
    if (place >= 0) light = place;
    return place >= 0;
}

bool ItemPlaces::follow(std::string& pointer) const {
    const auto follow_in = [&pointer](std::string_view list, const auto& items, const auto& now) {
        const std::optional<ListItem> item = item_in(pointer, list);
        if (!item || item->place >= static_cast<int>(items.size())) return true;
        const int place = place_in(items, now, item->place);
        if (place >= 0) pointer = fmt::format("{}{}{}", list, place, item->rest);
        return place >= 0;
    };
    return follow_in("/lights/", before.lights, after.lights) &&
           follow_in("/objects/", before.objects, after.objects);
}

void follow_items(UiState& state) {
    const Scene& scene = state.editor.scene();
    std::optional<FollowedItems>& known = state.editor.followed;
    if (!known) known.emplace(FollowedItems{scene.lights, scene.objects});
    if (known->lights.size() != scene.lights.size() || known->objects.size() != scene.objects.size())
        for (const Feature* feature : features())
            if (feature->follow != nullptr) feature->follow(state, {*known, scene});
    if (known->lights != scene.lights) known->lights = scene.lights;
    if (known->objects != scene.objects) known->objects = scene.objects;
}

bool smooths_every_edge(const Object& object) {
    const NormalOptions& options = object.normals;
    return object.mesh && object.mesh->given_normals == GivenNormals::None &&
           options.source != NormalSource::Facet && options.crease_deg >= 180;
}

void say_averaged(UiState& state, const Object& object) {
    if (!smooths_every_edge(object)) return;
    state.notifications.add(
        Tone::Warning,
        fmt::format("{} has no normals, so facet normals are averaged across all edges, and creases "
                    "look smooth. Crease, in the object's panel, keeps edges sharp",
                    short_name(object.source)));
}

void tell_averaged_normals(UiState& state) {
    const Scene& scene = state.editor.scene();
    const bool is_mesh = !state.editor.document.path.empty() && !state.editor.has_scene_file();
    if (!is_mesh || scene.objects.size() != 1) return;
    say_averaged(state, scene.objects.front());
    state.editor.selection = {Selection::Kind::Object, 0};
}

}  // namespace glint
