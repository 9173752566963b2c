#pragma once
// Stage 4. Colours: lights every point that the surface stage kept, gives every pixel its colour and its
// bytes, and draws the strokes over them. Inputs: the surface, the strokes, lights, materials, the rest of
// `shading` and of `npr`, and `display`.

#include <vector>

#include "renderer/picture.h"
#include "renderer/pipeline/strokes.h"
#include "renderer/pipeline/surface.h"

namespace glint {

struct Lighting {
    std::vector<LightSource> sources;
    std::vector<LightJob> jobs;            // one an object
    std::vector<ColorBlock> point_colors;  // Corners, Faces: of the lit points
    Picture picture;
    bool linear = false;  // picture.linear is kept up too
    bool keep_sums = true;
    // What the kept picture was made of, beside the surface and the strokes.
    std::vector<Light> lights;
    std::vector<Material> materials;
    glm::vec3 global_ambient{0};
    Shading shading;
    Npr npr;
    Display display;
};

/// Which of the stages before were done again.
struct RedoneStages {
    bool visibility = false, surface = false, strokes = false;
};

/// Does the stage again when anything it reads differs; true when it did.
bool update_lighting(Lighting& kept, const Scene& scene, const Geometry& geometry, const Surface& surface,
                     const Strokes& strokes, bool linear, RedoneStages redone);

/// Colour of a lit point under reflection `none`: the mesh's vertex colour (white where it has none); for a
/// polygon the mean of its corners.
[[nodiscard]] glm::vec3 vertex_color(const SurfaceInputs& surface, const Geometry& geometry,
                                     const PointSource& source);

[[nodiscard]] DisplayJob display_job(const Display& display);

}  // namespace glint
