// The vectors drawn at the picked point in the picture.

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "models/mesh/normals.h"
#include "models/scene/reflection.h"
#include "renderer/reflectance/highlight.h"
#include "renderer/reflectance/lobes.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/vectors/arrows.h"
#include "ui/features/inspector/vectors/vectors_tab.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

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
        // Letters are placed first, so that angles avoid them.
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
    const bool roomy = std::max(high.x - low.x, high.y - low.y) > px(48);  // or the labels would overlap
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

// The facet's own normal.

std::optional<Facet> picked_facet(const Explanation& explanation, const Scene& scene) {
    const auto object = static_cast<std::size_t>(explanation.object_index);
    if (!explanation.hit || object >= scene.objects.size()) return {};
    const MeshPtr& mesh = scene.objects[object].mesh;
    if (!mesh || explanation.face >= mesh->face_count()) return {};
    Facet facet;
    for (const std::uint32_t p : mesh->corners_of(explanation.face))
        facet.corners.push_back(mesh->positions[p]);
    if (facet.corners.size() < 3) return {};
    facet.edge_a = facet.corners[1] - facet.corners[0];
    facet.edge_b = facet.corners[2] - facet.corners[0];
    facet.cross = glm::cross(facet.edge_a, facet.edge_b);
    facet.of_edges = facet_normal(facet.corners[0], facet.corners[1], facet.corners[2]);
    facet.newell = facet_normal(*mesh, explanation.face);
    return facet;
}

void facet_section(const UiState& state, const Explanation& explanation) {
    const auto facet = picked_facet(explanation, explained_scene(state));
    if (!facet) return;
    section_heading("The facet's own normal, object coordinates");
    const Symbol edge = Symbol::Construction;
    vector_line(edge, "1→2", facet->edge_a);
    vector_line(edge, "1→3", facet->edge_b);
    vector_line(Symbol::N, "1→2 × 1→3", facet->cross);
    vector_line(Symbol::N, "normalised", facet->of_edges);
    vector_line(Symbol::N, "Newell", facet->newell);
    const float length = glm::length(facet->cross);
    const Object& object = explained_scene(state).objects[static_cast<std::size_t>(explanation.object_index)];
    const bool is_mirrored = glm::determinant(glm::dmat3(world_from_object(object.transform))) < 0;
    small_dim(fmt::format(
        "The product's length is {:.4g}: twice the area of the triangle 1 2 3. The {} corners run "
        "counter-clockwise seen from outside, {}.",
        length, facet->corners.size(),
        explanation.front_facing != is_mirrored ? "and from here too" : "but clockwise from here"));
    if (glm::dot(facet->of_edges, facet->newell) < 0.9999f && length > 0)
        warning_text("The facet is not planar, or not convex: Newell's method uses all its corners.");
}

void draw_facet(ImDrawList& list, const UiState& state, const PictureView& view) {
    const auto facet = picked_facet(*state.on_screen.explanation, explained_scene(state));
    if (!facet) return;
    const Object& object =
        explained_scene(state).objects[static_cast<std::size_t>(state.on_screen.explanation->object_index)];
    const glm::dmat4 world = world_from_object(object.transform);
    std::vector<glm::dvec3> corners;
    glm::dvec3 middle(0);
    for (const glm::vec3 corner : facet->corners) {
        corners.emplace_back(world * glm::dvec4(glm::dvec3(corner), 1));
        middle += corners.back() / double(facet->corners.size());
    }
    const WorldPen outline{list, view};
    for (const auto& [colour, width] : {std::pair(rim_colour(), 1.2f + rim_width), {IM_COL32_WHITE, 1.2f}})
        for (std::size_t i = 0; i < corners.size(); ++i)
            outline.line(corners[i], corners[(i + 1) % corners.size()], colour, px(width));
    for (const std::size_t to : {1, 2})
        if (const auto ends = view.shown(corners[0], corners[to]))
            draw_arrow(list, ends->first, ends->second, {dark_theme()[Symbol::Construction], 2.5f, ""});
    constexpr std::size_t max_numbered = 24;  // corners; more numbers than this would overlap
    for (std::size_t i = 0; i < std::min(corners.size(), max_numbered); ++i)
        if (const ProjectedPoint at = project(view.map, corners[i]); at.in_front)
            rimmed_text(list, view.to_window(at.pixel) + ImVec2(0, px(12)), {1, 1, 1, 1},
                        std::to_string(i + 1));
    if (!project(view.map, middle).in_front) return;
    // Normals transform by the inverse transpose; a mirrored scale reverses the winding.
    const glm::dmat3 normal_matrix = glm::transpose(glm::inverse(glm::dmat3(world)));
    const glm::dvec3 n = normal_matrix * glm::dvec3(facet->newell);
    if (glm::length(n) == 0) return;
    const PointPen pen = pen_at(list, view, middle, 70);
    draw_arrow(list, pen.at(glm::dvec3(0)), pen.at(glm::normalize(n)), {dark_theme()[Symbol::N], 2.5f, "n"});
}

// The plane of incidence, seen from the side.

namespace {

constexpr int lobe_steps = 120;

/// The plane of n and l as two axes: `up` along n, `across` away from the light.
struct IncidencePlane {
    glm::vec3 up{0, 1, 0}, across{1, 0, 0};
    [[nodiscard]] glm::vec2 of(glm::vec3 v) const { return {glm::dot(v, across), glm::dot(v, up)}; }
};

IncidencePlane plane_of(const ExplainedPoint& point, const ExplainedLight& light) {
    const glm::vec3 n = point.normal.camera, away = n * light.n_dot_l - light.l.camera;
    if (glm::length(away) > 1e-4f) return {n, glm::normalize(away)};
    const glm::vec3 v = point.view.camera, side = v - n * glm::dot(n, v);  // if l is n, towards the viewer
    return {n, glm::length(side) > 1e-4f ? glm::normalize(side) : glm::vec3(1, 0, 0)};
}

class Diagram {
  public:
    /// `lowest`: how far an arrow extends below the ground, relative to a unit vector.
    explicit Diagram(float lowest) {
        const float width = ImGui::GetContentRegionAvail().x;
        reach_ = std::min(0.36f * width, px(110));
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float below = std::max(lowest * reach_ + px(20), px(16));
        const float height = reach_ + px(34) + below;
        foot_ = {low.x + width / 2, low.y + height - below};
        left_ = low.x, right_ = low.x + width;
        ImGui::Dummy({width, height});
    }
    [[nodiscard]] ImVec2 at(glm::vec2 p) const { return {foot_.x + p.x * reach_, foot_.y - p.y * reach_}; }

    void ground() const {
        list_.AddLine({left_ + px(8), foot_.y}, {right_ - px(8), foot_.y}, to_u32(theme().dim_text), px(1));
    }
    void arrow(glm::vec2 to, Symbol symbol, bool thick) const {
        const ImVec2 tip = at(to);
        const ImU32 ink = to_u32(theme()[symbol]);
        list_.AddLine(foot_, tip, ink, px(thick ? 4.0f : 2.0f));
        list_.AddCircleFilled(tip, px(3), ink);
        const float out = px(symbol == Symbol::H ? 23 : 11);  // h is often close to n
        const float size = std::max(std::hypot(to.x, to.y), 0.05f);
        centred(tip + out / size * ImVec2(to.x, -to.y), ink, letter_of(symbol));
    }
    /// Draws an arc clockwise from n, with its angle in degrees outside the arc.
    void arc(double degrees, double radius, Symbol symbol) const {
        const auto angle = static_cast<float>(degrees * std::numbers::pi / 180);
        const auto r = static_cast<float>(radius);
        constexpr float up = -std::numbers::pi_v<float> / 2;
        if (std::abs(angle) < 0.02f) return;
        list_.PathArcTo(foot_, r * reach_, up, up + angle, 20);
        list_.PathStroke(to_u32(theme()[symbol]), 0, px(1));
        centred(at((r + 0.17f) * glm::vec2(std::sin(angle / 2), std::cos(angle / 2))),
                to_u32(theme()[symbol]), fmt::format("{:.0f}°", std::abs(degrees)));
    }
    void lobe(const std::vector<glm::vec2>& outline, const ImVec4& colour) const {
        for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
            list_.AddTriangleFilled(foot_, at(outline[i]), at(outline[i + 1]), to_u32(colour, 0.13f));
            list_.AddLine(at(outline[i]), at(outline[i + 1]), to_u32(colour, 0.8f), px(1));
        }
    }

  private:
    void centred(ImVec2 middle, ImU32 ink, const std::string& text) const {
        list_.AddText(middle - ImGui::CalcTextSize(text.c_str()) / 2, ink, text.c_str());
    }

    ImDrawList& list_ = *ImGui::GetWindowDrawList();
    ImVec2 foot_;
    float reach_ = 1, left_ = 0, right_ = 0;
};

/// The lobe in polar form, scaled so that its longest ray is a unit vector.
std::vector<glm::vec2> lobe_outline(const UiState& state, double light_deg) {
    const Shading& shading = explained_scene(state).shading;
    const Reflector reflector = reflector_of(state.on_screen.explanation->material, shading);
    const std::vector<LobeSample> slice = lobe_slice(reflector, light_deg, lobe_steps);
    const auto strength = [&](const LobeSample& s) {
        return (s.reflected.diffuse + s.reflected.specular)[state.get<InspectorState>().channel];
    };
    float most = 1e-6f;
    for (const LobeSample& sample : slice) most = std::max(most, strength(sample));
    std::vector<glm::vec2> outline;
    for (const LobeSample& sample : slice) {
        const double angle = sample.view_deg * std::numbers::pi / 180;
        outline.push_back(strength(sample) / most * glm::vec2(std::sin(angle), std::cos(angle)));
    }
    return outline;
}

}  // namespace

void lobe_diagram(const UiState& state, const ExplainedPoint& point, const ExplainedLight& light) {
    const auto pointed = state.get<InspectorState>().pointed_vector;
    const IncidencePlane plane = plane_of(point, light);
    const float lowest = -std::min({plane.of(light.l.camera).y, plane.of(light.r.camera).y,
                                    plane.of(light.h.camera).y, plane.of(point.view.camera).y, 0.0f});
    const Diagram diagram(lowest);
    ImGui::PushFont(fonts().small);
    diagram.ground();
    const double light_deg = angle_deg(light.n_dot_l);
    if (light_deg < 89.5) diagram.lobe(lobe_outline(state, light_deg), theme()[Symbol::Specular]);
    const ReflectionInfo model = info_of(state.on_screen.explanation->reflection);
    const auto arrow = [&](Symbol symbol, const InBothFrames& v) {
        diagram.arrow(plane.of(v.camera), symbol, pointed == symbol);
    };
    arrow(Symbol::N, point.normal);
    if (model.uses_r()) {
        arrow(Symbol::R, light.r);
        diagram.arc(light_deg, 0.5, Symbol::R);
    }
    if (model.uses_h) arrow(Symbol::H, light.h);
    arrow(Symbol::L, light.l);
    arrow(Symbol::V, point.view);
    diagram.arc(-light_deg, 0.5, Symbol::L);
    ImGui::PopFont();
    const float out_of_plane = glm::length(plane.of(point.view.camera));
    small_dim(
        fmt::format("The plane of n and l; v is {:.0f}° out of it. The lobe shows the reflected light by "
                    "direction, scaled to length 1.",
                    angle_deg(out_of_plane)));
}

// The rays behind the equation of the picked pixel: to the lights, and one path of bounced light.

namespace {

/// The end point for drawing a ray that hits nothing.
glm::dvec3 far_along(const PictureView& view, glm::vec3 from, glm::vec3 to) {
    return glm::dvec3(from) + 2 * view.dome.radius * glm::normalize(glm::dvec3(to - from));
}

void draw_ray(const WorldPen& pen, const TracedLight& ray, bool directional, ImU32 colour) {
    const glm::dvec3 light = directional ? far_along(pen.view, ray.from, ray.to) : glm::dvec3(ray.to);
    if (ray.reached()) return pen.cased(glm::dvec3(ray.from), light, colour, 1);
    pen.cased(glm::dvec3(ray.hit), light, colour, 0.3f, 0.8f);
    pen.cased(glm::dvec3(ray.from), glm::dvec3(ray.hit), colour, 1);
    pen.mark(glm::dvec3(ray.hit), colour, 1, true);
    const ProjectedPoint at = project(pen.view.map, glm::dvec3(ray.hit));
    if (!at.in_front) return;
    const ImVec2 place = pen.view.to_window(at.pixel);
    list_control("first hit", "", {place - px(1) * ImVec2(5, 5), place + px(1) * ImVec2(5, 5)});
}

void draw_path(const WorldPen& pen, const Scene& scene, const std::vector<PathStep>& path) {
    const ImU32 colour = to_u32(dark_theme()[Symbol::Ambient]);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const PathStep& step = path[i];
        const glm::dvec3 from(step.from), to(step.to);
        if (step.object < 0) {
            pen.cased(from, far_along(pen.view, step.from, step.to), colour, 0.4f, 0.8f);
            continue;
        }
        pen.cased(from, to, colour, 1);
        if (step.reached && static_cast<std::size_t>(step.light) < scene.lights.size()) {
            const Light& light = scene.lights[static_cast<std::size_t>(step.light)];
            pen.cased(to, handle_of(light, pen.view.dome, pen.view.map), to_u32(colour_of(light)), 0.5f,
                      0.8f);
        }
        pen.mark(to, colour, 1, false);
        const ProjectedPoint at = project(pen.view.map, to);
        if (at.in_front)
            rimmed_text(pen.list, pen.view.to_window(at.pixel) - ImVec2(0, px(12)), {1, 1, 1, 1},
                        std::to_string(i + 1));
    }
}

void path_rows(const Scene& scene, const std::vector<PathStep>& path) {
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const PathStep& step = path[i];
        const auto object = static_cast<std::size_t>(step.object),
                   light = static_cast<std::size_t>(step.light);
        if (object >= scene.objects.size()) {
            small_dim(fmt::format("{}  hits nothing: the path ends", i + 1));
            continue;
        }
        const glm::vec3 adds = step.throughput * (step.emission + step.direct);
        sum += adds;
        ImGui::TextUnformatted(whole_label(fmt::format("{}  {}", i + 1, scene.objects[object].name)).c_str());
        small_dim(fmt::format("throughput {}", shown_vector(step.throughput)));
        small_dim(fmt::format("adds {}", shown_vector(adds)));
        if (light < scene.lights.size())
            small_dim(
                fmt::format("{} {}", step.reached ? "lit by" : "not reached by", scene.lights[light].name));
    }
    small_dim(fmt::format("Light from this path: {}", shown_vector(sum)));
}

}  // namespace

void trace_shown(UiState& state) {
    const OnScreen& shown = state.on_screen;
    InspectorState& inspector = state.get<InspectorState>();
    if (shown.passing) return;  // the numbers remain those of the previous scene
    inspector.rays.clear();
    inspector.path.clear();
    const Renderer* renderer = shown.explained_by;
    if (inspector.tab != InspectorTab::Equation || renderer == nullptr || !shown.explanation ||
        !shown.explanation->hit)
        return;
    if (ImGui::IsAnyMouseDown() && !renderer->has_rays()) return;  // setting them up would delay a drag
    const Explanation& e = *shown.explanation;
    inspector.rays = renderer->shadow_rays(e.x, e.y, inspector.corner);
    if (inspector.shows_path && asked_point(inspector, e).bounces.used)
        inspector.path = renderer->bounce_path(e.x, e.y, inspector.path_number - 1, inspector.corner);
}

void draw_traced(ImDrawList& list, const UiState& state, const PictureView& view) {
    const InspectorState& inspector = state.get<InspectorState>();
    if (!state.on_screen.explanation || !state.on_screen.explanation->hit) return;
    const WorldPen pen{list, view};
    draw_path(pen, explained_scene(state), inspector.path);
    const std::vector<ExplainedLight>& lights = asked_point(inspector, *state.on_screen.explanation).lights;
    const ExplainedLight* light = asked_light(state, asked_point(inspector, *state.on_screen.explanation));
    if (!inspector.shows_ray || light == nullptr || lights.size() != inspector.rays.size()) return;
    draw_ray(pen, inspector.rays[static_cast<std::size_t>(light - lights.data())],
             light->samples.empty() && light->distance == 0, to_u32(dark_theme()[Symbol::L]));
}

void traced_controls(UiState& state, const ExplainedPoint& point) {
    InspectorState& inspector = state.get<InspectorState>();
    const ExplainedBounces& bounces = point.bounces;
    const int all = explained_scene(state).transport.paths;
    std::string text = fmt::format("Bounced light: {}", bounces.paths);
    text += bounces.paths < all  ? fmt::format(" of {} paths so far", all)
            : bounces.paths == 1 ? " path"
                                 : " paths";
    // One path has no variance.
    if (bounces.paths > 1) text += ", standard error " + shown_vector(bounces.standard_error);
    if (bounces.used) small_dim(text);
    inspector.shows_ray ^= small_chosen_button("Show the ray", inspector.shows_ray);
    tooltip("Show the ray", "From the point to the selected light, and what it hits first");
    if (!bounces.used) return;
    ImGui::SameLine();
    inspector.shows_path ^= small_chosen_button("Show a path", inspector.shows_path);
    tooltip("Show a path", "One of the random paths of bounced light, step by step");
    if (!inspector.shows_path) return;
    integer_field("Path", inspector.path_number, {1, bounces.paths}, 1, {"Which of the paths is shown", ""});
    inspector.path_number = std::clamp(inspector.path_number, 1, bounces.paths);
    path_rows(explained_scene(state), inspector.path);
}

}  // namespace glint
