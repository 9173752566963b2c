#pragma once
// Debug views: quantities behind the picture, shown in place of its colours. None of them has a formula of
// its own. Normals are the picture of a white surface under Lambert's law without the clamp, lit by three
// directional lights along the camera's axes; n.l is the picture under the chosen light. So the equation
// itself measures these quantities, as fast as it draws.

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "renderer/picture.h"
#include "renderer/renderer.h"

namespace glint {

enum class DebugView {
    Picture,
    Normal,       // interpolated, camera coordinates; red, green, blue: x, y, z from -1 to 1
    Orientation,  // whether a triangle shows its front or its back, by its winding on the screen
    NDotL,        // for one light, not clamped, in the scene's shading mode
    Depth,        // distance in front of the camera, scene units
    Face,         // which polygon is visible: neighbours in different colours
    FacetAngle,   // between the facet's and the interpolated normal, degrees
    Silhouette,   // the picture with its outline marked: polygonal in every shading mode
    Emission,     // single terms of the sum, as in the picture
    Ambient,
    Diffuse,
    Specular
};
inline constexpr int debug_view_count = 12;

struct DebugViewChoice {
    DebugView view = DebugView::Picture;
    int light = 0;  // for NDotL: index in Scene::lights
    bool operator==(const DebugViewChoice&) const = default;
};

/// A scene whose linear picture is the normal at each pixel, of the facet or interpolated. Mistakes in the
/// normals are kept. Replaces lights, materials, background and strokes.
[[nodiscard]] Scene normal_scene(const Scene& scene, bool facet);
/// A scene whose linear picture is n.l of one light, in all three channels. An area light is treated as a
/// point light at its centre. Precondition: 0 <= light < #lights.
[[nodiscard]] Scene n_dot_l_scene(const Scene& scene, int light);
/// The scene with only one term. Precondition: `term` is Emission, Ambient, Diffuse or Specular.
[[nodiscard]] Scene term_scene(const Scene& scene, DebugView term);

/// The scene with a stroke along its silhouettes in place of its own strokes.
[[nodiscard]] Scene silhouette_scene(const Scene& scene);

/// The scale of a colour bar: numbers from `low` to `high`, in `unit`.
struct DebugViewScale {
    bool has_bar = false;
    double low = 0, high = 1;
    std::string unit;
};

/// The colour, 0 to 255, of a value on a scale: from dark to light, or for NDotL two ramps with a break at 0.
/// Values outside the scale are clamped.
[[nodiscard]] std::array<std::uint8_t, 3> debug_view_color(DebugView view, const DebugViewScale& scale,
                                                           double value);
/// The colour of a normal: (n + 1) / 2.
[[nodiscard]] std::array<std::uint8_t, 3> normal_color(glm::vec3 normal);
/// The colour of a face: consecutive faces in the file get very different colours.
[[nodiscard]] std::array<std::uint8_t, 3> face_color(std::uint64_t number);
/// Blue for the front, red for the back; darker at grazing angles.
[[nodiscard]] std::array<std::uint8_t, 3> side_color(bool front, double n_dot_v);
/// `color` with the stripes that mark normals pointing away from the viewer, n.v < 0, at pixel (x, y).
[[nodiscard]] std::array<std::uint8_t, 3> turned_away_color(std::array<std::uint8_t, 3> color, int x, int y);

class DebugViewPainter {
  public:
    explicit DebugViewPainter(int threads);

    /// Paints the chosen view of `scene`, which `drawn_by` drew last at this size. A light index beyond the
    /// last selects the last light; without lights, n.l is not shown. The background is dark grey.
    const Picture& paint(DebugViewChoice choice, const Scene& scene, const Renderer& drawn_by,
                         PictureSize size);

    [[nodiscard]] const DebugViewScale& scale() const { return scale_; }
    /// The size of the last painted view.
    [[nodiscard]] PictureSize size() const { return picture_.size; }
    /// The number at a pixel of the last painted view, or a word if there is none.
    [[nodiscard]] std::string value_text(int x, int y) const;
    /// The number that value_text() writes; NaN on the background and where the value is not a single number.
    [[nodiscard]] float value_at(int x, int y) const;

  private:
    void measure_normals(const Scene& scene, PictureSize size);
    void measure_angles(const Scene& scene, PictureSize size);
    void measure_n_dot_l(const Scene& scene, int light, PictureSize size);
    void measure_depths(const Renderer& drawn_by, PictureSize size);
    void paint_sides(const Scene& scene, const Renderer& drawn_by, PictureSize size);
    void paint_faces(const Scene& scene, const Renderer& drawn_by, PictureSize size);
    void color_values();

    DebugView view_ = DebugView::Picture;
    std::unique_ptr<Renderer> renderer_, facets_;
    std::vector<float> values_;       // NaN: background
    std::vector<glm::vec3> normals_;  // for Normal, together with
    std::vector<float> facing_;       // n.v; NaN: background
    enum class Side : std::uint8_t { None, Front, Back };
    std::vector<Side> sides_;         // for Orientation
    std::vector<std::string> names_;  // for Face: the names of objects
    std::vector<std::uint64_t> faces_;
    const Picture* terms_ = nullptr;
    DebugViewScale scale_;
    Picture picture_;
};

/// Draws stripes over the pixels of a picture whose linear colour times `exposure` exceeds 1 in any channel,
/// and returns the number of these pixels. Precondition: `linear` is filled.
std::uint64_t stripe_over_range(Picture& picture, float exposure);

// Writes the numbers behind every pixel as pictures, for people who check their own renderer.

struct PixelBuffer {
    std::string name;
    Picture picture;  // only `linear` is filled: three numbers per pixel
};

/// The names of a scene's buffers, in the order in which a program computes them. Background pixels are 0
/// unless noted otherwise; camera coordinates, scene units; scalars are repeated in all three channels.
///   face                      1 for a surface, its object's number, its face's number (from 0)
///   position, depth, normal   of the pixel's own point, which is not lit in the modes flat and gouraud;
///                             depth is the distance in front of the camera
///   side                      1 front, -1 back, by the winding on the screen
///   view                      to the eye; normalized unless corners are lit
///   l_N, n_dot_l_N            to light N of Scene::lights, normalized unless corners are lit; its
///                             cosine, not clamped; none for area lights
///   distance_N, falloff_N, cone_N  of a light with a position; for a spot, the cone's factor
///   r_N, h_N                  l mirrored about n; halfway between l and v
///   emission, global_ambient  terms of the sum (bounced: under the model `bounces`)
///   ambient_N, diffuse_N, specular_N  those of light N
///   ambient, diffuse, specular  those of all lights together
///   sum                       the pixel's linear colour before exposure, including the background
/// Disabled lights have no buffers. If corners are lit, all buffers from `view` on are blended like colours,
/// and vectors become shorter than 1.
[[nodiscard]] std::vector<std::string> buffer_names(const Scene& scene);

/// Returns the buffers `names`, a subset of buffer_names() in the same order, of the renderer's last picture,
/// which must show `scene` with one sample per pixel.
[[nodiscard]] std::vector<PixelBuffer> pixel_buffers(const Renderer& renderer, const Scene& scene,
                                                     PictureSize size, const std::vector<std::string>& names);

/// Returns the number of buffers, out of `all`, that one pass computes. A pass explains every pixel once. The
/// result is the largest of 12, the number that fits in 64 MiB, and an eighth of `all`. So there are at most
/// eight passes, and the time does not grow with the square of the number of lights.
[[nodiscard]] std::size_t buffers_at_once(PictureSize size, std::size_t all);
/// Calls visit() with the buffers `names`, a subset of buffer_names() in the same order, until it returns
/// false. Throws LimitExceeded if the buffers of one pass exceed memory_limit().
void visit_pixel_buffers(const Renderer& renderer, const Scene& scene, PictureSize size,
                         const std::vector<std::string>& names,
                         const std::function<bool(const PixelBuffer&)>& visit);
/// The memory used by `buffers` buffers, in bytes.
[[nodiscard]] std::uint64_t buffers_memory(PictureSize size, std::size_t buffers);

}  // namespace glint
