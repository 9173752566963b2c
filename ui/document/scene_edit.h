#pragma once
// Edits of a scene as a list: adding, duplicating and deleting lights and objects. Pure functions.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "models/scene/scene.h"

namespace glint {

/// What the left column shows and the keys act on.
struct Selection {
    enum class Kind { Camera, Light, Object, Shading, Display };
    Kind kind = Kind::Shading;
    int index = 0;  // of a light or an object
    bool operator==(const Selection&) const = default;
};

/// A number for each selection, its own.
[[nodiscard]] inline int number_of(const Selection& selection) {
    constexpr int more_than_any_index = 100'000;
    return static_cast<int>(selection.kind) * more_than_any_index + selection.index;
}

/// Index of the selected light, or -1.
[[nodiscard]] inline int selected_light(const Selection& selection) {
    return selection.kind == Selection::Kind::Light ? selection.index : -1;
}

/// The light or object that a pointer leads to or into, if there is one.
[[nodiscard]] std::optional<Selection> selection_in(std::string_view pointer);

/// The numbers of lights and objects. While these stay, an index of one stands for one that exists.
struct ItemCounts {
    std::size_t lights = 0, objects = 0;
    bool operator==(const ItemCounts&) const = default;
};
[[nodiscard]] inline ItemCounts item_counts(const Scene& scene) {
    return {scene.lights.size(), scene.objects.size()};
}

/// `selection`, or the nearest that exists in `scene`.
[[nodiscard]] Selection valid_selection(const Selection& selection, const Scene& scene);

/// What a mesh is called: its file's name, or the primitive's word.
[[nodiscard]] std::string short_name(const MeshSource& source);

/// `wanted`, or with the first number that makes it different from all names: "Bulb", "Bulb 2".
[[nodiscard]] std::string free_name(const std::string& wanted, const Scene& scene);

/// Why nothing more can be added.
inline constexpr const char* is_full = "There are as many as a scene may hold";

/// Adds a light where it can be seen and grabbed, above the scene, on the viewer's side, and selects it.
/// False, and nothing changes, if the scene holds as many as it may.
bool add_light(Scene& scene, Selection& selection, LightKind kind);

/// Likewise an object beside the others. Its mesh is not loaded.
bool add_object(Scene& scene, Selection& selection, const MeshSource& source);

/// A copy after the original, a little aside (a light) or in the same place (an object), selected.
void duplicate(Scene& scene, Selection& selection);
/// Deletes the selected light or object and selects its neighbour.
void remove(Scene& scene, Selection& selection);

}  // namespace glint
