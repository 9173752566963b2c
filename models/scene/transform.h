#pragma once
// The transform of an object: M = T Rz Ry Rx S (docs/scene_file.md, "Objects").

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace glint {

struct Transform {
    glm::vec3 translate{0};
    glm::vec3 rotate_deg{0};  // about x, then y, then z
    glm::vec3 scale{1};       // no component 0; a negative one mirrors
    bool operator==(const Transform&) const = default;
};

/// World coordinates from object coordinates, in double (see view_from_world).
[[nodiscard]] glm::dmat4 world_from_object(const Transform& transform);

// The three steps in an order other than that of a scene file. Lecture: "Transformations" (the last one
// written is applied first).

enum class TransformStep { Translate, Rotate, Scale };

/// The steps in the order in which they are written; the last one is applied first.
using TransformOrder = std::array<TransformStep, 3>;
inline constexpr TransformOrder file_order{TransformStep::Translate, TransformStep::Rotate,
                                           TransformStep::Scale};

/// Returns the transform in file order that has the same matrix as `written` in `order`, with the rotation
/// and the scale of `written`. Returns nothing if a scale is written before a rotation with which it does not
/// commute: that shears or scales along other axes, which a scene file cannot express with these numbers.
[[nodiscard]] std::optional<Transform> in_file_order(const Transform& written, const TransformOrder& order);

}  // namespace glint
