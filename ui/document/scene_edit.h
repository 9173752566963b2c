#pragma once
// Edits to a scene's lists: adding, duplicating and deleting lights and objects. Pure functions.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// The item that the left column and the keys affect.
struct Selection {
    enum class Kind { Camera, Light, Object, Shading, Display };
    Kind kind = Kind::Shading;
    int index = 0;  // index of a light or an object
    bool operator==(const Selection&) const = default;
};

/// Returns a unique number for each selection.
[[nodiscard]] inline int number_of(const Selection& selection) {
    constexpr int more_than_any_index = 100'000;
    return static_cast<int>(selection.kind) * more_than_any_index + selection.index;
}

/// Returns the index of the selected light, or -1.
[[nodiscard]] inline int selected_light(const Selection& selection) {
    return selection.kind == Selection::Kind::Light ? selection.index : -1;
}

/// Returns the light or object that contains the value at a JSON pointer, if any.
[[nodiscard]] std::optional<Selection> selection_in(std::string_view pointer);

/// The number of lights and the number of objects. An index stays valid while neither changes.
struct ItemCounts {
    std::size_t lights = 0, objects = 0;
    bool operator==(const ItemCounts&) const = default;
};
[[nodiscard]] inline ItemCounts item_counts(const Scene& scene) {
    return {scene.lights.size(), scene.objects.size()};
}

/// Returns `selection`, or the nearest one that exists in `scene`.
[[nodiscard]] Selection valid_selection(const Selection& selection, const Scene& scene);

/// Returns the name of a mesh: the name of its file or primitive.
[[nodiscard]] std::string short_name(const MeshSource& source);

/// Returns `wanted`; if that name is taken, with the first number that makes it unique: "Bulb", "Bulb 2".
[[nodiscard]] std::string free_name(const std::string& wanted, const Scene& scene);

inline constexpr const char* is_full = "The scene already has the maximum number";

/// Adds a light above the scene on the viewer's side, where it is visible and can be grabbed, and selects it.
/// Returns false and changes nothing if the scene is full.
bool add_light(Scene& scene, Selection& selection, LightKind kind);

/// Adds an object next to the other objects in the same way. Its mesh is not loaded.
bool add_object(Scene& scene, Selection& selection, const MeshSource& source);

/// Adds a copy after the original and selects it. The copy of a light is slightly offset; that of an object
/// is at the same position.
void duplicate(Scene& scene, Selection& selection);
/// Deletes the selected light or object, and selects a neighbour.
void remove(Scene& scene, Selection& selection);

// Lights and objects are identified by their index in the scene's lists. When items before one are added or
// deleted, every reference to it gets the new index.

struct UiState;

/// The lists of a scene at the last update.
struct FollowedItems {
    std::vector<Light> lights;
    std::vector<Object> objects;
};

/// Returns the index in `after` of the item at `index` of `before`, or -1 if it was deleted. Equal items at
/// the beginning and at the end are the same items; those in between were added or deleted. If the length has
/// not changed, each item keeps its index.
template <class Item>
[[nodiscard]] int place_in(const std::vector<Item>& before, const std::vector<Item>& after, int index) {
    if (before.size() == after.size()) return index;
    const std::size_t shorter = before.size() < after.size() ? before.size() : after.size();
    std::size_t first = 0, last = 0;  // number of equal items at the beginning and at the end
    while (first < shorter && before[first] == after[first]) ++first;
    while (last < shorter - first && before[before.size() - 1 - last] == after[after.size() - 1 - last])
        ++last;
    const auto place = static_cast<std::size_t>(index);
    if (place < first) return index;
    if (place + last < before.size()) return -1;
    return static_cast<int>(place + after.size() - before.size());
}

/// The lights and objects before and after some of them were added or deleted.
struct ItemPlaces {
    const FollowedItems& before;
    const Scene& after;
    /// Update the index of a light, or a JSON pointer to or into an item. If the item was deleted, they
    /// return false and change nothing.
    bool follow_light(int& light) const;
    bool follow(std::string& pointer) const;
};

/// Updates the indices that features refer to (Feature::follow). Called after each action that may add or
/// delete lights or objects, before any of them is drawn.
void follow_items(UiState& state);

// Notifies the user if a mesh without normals is drawn with averaged normals, which make its creases look
// smooth.

struct UiState;

/// Whether the object's mesh has no normals of its own, so facet normals are averaged across every edge.
[[nodiscard]] bool smooths_every_edge(const Object& object);

/// Adds a notification if smooths_every_edge() is true for the object.
void say_averaged(UiState& state, const Object& object);

/// If the open document is a single mesh, selects it, because its panel checks the mesh and can preserve
/// creases. Reports averaged normals.
void tell_averaged_normals(UiState& state);

}  // namespace glint
