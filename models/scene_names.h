#pragma once
// The words of the scene file for each closed set (docs/interface.md, "Scene file").

#include <string>
#include <string_view>
#include <vector>

#include "models/scene.h"

namespace glint {

/// The name in the scene file: "directional", "blinn-phong", ...; empty for a number that is no enumerator.
[[nodiscard]] std::string_view name_of(LightKind kind);
[[nodiscard]] std::string_view name_of(LightSpace space);
[[nodiscard]] std::string_view name_of(Primitive primitive);
[[nodiscard]] std::string_view name_of(NormalSource source);
[[nodiscard]] std::string_view name_of(NormalWeighting weighting);
[[nodiscard]] std::string_view name_of(ShadingMode mode);
[[nodiscard]] std::string_view name_of(Reflection reflection);
[[nodiscard]] std::string_view name_of(Interpolation interpolation);
[[nodiscard]] std::string_view name_of(FlatPoint point);
[[nodiscard]] std::string_view name_of(Cull cull);
[[nodiscard]] std::string_view name_of(Rules rules);
[[nodiscard]] std::string_view name_of(Transfer transfer);
/// What warnings call a mesh: its file's path as the scene gives it, or the name of the primitive.
[[nodiscard]] std::string source_name(const MeshSource& source);
/// "perspective", "orthographic" or "frustum".
[[nodiscard]] std::string_view name_of(const Projection& projection);

/// All names of an enumeration; the place of a name is the number of its enumerator.
template <class Enum> [[nodiscard]] std::vector<std::string> names_of() {
    std::vector<std::string> names;
    for (int i = 0; !name_of(static_cast<Enum>(i)).empty(); ++i)
        names.emplace_back(name_of(static_cast<Enum>(i)));
    return names;
}

}  // namespace glint
