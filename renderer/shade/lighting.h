#pragma once
// Stage 4. Lights every point of the surface stage, computes the colour and bytes of every pixel, and draws
// the strokes over them. Inputs: the surface, the strokes, lights, materials, the rest of `shading` and
// `npr`, and `display`.

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"
#include "renderer/picture.h"
#include "renderer/shade/shade_kernels.h"
#include "renderer/strokes/strokes.h"
#include "renderer/surface/surface.h"

namespace glint {

// Part of stage 4. While only one light is dragged, caches the sum of all others at each point, and finds the
// pixels that the light may have changed. The picture is bit-identical to adding all lights again, because
// each light's contribution is rounded to a grid on which sums are exact (renderer/lighting/surface_point.h).

/// Which of 16 groups of pixels must be recomputed. Bit i: group i. All others are up to date.
struct GroupsToDo {
    unsigned light = 0xFFFF;  // to be lit with the moving light, or with all lights
    unsigned others_only =
        0;  // groups that the moving light no longer reaches; they show the sum of the others
};

class MovingLight {
  public:
    bool allowed = true;  // false: adds all lights in every frame, for measurements

    /// Updates the sums for the light `moving` (index in Scene::lights), the only one that has changed since
    /// the last frame; -1: none or several have changed. `same_grids`: each object's grid is unchanged. Does
    /// not follow a light if the sum of any object is not exact.
    void follow(int moving, bool same_grids, const std::vector<LightSource>& sources,
                const std::vector<LightJob>& jobs, const Surface& surface);

    [[nodiscard]] bool is_followed() const { return moving_ >= 0; }
    /// One job per object, with only the moving light. Precondition of this and the following function:
    /// is_followed().
    [[nodiscard]] const std::vector<LightJob>& jobs() const { return jobs_; }
    /// The sums of the other lights, linear RGB, starting at block `first` of the surface's points.
    [[nodiscard]] const ColorBlock* others(std::size_t first) const { return &others_[first]; }

    /// Returns which of the 16 groups, starting at group 16 * `batch`, must be recomputed, and marks them as
    /// up to date. Without a followed light, these are all 16 groups. Thread-safe for different batches.
    [[nodiscard]] GroupsToDo groups_to_do(std::size_t batch);
    /// Invalidates the cached picture: all groups will be recomputed.
    void forget_picture();

  private:
    void split(int moving, const std::vector<LightSource>& sources, const std::vector<LightJob>& jobs);
    void light_others(const std::vector<LightJob>& jobs, const Surface& surface);

    int moving_ = -1;  // index in Scene::lights of the followed light, or -1
    std::vector<LightSource> moving_sources_, other_sources_;
    std::vector<LightJob> jobs_;
    std::vector<ColorBlock> others_;   // #points: the sums of the other lights
    std::vector<BoundsBlock> bounds_;  // each for 16 groups; empty for per-vertex and per-face shading
    // Bit i of word b: the cached picture of group 16 b + i includes light from the moving light. 0xFFFF:
    // unknown, so the groups must be recomputed.
    std::vector<std::uint16_t> shown_lit_;
};

/// The index of the only light that has changed, or -1 if none or several have.
[[nodiscard]] int changed_light(const std::vector<Light>& kept, const std::vector<Light>& now);

/// Returns LightJob::grid: a power of two. Each light's contribution is rounded to a multiple of it, so that
/// the sum is exact. 0, meaning no rounding, if a contribution has no bound (near a light without constant
/// falloff, an area light, Cook-Torrance), if the bounds are so high that rounding might be visible at this
/// exposure, or if there are too few lights for caching to pay off.
[[nodiscard]] float rounding_grid(const LightJob& job, float exposure);

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
