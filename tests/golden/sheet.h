#pragma once
// One mesh in every shading mode and reflection model, as one picture.

#include <span>

#include "models/mesh/primitives/primitives.h"
#include "models/scene/scene.h"
#include "renderer/picture.h"

namespace glint::golden {

/// The subject of a sheet, and its file name. Coarsely tessellated on purpose, because shading modes differ
/// most there.
struct Subject {
    const char* name;
    Primitive primitive;
    int detail;
    Transform transform;  // within a radius of about 1.2 around the origin
};

[[nodiscard]] std::span<const Subject> subjects();

inline constexpr PictureSize cell{96, 72};

/// Rows: flat, facet, gouraud, phong. Columns: none, lambert, phong, blinn-phong, retro, oren-nayar,
/// cook-torrance. Lit by one light of each kind, one of them in camera coordinates.
[[nodiscard]] Picture make_sheet(const Subject& subject);

/// Columns: the subjects. Rows: cool to warm; silhouettes; creases; all three.
[[nodiscard]] Picture make_drawn_sheet();

}  // namespace glint::golden
