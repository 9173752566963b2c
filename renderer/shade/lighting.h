#pragma once
// Stage 4. Lights every point of the surface stage, computes the colour and bytes of every pixel, and draws
// the strokes over them. Inputs: the surface, the strokes, lights, materials, the rest of `shading` and
// `npr`, and `display`.

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"
#include "renderer/picture.h"
#include "renderer/shade/moving_light.h"
#include "renderer/shade/shade_kernels.h"
#include "renderer/strokes/strokes.h"
#include "renderer/surface/surface.h"

namespace glint {

struct Lighting {
    /// The light that reaches the surface's points (renderer/transport). If empty, nothing is blocked. Points
    /// into the results of that stage.
    std::optional<Arrivals> arrivals;
    std::vector<LightSource> sources;
    std::vector<LightJob> jobs;             // one per object
    std::vector<ColorRecord> point_colors;  // Corners, Faces: colours of the lit points
    std::vector<std::uint32_t> point_rgba;  // Faces: the same as bytes, 16 per block
    std::vector<std::size_t> block_begins;  // with several samples per pixel: first group of each 16 pixels
    Picture picture;
    // Coverage masks (Visibility::covered) of the last picture. Empty with strokes or multisampling, which do
    // not use them.
    std::vector<std::uint16_t> covered;
    bool linear = false;  // whether picture.linear is updated too
    // While only materials change, 1 for each object (by index) that must be lit again. Empty: all objects.
    std::vector<std::uint8_t> objects_again;
    MovingLight moving_light;  // used while only one light changes
    // The other inputs of the cached picture, apart from the surface and the strokes.
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

/// Runs the stage again if any of its inputs has changed; returns whether it did. `arrivals`: as in Lighting.
bool update_lighting(Lighting& kept, const Scene& scene, const Geometry& geometry,
                     const Visibility& visibility, const Surface& surface, const Strokes& strokes,
                     const std::optional<Arrivals>& arrivals, bool linear, RedoneStages redone);

/// The colour of a lit point with reflection `none`: the mesh's vertex colour (white if it has none), or for
/// a polygon the mean over its corners.
[[nodiscard]] glm::vec3 vertex_color(const SurfaceInputs& surface, const Geometry& geometry,
                                     const ShadingPoint& source);

/// The conversion of linear colours to displayed bytes.
[[nodiscard]] DisplayJob display_job(const Display& display, const Mistakes& mistakes);

// The steps of update_lighting(): evaluates the equation at the surface's points (lighting.cpp), then
// computes every pixel's colour from the lit points, draws strokes, and converts to bytes (color_pixels.cpp).

/// Lights `count` blocks of points, starting at `first`, each with its object's job. `partial_sums`: the sums
/// to which the jobs' lights are added, one for each of these blocks, or null. `arrivals`: the light that
/// reaches the surface's blocks, starting at block 0.
void light_blocks(const std::vector<LightJob>& jobs, const Surface& surface, std::size_t first,
                  std::size_t count, const ColorBlock* partial_sums, const std::optional<Arrivals>& arrivals,
                  ColorBlock* colors);

/// Lights `count` blocks of points, starting at `first`, with all lights, or adds the moving light to the
/// cached sum of the others.
void light_points(const Lighting& lighting, const Surface& surface, std::size_t first, std::size_t count,
                  ColorBlock* colors);

/// For Corners and Faces: updates point_colors. For Faces, also updates point_rgba.
void color_points(Lighting& lighting, const Surface& surface, const Geometry& geometry,
                  const DisplayJob& display);

/// Fills the picture with the background and draws the strokes over it.
void clear_picture(Lighting& lighting, PictureSize size, const Strokes& strokes, const DisplayJob& display);

/// Restores the background in pixels that showed a surface in the last picture (Lighting::covered) but do not
/// show one now. Preconditions: there are no strokes; size, background and display are unchanged.
void uncover(Lighting& lighting, const Visibility& visibility, const DisplayJob& display);

/// Computes the pixels that show a surface. Preconditions: the picture has been cleared since background,
/// strokes or visibility changed, and point_colors are up to date.
void color_pixels(Lighting& lighting, const Surface& surface, const Strokes& strokes,
                  const DisplayJob& display);

// Converts a material to the kernels' input, including mistakes.

/// The maximum shininess in OpenGL 2.1.
inline constexpr float opengl_max_shininess = 128;

[[nodiscard]] inline Float3 to_float3(const glm::vec3& c) { return {c.x, c.y, c.z}; }
[[nodiscard]] inline Float3 to_float3(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The material with mistakes applied.
[[nodiscard]] Material mistaken_material(const Mistakes& mistakes, Material material);

/// A material in the equation's form, without k_a I_a: `global_ambient` is 0.
[[nodiscard]] SurfaceMaterial surface_material(const Material& material);

/// The square of the cosine whose power is 2^-24, the last bit of a highlight of 1. For a shininess of 0, for
/// which every cosine gives a highlight (0^0 is 1), the lowest float, which is less than any signed square.
[[nodiscard]] float min_cosine_squared(float shininess);

}  // namespace glint
