#pragma once
// Edits of a scene as a list: adding, duplicating and deleting lights and objects. Pure functions.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "models/scene/scene.h"

namespace glint {

/// The item that the left column and the keys act on.
struct Selection {
    enum class Kind { Camera, Light, Object, Shading, Display };
    Kind kind = Kind::Shading;
    int index = 0;  // index of a light or an object
    bool operator==(const Selection&) const = default;
};

/// A unique number for each selection.
[[nodiscard]] inline int number_of(const Selection& selection) {
    constexpr int more_than_any_index = 100'000;
    return static_cast<int>(selection.kind) * more_than_any_index + selection.index;
}

/// Index of the selected light, or -1.
[[nodiscard]] inline int selected_light(const Selection& selection) {
    return selection.kind == Selection::Kind::Light ? selection.index : -1;
}

/// The light or object that a pointer refers to or into, if any.
[[nodiscard]] std::optional<Selection> selection_in(std::string_view pointer);

/// The numbers of lights and objects. An index stays valid while they do not change.
struct ItemCounts {
    std::size_t lights = 0, objects = 0;
    bool operator==(const ItemCounts&) const = default;
};
[[nodiscard]] inline ItemCounts item_counts(const Scene& scene) {
    return {scene.lights.size(), scene.objects.size()};
}

/// `selection`, or the nearest that exists in `scene`.
[[nodiscard]] Selection valid_selection(const Selection& selection, const Scene& scene);

/// The name of a mesh: its file's name, or the primitive's name.
[[nodiscard]] std::string short_name(const MeshSource& source);

/// `wanted`, with the first number that makes it unique if it is taken: "Bulb", "Bulb 2".
[[nodiscard]] std::string free_name(const std::string& wanted, const Scene& scene);

inline constexpr const char* is_full = "There are as many as a scene may hold";

/// Adds a light above the scene on the viewer's side, where it is visible and can be grabbed, and selects it.
/// Returns false and changes nothing if the scene is full.
bool add_light(Scene& scene, Selection& selection, LightKind kind);

/// Likewise adds an object next to the others. Its mesh is not loaded.
bool add_object(Scene& scene, Selection& selection, const MeshSource& source);

/// Adds a copy after the original, slightly offset (a light) or at the same position (an object), and selects
/// it.
void duplicate(Scene& scene, Selection& selection);
/// Deletes the selected light or object and selects its neighbour.
void remove(Scene& scene, Selection& selection);

}  // namespace glint
