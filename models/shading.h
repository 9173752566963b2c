#pragma once
// How points are lit and how the lit points fill the picture: two choices that never mix (lecture: "Lighting vs.
// Shading"). Plain enums and switches, included by the lighting kernels of every instruction set: keep it free of
// the standard library.

namespace glint {

enum class ShadingMode { Flat, Facet, Gouraud, Phong };
enum class Reflection { None, Lambert, Phong, BlinnPhong, Retro, OrenNayar, CookTorrance };
enum class Interpolation { Perspective, Screen, Scanline };
enum class FlatPoint { Centroid, Provoking };
enum class Cull { None, Back, Front };
enum class Rules { Lecture, OpenGL2 };

struct Terms {
    bool emission = true, ambient = true, diffuse = true, specular = true;
    bool operator==(const Terms&) const = default;
};

struct Shading {
    ShadingMode mode = ShadingMode::Phong;
    Reflection reflection = Reflection::Phong;
    Interpolation interpolation = Interpolation::Perspective;
    FlatPoint flat_point = FlatPoint::Centroid;
    bool two_sided = false;
    bool local_viewer = true;
    Cull cull = Cull::None;
    Rules rules = Rules::Lecture;
    Terms terms;
    bool operator==(const Shading&) const = default;
};

}  // namespace glint
