#pragma once
// The closed sets of values in a scene: each member is a row with its word in the scene file, its label in
// the window, and its meaning. The reader, the writer, the JSON Schema, the panels, the palette and the
// documentation use these rows. Each row is a case of a switch, so the compiler reports an enumerator without
// a row.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/mesh/primitives/primitives.h"
#include "models/scene/reflection.h"
#include "models/scene/scene.h"

namespace glint {

constexpr Choice choice_of(LightKind kind) {
    switch (kind) {
    case LightKind::Directional:
        return {"directional", "Directional", "Parallel rays from far away, no falloff"};
    case LightKind::Point:
        return {"point", "Point", "A bulb: shines equally in all directions"};
    case LightKind::Spot:
        return {"spot", "Spot", "A bulb with a cone"};
    case LightKind::Area:
        return {"area", "Area", "A luminous parallelogram, represented by points"};
    }
    return {};
}

constexpr Choice choice_of(LightSpace space) {
    switch (space) {
    case LightSpace::World:
        return {"world", "World", "Stays with the scene"};
    case LightSpace::Camera:
        return {"camera", "Camera", "Moves with the viewer"};
    }
    return {};
}

constexpr Choice choice_of(ShadingMode mode) {
    switch (mode) {
    case ShadingMode::Flat:
        return {"flat", "Flat", "One colour per polygon, lit at one of its points"};
    case ShadingMode::Facet:
        return {"facet", "Facet", "Every pixel lit with the polygon's normal"};
    case ShadingMode::Gouraud:
        return {"gouraud", "Gouraud", "Corners lit, their colours interpolated"};
    case ShadingMode::Phong:
        return {"phong", "Phong", "Normals interpolated, every pixel lit with its own"};
    }
    return {};
}

constexpr Choice choice_of(Interpolation interpolation) {
    switch (interpolation) {
    case Interpolation::Perspective:
        return {"perspective", "Perspective", "Correct under perspective"};
    case Interpolation::Screen:
        return {"screen", "Screen", "Linear on the screen over each triangle"};
    case Interpolation::Scanline:
        return {"scanline", "Scanline", "Along the polygon's edges, then along the scanline"};
    }
    return {};
}

constexpr Choice choice_of(FlatPoint point) {
    switch (point) {
    case FlatPoint::Centroid:
        return {"centroid", "Centroid", "Mean of the polygon's corners, with the facet normal"};
    case FlatPoint::Provoking:
        return {"provoking", "Last corner", "Last corner of each triangle, OpenGL's provoking vertex"};
    }
    return {};
}

constexpr Choice choice_of(Cull cull) {
    switch (cull) {
    case Cull::None:
        return {"none", "None", "Both sides are drawn"};
    case Cull::Back:
        return {"back", "Back", "Back faces are left out"};
    case Cull::Front:
        return {"front", "Front", "Front faces are left out"};
    }
    return {};
}

constexpr Choice choice_of(Rules rules) {
    switch (rules) {
    case Rules::Lecture:
        return {"lecture", "Lecture", "The equation as written"};
    case Rules::OpenGL2:
        return {"opengl2", "OpenGL 2",
                "Fixed-function OpenGL: colours clamped before interpolation, provoking corner, shininess at "
                "most 128"};
    }
    return {};
}

constexpr Choice choice_of(TransportModel model) {
    switch (model) {
    case TransportModel::Local:
        return {"local", "Local", "Every light reaches every point; ambient light replaces bounced light"};
    case TransportModel::Shadows:
        return {"shadows", "With shadows", "A light contributes only where nothing blocks it"};
    case TransportModel::Bounces:
        return {"bounces", "With bounces",
                "Shadows, and light from other surfaces in place of global ambient light"};
    }
    return {};
}

constexpr Choice choice_of(ScopeLights lights) {
    switch (lights) {
    case ScopeLights::All:
        return {"all", "All", "All lights"};
    case ScopeLights::Directional:
        return {"directional", "Directional", "Directional lights"};
    case ScopeLights::Point:
        return {"point", "Point", "Point lights"};
    case ScopeLights::Spot:
        return {"spot", "Spot", "Spots"};
    case ScopeLights::Area:
        return {"area", "Area", "Area lights"};
    }
    return {};
}

constexpr Choice choice_of(ScopeTerm term) {
    switch (term) {
    case ScopeTerm::All:
        return {"all", "All", "All terms"};
    case ScopeTerm::Diffuse:
        return {"diffuse", "Diffuse", "The diffuse term"};
    case ScopeTerm::Specular:
        return {"specular", "Specular", "The highlight"};
    }
    return {};
}

constexpr Choice choice_of(Transfer transfer) {
    switch (transfer) {
    case Transfer::None:
        return {"none", "Unchanged", "Values unchanged, as in the lecture and in OpenGL"};
    case Transfer::Srgb:
        return {"srgb", "sRGB", "Linear light encoded for the display"};
    }
    return {};
}

constexpr Choice choice_of(Reflection reflection) { return row_of(reflection).choice; }

constexpr Choice choice_of(OwnReflection reflection) {
    if (reflection == OwnReflection::Scene) return {"scene", "As the scene", "The scene's reflection model"};
    return choice_of(static_cast<Reflection>(reflection));
}
constexpr Choice choice_of(Primitive primitive) { return info_of(primitive).choice; }

/// The kinds of projection, in the order of the alternatives in `Projection`.
enum class ProjectionKind { Perspective, Orthographic, Frustum };
constexpr Choice choice_of(ProjectionKind kind) {
    switch (kind) {
    case ProjectionKind::Perspective:
        return {"perspective", "Perspective", "Lines of sight meet at the eye"};
    case ProjectionKind::Orthographic:
        return {"orthographic", "Orthographic", "Lines of sight are parallel"};
    case ProjectionKind::Frustum:
        return {"frustum", "Frustum", "A window on the near plane, which may be off-centre"};
    }
    return {};
}
[[nodiscard]] inline ProjectionKind kind_of(const Projection& projection) {
    return static_cast<ProjectionKind>(projection.index());
}

/// The number of enumerators in E. They are numbered from 0, and each has a row.
template <class E> constexpr std::size_t count_of() {
    std::size_t count = 0;
    while (!choice_of(static_cast<E>(count)).word.empty()) ++count;
    return count;
}

/// All rows of E, indexed by enumerator.
template <class E>
inline constexpr auto choices = [] {
    std::array<Choice, count_of<E>()> rows;
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = choice_of(static_cast<E>(i));
    return rows;
}();

/// All enumerators of E, in order.
template <class E>
inline constexpr auto enumerators = [] {
    std::array<E, count_of<E>()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<E>(i);
    return all;
}();

/// The word in the scene file: "directional", "blinn-phong", ...; empty if the number is not an enumerator.
template <class E> [[nodiscard]] constexpr std::string_view name_of(E value) { return choice_of(value).word; }

/// The enumerator with that word in the scene file, if any.
template <class E> [[nodiscard]] constexpr std::optional<E> from_name(std::string_view word) {
    for (std::size_t i = 0; i < choices<E>.size(); ++i)
        if (choices<E>[i].word == word) return static_cast<E>(i);
    return std::nullopt;
}

/// The words of all enumerators, in order.
template <class E> [[nodiscard]] std::vector<std::string> names_of() {
    std::vector<std::string> names;
    names.reserve(choices<E>.size());
    for (const Choice& row : choices<E>) names.emplace_back(row.word);
    return names;
}

/// The name of a mesh in warnings: the path of its file as given in the scene, or the primitive's word.
[[nodiscard]] std::string source_name(const MeshSource& source);

}  // namespace glint
