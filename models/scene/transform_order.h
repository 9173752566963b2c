#pragma once
// An object's three transforms written in another order than a scene file has them. Lecture:
// "Transformations" (the last one that is written is the first one that happens).

#include <array>
#include <optional>

#include "models/scene/transform.h"

namespace glint {

enum class TransformStep { Translate, Rotate, Scale };

/// The steps in the order in which they are written; the last one is applied first.
using TransformOrder = std::array<TransformStep, 3>;
inline constexpr TransformOrder file_order{TransformStep::Translate, TransformStep::Rotate,
                                           TransformStep::Scale};

/// Returns the transform in file order that has the same matrix as `written` in `order`, with the rotation
/// and the scale of `written`. Nothing where a scale is written before a rotation with which it does not
/// commute: that shears or scales along other axes, which a scene file cannot express with these numbers.
[[nodiscard]] std::optional<Transform> in_file_order(const Transform& written, const TransformOrder& order);

}  // namespace glint
