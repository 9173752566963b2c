// The vectors drawn at the picked point in the picture.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "models/scene/reflection.h"
#include "renderer/reflectance/highlight.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/vectors/arrows.h"
#include "ui/features/inspector/vectors/vectors_tab.h"
#include "ui/ui.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"

namespace glint {
namespace {

constexpr float arrow_length = 92;  // logical pixels, of a unit vector seen from the side

class PointDrawing {
  public:
    PointDrawing(ImDrawList& list, const UiState& state, const PictureView& view, const ExplainedPoint& point)
        : state_(state),
          point_(point),
          pen_(pen_at(list, view, glm::dvec3(point.point.world), arrow_length)) {}

    void draw() {
        const ExplainedLight* light = asked_light(state_, point_);
        const bool alone =
            light != nullptr && light->samples.empty() && state_.get<InspectorState>().mirror_step == 0;
        // Letters are placed first: degrees avoid them.
        if (light != nullptr && !light->samples.empty()) fan(*light);
        if (light != nullptr && light->samples.empty() && !alone) mirror(*light);
        if (alone) arrows_of(*light);
        if (light != nullptr) arrow(Symbol::V, point_.view);
        arrow(Symbol::N, point_.normal);
        if (alone) arcs_of(*light);
        words_.draw(pen_.list);
    }

  private:
    void arrow(Symbol symbol, const InBothFrames& v) {
        const bool thick = state_.get<InspectorState>().pointed_vector == symbol;
        draw_arrow(pen_.list, pen_.at(glm::dvec3(0)), pen_.at(glm::dvec3(v.world)),
                   {theme_colour(symbol), thick ? 4.5f : 2, letter_of(symbol), &words_});
    }
    /// Bright enough for any picture, regardless of the theme.
    static ImVec4 theme_colour(Symbol symbol) { return dark_theme()[symbol]; }

    void arc(const InBothFrames& a, const InBothFrames& b, double radius, Symbol symbol) {
        draw_arc(pen_, glm::dvec3(a.world), glm::dvec3(b.world), radius, theme_colour(symbol), words_);
    }
    [[nodiscard]] bool has_r() const { return info_of(state_.on_screen.explanation->reflection).uses_r(); }
    [[nodiscard]] bool has_h() const { return info_of(state_.on_screen.explanation->reflection).uses_h; }
    void arrows_of(const ExplainedLight& light) {
        if (has_r()) arrow(Symbol::R, light.r);
        if (has_h()) arrow(Symbol::H, light.h);
        arrow(Symbol::L, light.l);
    }
    void arcs_of(const ExplainedLight& light) {
        const InBothFrames& n = point_.normal;
        arc(n, light.l, 0.45, Symbol::L);
        if (has_r()) arc(n, light.r, 0.45, Symbol::R);
        if (has_r() && state_.get<InspectorState>().pointed_vector == Symbol::R)
            arc(light.r, point_.view, 0.7, Symbol::V);
        if (has_h()) arc(n, light.h, 0.7, Symbol::H);
    }
    /// Draws the l of each sample of an area light.
    void fan(const ExplainedLight& light) {
        for (const ExplainedLight& sample : light.samples)
            draw_arrow(pen_.list, pen_.at(glm::dvec3(0)), pen_.at(glm::dvec3(sample.l.world)),
                       {theme_colour(Symbol::L), 1, ""});
    }
    /// Draws the construction of q, 2 q and r from a normal of the chosen length.
    void mirror(const ExplainedLight& light) {
        const InspectorState& inspector = state_.get<InspectorState>();
        const glm::vec3 n = inspector.normal_length * point_.normal.world, l = light.l.world;
        const MirrorSteps steps = mirror_steps(n, l);
        const auto draw = [&](glm::vec3 from, glm::vec3 to, ImVec4 colour, const char* letter, float width) {
            draw_arrow(pen_.list, pen_.at(glm::dvec3(from)), pen_.at(glm::dvec3(to)),
                       {colour, width, letter, &words_});
        };
        draw({}, l, theme_colour(Symbol::L), "l", 2);
        draw({}, n, theme_colour(Symbol::N), "n", 2);
        if (inspector.mirror_step >= 2) draw(l, steps.p, theme_colour(Symbol::Construction), "", 1);
        if (inspector.mirror_step == 2) draw({}, steps.p, theme_colour(Symbol::Construction), "q", 3);
        if (inspector.mirror_step >= 3) draw({}, steps.twice_p, theme_colour(Symbol::Construction), "2q", 3);
        if (inspector.mirror_step < 4) return;
        draw(steps.twice_p, steps.r, theme_colour(Symbol::Construction), "−l", 1);
        draw({}, steps.r, theme_colour(Symbol::R), "r", 3);
    }

    const UiState& state_;
    const ExplainedPoint& point_;
    PointPen pen_;
    Words words_;
};

/// Where a corner is marked: its position, or the picture's edge in its direction from the picked point.
struct CornerMark {
    ImVec2 at;
    ImVec2 way;  // unit, from the picked point; (0, 0) if the corner is in the picture
};

CornerMark mark_of(const PictureView& view, const Rect& shown, const ExplainedCorner& corner, ImVec2 picked) {
    const glm::dvec3 world(corner.at.point.world);
    const ProjectedPoint place = project(view.map, world);
    if (place.in_front && shown.holds(view.to_window(place.pixel))) return {view.to_window(place.pixel), {}};
    const glm::dvec3 in_view(view.map.view_from_world * glm::dvec4(world, 1));
    ImVec2 way = place.in_front ? view.to_window(place.pixel) - picked
                                : ImVec2(float(in_view.x), float(-in_view.y));  // behind the eye
    way = way / std::max(length_of(way), 1e-6f);
    const ImVec2 low = shown.low + px(1) * ImVec2(28, 28), high = shown.high - px(1) * ImVec2(28, 14);
    const auto room = [](float from, float along, float least, float most) {
        if (std::abs(along) < 1e-6f) return std::numeric_limits<float>::max();
        return std::max(((along > 0 ? most : least) - from) / along, 0.0f);
    };
    const float reach = std::min(room(picked.x, way.x, low.x, high.x), room(picked.y, way.y, low.y, high.y));
    return {picked + reach * way, way};
}

/// An arrowhead that points to something outside the picture.
void draw_pointer(ImDrawList& list, const CornerMark& mark) {
    const ImVec2 across{-mark.way.y, mark.way.x};
    const ImVec2 tip = mark.at + px(14) * mark.way, foot = mark.at + px(8) * mark.way;
    list.AddTriangleFilled(tip, foot + px(5) * across, foot - px(5) * across, IM_COL32_WHITE);
}

/// Draws the corners from which the pixel is interpolated, each in its colour, with its weight.
void draw_corners(ImDrawList& list, const PictureView& view, const Explanation& explanation,
                  glm::ivec2 picked) {
    if (!explanation.lit_per_corner || explanation.corners.size() < 2) return;
    const ImVec2 middle = view.to_window(glm::dvec2(picked) + 0.5);
    std::vector<CornerMark> marks;
    for (const ExplainedCorner& corner : explanation.corners)
        marks.push_back(mark_of(view, clip_area(list), corner, middle));
    ImVec2 low = marks.front().at, high = low;
    for (const CornerMark& mark : marks) {
        low = {std::min(low.x, mark.at.x), std::min(low.y, mark.at.y)};
        high = {std::max(high.x, mark.at.x), std::max(high.y, mark.at.y)};
    }
    const bool roomy = std::max(high.x - low.x, high.y - low.y) > px(48);  // else the labels overlap
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const ExplainedCorner& corner = explanation.corners[i];
        const glm::vec3 c = glm::clamp(corner.at.sum, 0.0f, 1.0f);
        const char letter = static_cast<char>('A' + i);
        rimmed_disc(list, marks[i].at, 5, to_u32({c.x, c.y, c.z, 1}));
        if (length_of(marks[i].way) > 0) draw_pointer(list, marks[i]);
        if (roomy)
            rimmed_text(list, marks[i].at - ImVec2(0, px(14)), {1, 1, 1, 1},
                        fmt::format("{} {:.2f}", letter, corner.weight));
        list_control(fmt::format("corner {}", letter).c_str(), "",
                     {marks[i].at - px(1) * ImVec2(5, 5), marks[i].at + px(1) * ImVec2(5, 5)});
    }
}

}  // namespace

void draw_point_vectors(ImDrawList& list, const UiState& state, const PictureView& view) {
    const InspectorState& column = state.get<InspectorState>();
    if (!state.on_screen.explanation || !state.on_screen.explanation->hit) return;
    if (column.shows_facet) draw_facet(list, state, view);
    if (!column.shows_vectors || state.on_screen.explanation->reflection == Reflection::None) return;
    draw_corners(list, view, *state.on_screen.explanation, state.on_screen.pixel);
    PointDrawing(list, state, view, asked_point(column, *state.on_screen.explanation)).draw();
}

}  // namespace glint
