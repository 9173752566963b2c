#pragma once
// One mesh under every way of shading and every reflection model, as one picture.

#include <span>

#include "models/mesh/primitives/primitives.h"
#include "models/scene/transform.h"
#include "renderer/picture.h"

namespace glint::golden {

/// What a sheet shows, and the name of its file. Coarse on purpose: the ways of shading differ most there.
struct Subject {
    const char* name;
    Primitive primitive;
    int detail;
    Transform transform;  // within a radius of about 1.2 round the origin
};

[[nodiscard]] std::span<const Subject> subjects();

inline constexpr PictureSize cell{96, 72};

/// Rows: flat, facet, gouraud, phong. Columns: none, lambert, phong, blinn-phong, retro, oren-nayar,
/// cook-torrance. Lit by one light of each kind, one of them in camera coordinates.
[[nodiscard]] Picture make_sheet(const Subject& subject);

/// Columns: the subjects. Rows: cool to warm; silhouettes; creases; all three.
[[nodiscard]] Picture make_drawn_sheet();

}  // namespace glint::golden
