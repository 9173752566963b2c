#pragma once
// A small plot: axes with numbers and units, curves, marks. Draws into an ImGui draw list; stateless.

#include <imgui.h>

#include <array>
#include <glm/vec2.hpp>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/explain/explain.h"
#include "renderer/reflectance/lobes.h"
#include "renderer/reflectance/microfacets.h"
#include "ui/widgets/area.h"
#include "ui/widgets/kept.h"

namespace glint {

/// An interval of a quantity, low < high.
struct Interval {
    double low = 0, high = 1;
    [[nodiscard]] double length() const { return high - low; }
};

/// The smallest interval that contains the values, widened about its centre to at least `least`, then by
/// `margin` times its length on each side. Ignores values that are not finite; 0 to 1 if there are no others.
[[nodiscard]] Interval range_of(std::span<const double> values, double least = 1e-9, double margin = 0.06);

/// Round numbers inside the range, at most `most` (>= 2) of them, whose step is 1, 2 or 5 times a power of
/// ten.
[[nodiscard]] std::vector<double> ticks(Interval range, int most);

/// A tick's number with as many decimals as its step requires; "0" without a sign.
[[nodiscard]] std::string tick_text(double value, double step);

/// The title of an axis: "r" and "scene units" become "r, scene units".
struct AxisText {
    const char* name = "";
    const char* unit = "";
    bool numbers = true;
    double step = 0;  // step between ticks; 0: chosen from the available size
};

/// A rectangle in the window with a quantity along each side; y upwards.
struct PlotArea {
    Rect rect;
    Interval x, y;

    [[nodiscard]] ImVec2 at(glm::dvec2 value) const;
    [[nodiscard]] glm::dvec2 value(ImVec2 at) const;
};

/// The part of `all` that draw_axes() leaves for curves, with the same axis names.
[[nodiscard]] PlotArea area_within(const Rect& all, Interval x, Interval y, const AxisText& x_text,
                                   const AxisText& y_text);

/// Draws the frame, grid, ticks, numbers and names inside `all`; returns the area left for curves.
[[nodiscard]] PlotArea draw_axes(ImDrawList& list, const Rect& all, Interval x, Interval y,
                                 const AxisText& x_text, const AxisText& y_text);

/// A line through points sorted by x, clipped to the area. If there are more points than the screen can show,
/// each piece keeps its lowest and highest point.
void draw_curve(ImDrawList& list, const PlotArea& area, std::span<const glm::dvec2> points,
                const ImVec4& colour, float width = 1.6f);

/// Marks the current point, optionally with its y as a number.
void draw_mark(ImDrawList& list, const PlotArea& area, glm::dvec2 at, const ImVec4& colour,
               bool figures = true);

/// A curve whose value under the mouse is shown.
struct ReadCurve {
    std::span<const glm::dvec2> points;  // sorted by x
    ImVec4 colour;
};
/// While the mouse is over the area, draws a vertical line there, with the curves' points and values.
void draw_reading(ImDrawList& list, const PlotArea& area, std::initializer_list<ReadCurve> curves);
/// The curve's y at x, interpolated between its points; nullopt outside their range.
[[nodiscard]] std::optional<double> value_at(std::span<const glm::dvec2> points, double x);

/// A point in a plot: a disc with a ring in the background colour around it.
void draw_point(ImDrawList& list, ImVec2 at, const ImVec4& colour);

/// Draws the frame of a drawing without axes, and clips to the frame until end_drawing() is called.
void begin_drawing(ImDrawList& list, const Rect& room);
void end_drawing(ImDrawList& list, const Rect& room);

/// A vertical line across the area at x.
void draw_upright(ImDrawList& list, const PlotArea& area, double x, const ImVec4& colour, float opacity = 1);

/// Red, green or blue (0 to 2), as light or dark as the theme needs.
[[nodiscard]] ImVec4 channel_colour(int channel);

/// Draws text in the small font. `at`: the upper left corner, or the centre if `centre` is true.
void plot_text(ImDrawList& list, ImVec2 at, const ImVec4& colour, const std::string& text,
               bool centre = false);

// A half-disc of directions above a surface: angles from the normal, lengths for amounts.

/// n points up; an amount of `most` reaches the rim.
struct PolarArea {
    ImVec2 centre;
    float radius = 1;
    double most = 1;

    /// The position of `amount` in the direction `deg` from n (positive to the right).
    [[nodiscard]] ImVec2 at(double deg, double amount) const;
};

/// Draws the surface, the rim and rings, one with its number, into `all`, as large as possible; `most` > 0.
[[nodiscard]] PolarArea draw_polar_axes(ImDrawList& list, const Rect& all, double most);

/// Draws a closed outline through points (degrees, amount).
void draw_polar_curve(ImDrawList& list, const PolarArea& area, std::span<const glm::dvec2> curve,
                      const ImVec4& colour, float width = 1.6f);

/// Draws an arrow with its letter, from the rim to the centre (`arriving`) or from the centre to the rim.
void draw_direction(ImDrawList& list, const PolarArea& area, double deg, const ImVec4& colour,
                    const char* letter, bool arrives);

// The plots tab draws curves: falloff, highlight, cone, lobes and microfacets, with the picked point marked
// on each. renderer/reflectance samples the curves; nothing is computed here.

struct UiState;
struct PictureView;

/// A hand-drawn highlight, a value 0 to 1 for each degree from its centre; negative: not drawn.
struct HighlightSketch {
    HighlightSketch() { value.fill(-1); }
    std::array<float, 91> value{};
    std::optional<glm::dvec2> last;  // the mouse position in the previous frame, during a stroke
};
/// Draws a straight stroke between two points (degrees 0 to 90, value).
void add_to_sketch(HighlightSketch& sketch, glm::dvec2 from, glm::dvec2 to);
/// The points drawn so far: (degrees, value), sorted by degrees.
[[nodiscard]] std::vector<glm::dvec2> points_of(const HighlightSketch& sketch);

/// A reflector and a light direction for which the reflected energy is summed.
struct EnergyKey {
    Reflector reflector;
    double light_deg = 0;
    bool operator==(const EnergyKey&) const = default;
};
struct LobeEnergy {
    glm::dvec3 specular{0}, albedo{0};
};

struct PlotsState {
    float beam_deg = 50;  // angle of the slanting beam, if no point is picked
    HighlightSketch sketch;
    MicrofacetOptions microfacets{.rays = 3000, .facets = 1000};  // options of the profile
    bool follow_pick = true;                                      // uses the angles at the picked point
    Kept<float, double> blinn_like;  // the Blinn-Phong shininess closest to a Phong shininess
    Kept<MicrofacetOptions, MicrofacetPicture> profile;
    Kept<EnergyKey, LobeEnergy> energy;
    Kept<Reflector, double> reciprocity;
};

/// One light at the picked point, if a pixel is picked and the light is on.
struct PlotPoint {
    const ExplainedLight* light = nullptr;  // null: no mark
    const ExplainedPoint* at = nullptr;
    const Material* material = nullptr;
};
/// Chooses, from several lit points (corners), the one with the largest weight in the pixel; for an area
/// light, the middle one of its samples.
[[nodiscard]] PlotPoint plot_point(const std::optional<Explanation>& explanation, int light);

/// The mark's position on each plot, from the explanation.
[[nodiscard]] glm::dvec2 falloff_mark(const PlotPoint& point);  // distance, falloff
[[nodiscard]] glm::dvec2 spot_mark(const PlotPoint& point);     // degrees from the axis, factor
/// Degrees between r and v (Phong), or twice those between n and h (Blinn-Phong), and S.
[[nodiscard]] glm::dvec2 highlight_mark(const PlotPoint& point, Reflection reflection);

/// l and v with n along z and l in the xz plane on the -x side, as in
/// renderer/reflectance/lobes.h.
struct LocalDirections {
    glm::vec3 l{0, 0, 1}, v{0, 0, 1};
    double light_deg = 0;  // between n and l, 0 to 180
    double view_deg = 0;   // between n and v, negative on the light's side
};
[[nodiscard]] LocalDirections local_directions(const PlotPoint& point);

/// Points (degrees between n and v, luminance of f) in the plane of incidence; degrees are positive on the
/// mirror side.
struct BrdfCurves {
    std::vector<glm::dvec2> forwards, backwards;  // f(l, v); f(v, l), light and viewer swapped
};
[[nodiscard]] BrdfCurves brdf_curves(const Reflector& reflector, double light_deg);

/// Converts `light` to that kind at the same position; a spot is aimed at the point. Unchanged if the light
/// is already of that kind.
[[nodiscard]] Light of_kind_at(const Light& light, LightKind kind, const ExplainedPoint& at,
                               const PictureView& view);

void plots_tab(UiState& state, const PictureView& view);

// Each section draws into the current window at its width.

/// The scene, light, point and surface that all plots show.
struct PlotSubject {
    const Scene& scene;
    int light = 0;  // index into scene.lights, which is not empty
    PlotPoint point;
    Material material;  // of the picked object, or of the first one; default if there are no objects
};

/// 1 / dist² at the distances of a falloff curve, scaled to pass through the point; without a point, 1 at a
/// distance of 1.
[[nodiscard]] std::vector<glm::dvec2> inverse_square(const std::vector<glm::dvec2>& falloff,
                                                     const PlotPoint& point);

/// Returns the index in Scene::lights of the light whose curves are shown: the selected one, otherwise the
/// one whose vectors are shown (asked_light()), otherwise the first.
[[nodiscard]] int plotted_light(const UiState& state);

/// The area of a plot: as wide as the window, `height` logical pixels high; moves the cursor below it.
[[nodiscard]] Rect plot_room(float height);
/// Height of a curve's plot.
inline constexpr float curve_height = 132;

void falloff_section(const PlotSubject& subject);
void highlight_section(PlotsState& plots, const PlotSubject& subject);
void cosine_section(PlotsState& plots, const PlotSubject& subject);
void sketch_section(UiState& state, PlotsState& plots, const PlotSubject& subject);
void spot_section(const PlotSubject& subject);
void kinds_section(const PlotSubject& subject, const PictureView& view);
void intensities_section(const PlotSubject& subject);
void brdf_section(PlotsState& plots, const PlotSubject& subject);
void lobe_section(PlotsState& plots, const PlotSubject& subject);
void microfacet_section(PlotsState& plots, const PlotSubject& subject);

}  // namespace glint
