#pragma once
// A small plot: axes with numbers and units, curves, marks. Draws into an ImGui list; stateless.

#include <imgui.h>

#include <glm/vec2.hpp>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/widgets/area.h"

namespace glint {

/// An interval of a quantity, low < high.
struct Interval {
    double low = 0, high = 1;
    [[nodiscard]] double length() const { return high - low; }
};

/// The smallest interval that contains the values, widened about its middle to at least `least`, then by
/// `margin` times its length on each side. Ignores values that are not finite; without any: 0 to 1.
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
    double step = 0;  // step between ticks; 0: chosen by the available size
};

/// A rectangle of the window with a quantity along each side; y upwards.
struct PlotArea {
    Rect rect;
    Interval x, y;

    [[nodiscard]] ImVec2 at(glm::dvec2 value) const;
    [[nodiscard]] glm::dvec2 value(ImVec2 at) const;
};

/// The part of `all` that draw_axes() leaves for curves, with the same axis names.
[[nodiscard]] PlotArea area_within(const Rect& all, Interval x, Interval y, const AxisText& x_text,
                                   const AxisText& y_text);

/// Draws frame, grid, ticks, numbers and names inside `all`; returns the area left for curves.
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
/// While the mouse is over the area: a line at its x, the curves' points there, and their numbers.
void draw_reading(ImDrawList& list, const PlotArea& area, std::initializer_list<ReadCurve> curves);
/// The curve's y at an x, between its points; nullopt outside them.
[[nodiscard]] std::optional<double> value_at(std::span<const glm::dvec2> points, double x);

/// A point of a plot: a disc on a ring of the background's colour.
void draw_point(ImDrawList& list, ImVec2 at, const ImVec4& colour);

/// Draws the frame of a drawing without axes; drawings between the two calls are clipped to it.
void begin_drawing(ImDrawList& list, const Rect& room);
void end_drawing(ImDrawList& list, const Rect& room);

/// A vertical line across the area at x.
void draw_upright(ImDrawList& list, const PlotArea& area, double x, const ImVec4& colour, float opacity = 1);

/// Red, green or blue (0 to 2), as light or dark as the theme needs.
[[nodiscard]] ImVec4 channel_colour(int channel);

/// Text in the small font. `at`: its corner, or (centre) its middle.
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

/// A closed outline of (degrees, amount).
void draw_polar_curve(ImDrawList& list, const PolarArea& area, std::span<const glm::dvec2> curve,
                      const ImVec4& colour, float width = 1.6f);

/// An arrow from the rim to the centre (arriving) or out to the rim, with its letter.
void draw_direction(ImDrawList& list, const PolarArea& area, double deg, const ImVec4& colour,
                    const char* letter, bool arrives);

}  // namespace glint
