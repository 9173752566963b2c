#pragma once
// Stage 4. Lights every point of the surface stage, computes the colour and the bytes of every pixel, and
// draws the strokes over them. Inputs: the surface, the strokes, lights, materials, the rest of `shading` and
// of `npr`, and `display`.

#include <optional>
#include <vector>

#include "renderer/picture.h"
#include "renderer/shade/moving_light.h"
#include "renderer/shade/shade_kernels.h"
#include "renderer/strokes/strokes.h"
#include "renderer/surface/surface.h"

namespace glint {

struct Lighting {
    /// What reaches the surface's points (renderer/transport); nothing: everything does. Points into the
    /// results of that stage.
    std::optional<Arrivals> arrivals;
    std::vector<LightSource> sources, sources_before;
    std::vector<LightJob> jobs;             // one per object
    std::vector<ColorRecord> point_colors;  // Corners, Faces: of the lit points
    std::vector<std::uint32_t> point_rgba;  // Faces: the same as bytes, 16 per block
    std::vector<std::size_t> block_begins;  // with several samples per pixel: first group of each 16 pixels
    Picture picture;
    // Coverage masks (Visibility::covered) of the last picture; empty with strokes or multisampling, which do
    // not use them.
    std::vector<std::uint16_t> covered;
    bool linear = false;  // picture.linear is updated too
    // While only materials change, 1 for each object (by index) to be lit again; empty: all.
    std::vector<std::uint8_t> objects_again;
    MovingLight moving_light;  // while only one light changes
    // The inputs of the cached picture, in addition to the surface and the strokes.
    std::vector<Light> lights;
    std::vector<Material> materials;
    glm::vec3 global_ambient{0};
    Shading shading;
    Npr npr;
    Display display;

    [[nodiscard]] bool again(std::uint32_t object) const {
        return objects_again.empty() || objects_again[object] != 0;
    }
};

/// Which of the earlier stages have run again.
struct RedoneStages {
    bool visibility = false, surface = false, strokes = false, transport = false;
};

/// Runs the stage again if any of its inputs differ; returns whether it did. `arrivals`: as in Lighting.
bool update_lighting(Lighting& kept, const Scene& scene, const Geometry& geometry,
                     const Visibility& visibility, const Surface& surface, const Strokes& strokes,
                     const std::optional<Arrivals>& arrivals, bool linear, RedoneStages redone);

/// Colour of a lit point with reflection `none`: the mesh's vertex colour (white if it has none); for a
/// polygon the mean of its corners.
[[nodiscard]] glm::vec3 vertex_color(const SurfaceInputs& surface, const Geometry& geometry,
                                     const ShadingPoint& source);

/// The display's conversion of linear colours to bytes.
[[nodiscard]] DisplayJob display_job(const Display& display, const Mistakes& mistakes);

// The steps of update_lighting(): the equation at the surface's points (lighting.cpp), then every pixel's
// colour from the lit points, strokes over it, and bytes (color_pixels.cpp).

/// Lights `count` blocks of points from `first` on, each with its object's job; `partial_sums`: sums to which
/// the jobs' lights are added, one for each of these blocks, or null. `arrivals`: what reaches the surface's
/// blocks, from the first on.
void light_blocks(const std::vector<LightJob>& jobs, const Surface& surface, std::size_t first,
                  std::size_t count, const ColorBlock* partial_sums, const std::optional<Arrivals>& arrivals,
                  ColorBlock* colors);

/// Lights `count` blocks of points from `first` on with all lights, or adds the moving one to the cached sum
/// of the others.
void light_points(const Lighting& lighting, const Surface& surface, std::size_t first, std::size_t count,
                  ColorBlock* colors);

/// For Corners and Faces: updates point_colors; for Faces also point_rgba.
void color_points(Lighting& lighting, const Surface& surface, const Geometry& geometry,
                  const DisplayJob& display);

/// Fills the picture with the background and the strokes over it.
void clear_picture(Lighting& lighting, PictureSize size, const Strokes& strokes, const DisplayJob& display);

/// Restores the background only in pixels that showed a surface in the last picture (Lighting::covered) and
/// show none now. Preconditions: no strokes are drawn; size, background and display are unchanged.
void uncover(Lighting& lighting, const Visibility& visibility, const DisplayJob& display);

/// Colours the pixels that show a surface. Preconditions: the picture was cleared since its background,
/// strokes or visibility changed, and point_colors are up to date.
void color_pixels(Lighting& lighting, const Surface& surface, const Strokes& strokes,
                  const DisplayJob& display);

}  // namespace glint
