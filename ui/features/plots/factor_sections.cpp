// Curves that each show one factor: Lambert's cosine, with a beam that covers more surface the more it
// slants; the falloff; the cone.

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "renderer/explain/equation_text.h"
#include "renderer/reflectance/highlight.h"
#include "renderer/reflectance/lobes.h"
#include "renderer/reflectance/term_sensitivity.h"
#include "ui/features/plots/plot.h"
#include "ui/fields/field_panel.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float beam_units = 40;  // width of the beam, in design units

/// A beam of light that meets a surface, in window coordinates.
struct Beam {
    ImVec2 foot, to_light, across;  // its centre on the surface; unit vectors, y down
};

Beam beam_at(const Rect& room, double deg) {
    const auto angle = static_cast<float>(glm::radians(deg));
    return {{room.low.x + 0.56f * room.size().x, room.high.y - px(26)},
            {-std::sin(angle), -std::cos(angle)},
            {std::cos(angle), -std::sin(angle)}};
}

/// Extends the two edges of the beam to the surface, which is horizontal.
void draw_beam(ImDrawList& list, const Rect& room, double deg) {
    const Beam beam = beam_at(room, deg);
    const float half = px(beam_units) / 2, far = room.size().x + room.size().y;
    const float foot = half / -beam.to_light.y;  // half of d / cos
    const ImVec2 left = beam.foot - ImVec2(foot, 0), right = beam.foot + ImVec2(foot, 0);
    const ImU32 light = to_u32(theme()[Symbol::L]);
    list.AddQuadFilled(left, right, right + far * beam.to_light, left + far * beam.to_light,
                       to_u32(theme()[Symbol::L], 0.22f));
    list.AddLine(left, left + far * beam.to_light, light, px(1.2f));
    list.AddLine(right, right + far * beam.to_light, light, px(1.2f));
    // The beam's width, perpendicular to it, slightly above the surface.
    const ImVec2 middle = beam.foot + px(54) * beam.to_light;
    list.AddLine(middle - half * beam.across, middle + half * beam.across, light, px(2));
    plot_text(list, middle + px(9) * beam.to_light, theme().text, "d", true);
    list.AddLine(left, right, to_u32(theme()[Symbol::Diffuse]), px(4));
    plot_text(list, beam.foot + ImVec2(0, px(13)), theme()[Symbol::Diffuse],
              fmt::format("d / cos θ = {:.2f} d", 1 / std::cos(glm::radians(deg))), true);
}

void draw_surface(ImDrawList& list, const Rect& room, double deg) {
    const Beam beam = beam_at(room, deg);
    list.AddRectFilled({room.low.x, beam.foot.y}, room.high, to_u32(theme().field));
    list.AddLine({room.low.x, beam.foot.y}, {room.high.x, beam.foot.y}, to_u32(theme().text), px(1.2f));
    const ImVec2 top{beam.foot.x, room.low.y + px(14)};
    list.AddLine(beam.foot, top, to_u32(theme()[Symbol::N]), px(1.4f));
    plot_text(list, top + px(1) * ImVec2(5, -6), theme()[Symbol::N], "n");
}

void beam_drawing(double deg) {
    const Rect room = plot_room(120);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    begin_drawing(list, room);
    draw_surface(list, room, deg);
    if (deg < 90) draw_beam(list, room, deg);
    end_drawing(list, room);
}

/// The fraction of the light from this angle that a white matt surface reflects, from the equation's own
/// diffuse term.
double diffuse_at(double light_deg) {
    Reflector white;
    white.reflection = Reflection::Lambert;
    white.material.diffuse = glm::vec3(1);
    return double(reflected(white, in_plane(-light_deg), {0, 0, 1}).diffuse.x);
}

void cosine_curve(double deg) {
    std::vector<glm::dvec2> curve;
    for (int at = 0; at <= 180; at += 2) curve.emplace_back(at, diffuse_at(at));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PlotArea area = draw_axes(list, plot_room(96), {0, 180}, {0, 1.1},
                                    {"θ between n and l", "degrees", true, 45}, {"", ""});
    draw_upright(list, area, 90, theme().dim_text);
    draw_curve(list, area, curve, theme()[Symbol::Diffuse]);
    draw_mark(list, area, {deg, diffuse_at(deg)}, theme()[Symbol::Diffuse]);
    draw_reading(list, area, {{curve, theme()[Symbol::Diffuse]}});
}

constexpr int factor_steps = 240;

/// The largest distance in a falloff plot: beyond the point, and large enough that little light is left.
double farthest_of(const PlotSubject& subject) {
    const double there = subject.point.light != nullptr ? double(subject.point.light->distance) : 0;
    return std::max(2.2 * there, 5.0);  // includes twice the distance
}

}  // namespace

std::vector<glm::dvec2> inverse_square(const std::vector<glm::dvec2>& falloff, const PlotPoint& point) {
    const glm::dvec2 through = point.light != nullptr ? falloff_mark(point) : glm::dvec2(1);
    std::vector<glm::dvec2> law;
    for (const glm::dvec2 p : falloff)
        if (p.x > 0) law.emplace_back(p.x, through.y * through.x * through.x / (p.x * p.x));
    return law;
}

void cosine_section(PlotsState& plots, const PlotSubject& subject) {
    if (!fold("Lambert's cosine: a slanting beam spreads", false)) return;
    const bool picked = subject.point.light != nullptr;
    if (picked) plots.beam_deg = static_cast<float>(local_directions(subject.point).light_deg);
    ImGui::BeginDisabled(picked);
    number_field(
        "Light", plots.beam_deg,
        {.range = half_turn_deg, .unit = "degrees", .step = 0.25f, .format = "%.1f", .usual_max = 180}, 50,
        {"Between n and l; taken from the picked point, if there is one", ""});
    ImGui::EndDisabled();
    const auto deg = double(plots.beam_deg);
    beam_drawing(deg);
    if (deg >= 90) warning_text("At 90° and beyond, the light is behind the surface: nothing arrives.");
    cosine_curve(deg);
    small_dim(
        "max(n·l, 0): the light that arrives, as a fraction of head-on light. Independent of the viewer.");
}

void falloff_section(const PlotSubject& subject) {
    if (!fold("Falloff with the distance to the light", true)) return;
    const auto curve = falloff_curve(subject.scene, subject.light, farthest_of(subject), factor_steps);
    if (curve.empty()) {
        const bool area =
            subject.scene.lights[static_cast<std::size_t>(subject.light)].kind == LightKind::Area;
        return small_dim(area ? "An area light itself has no falloff; its samples do."
                              : "A directional light has no falloff: it is infinitely far away.");
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    double most = 0;
    for (const glm::dvec2 p : curve) most = std::max(most, p.y);
    if (subject.point.light != nullptr)
        most = std::min(most, 4 * std::max(falloff_mark(subject.point).y, 0.25));
    const PlotArea area = draw_axes(list, plot_room(curve_height), {0, curve.back().x}, {0, 1.1 * most},
                                    {"dist", "scene units"}, {"falloff", ""});
    const std::vector<glm::dvec2> law = inverse_square(curve, subject.point);
    draw_curve(list, area, law, theme().dim_text, 1);
    draw_curve(list, area, curve, theme()[Symbol::L]);
    if (subject.point.light != nullptr)
        draw_mark(list, area, falloff_mark(subject.point), theme()[Symbol::L]);
    draw_reading(list, area, {{curve, theme()[Symbol::L]}, {law, theme().dim_text}});
    coloured(Symbol::L, "this light");
    ImGui::SameLine(0, px(10));
    dim_text(subject.point.light != nullptr ? "1 / dist², through the point" : "1 / dist²");
}

void spot_section(const PlotSubject& subject) {
    const auto curve = spot_curve(subject.scene, subject.light, factor_steps);
    if (curve.empty()) return;
    if (!fold("Cone: the light by direction", false)) return;
    const Light& light = subject.scene.lights[static_cast<std::size_t>(subject.light)];
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PlotArea area = draw_axes(list, plot_room(curve_height), {-90, 90}, {0, 1.1},
                                    {"from the axis", "degrees", true, 30}, {"spot", ""});
    for (const float side : {-1.0f, 1.0f})
        for (const float angle : {light.spot.cutoff_deg, light.spot.inner_deg})
            if (angle <= light.spot.cutoff_deg)
                draw_upright(list, area, double(side * angle), theme().dim_text);
    draw_curve(list, area, curve, theme()[Symbol::L]);
    if (subject.point.light != nullptr) draw_mark(list, area, spot_mark(subject.point), theme()[Symbol::L]);
    draw_reading(list, area, {{curve, theme()[Symbol::L]}});
}

// A live table for the picked point: what each kind of light depends on.

namespace {

struct Column {
    const char* title;
    float Moved::*moved;
    const char* what;
};
constexpr std::array columns{
    Column{"light", &Moved::light, "the light's position: surface and viewer move a tenth farther away"},
    Column{"viewer", &Moved::viewer, "the viewer's position: sideways by a tenth of its distance"},
    Column{"surface", &Moved::surface, "the surface's angle: turned by 1°"}};

/// Names the terms that change.
void moved_words(float diffuse, float specular) {
    if (diffuse > 0 && specular > 0) return ImGui::TextUnformatted("both");
    if (diffuse > 0) return coloured(Symbol::Diffuse, "diffuse");
    if (specular > 0) return coloured(Symbol::Specular, "specular");
    coloured(theme().disabled_text, "none");
}

std::string moved_text(const char* term, float moved) {
    return moved > 0 ? fmt::format("{} {:.2g}", term, moved)
                     : fmt::format("{} unchanged, to the last bit", term);
}

/// According to the lecture's table, a sun does not depend on the viewer; its highlight contradicts that.
bool table_fails(LightKind kind, const Column& column, const LightSensitivity& sensitivity) {
    return kind == LightKind::Directional && column.moved == &Moved::viewer &&
           sensitivity.specular.viewer > 0;
}

/// Draws a cell of the table. True if the cell has a star.
bool cell(LightKind kind, const Column& column, const LightSensitivity& sensitivity) {
    ImGui::TableNextColumn();
    ImGui::BeginGroup();
    ImGui::PushFont(fonts().small);
    moved_words(sensitivity.diffuse.*column.moved, sensitivity.specular.*column.moved);
    ImGui::PopFont();
    const bool starred = table_fails(kind, column, sensitivity);
    if (starred) {
        ImGui::SameLine(0, px(4));
        ImGui::TextUnformatted("*");
    }
    ImGui::EndGroup();
    tooltip(column.title, column.what,
            moved_text("diffuse", sensitivity.diffuse.*column.moved) + "\n" +
                moved_text("specular", sensitivity.specular.*column.moved));
    return starred;
}

void figure_cell(float value) {
    ImGui::TableNextColumn();
    mono_text(significant_text(double(value), 3));
}

void header() {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(fonts().small);
    for (const char* title : {columns[0].title, columns[1].title, columns[2].title, "falloff", "cone"}) {
        ImGui::TableNextColumn();
        dim_text(title);
    }
    ImGui::PopFont();
}

}  // namespace

Light of_kind_at(const Light& light, LightKind kind, const ExplainedPoint& at, const PictureView& view) {
    Light other = as_kind(light, kind, view.dome, view.map);
    if (light.kind != kind && kind == LightKind::Spot) {
        const glm::dvec3 way = glm::dvec3(at.point.world) - handle_of(other, view.dome, view.map);
        other.spot.direction = glm::vec3(to_own(other, glm::normalize(way), 0, view.map));
    }
    return other;
}

void kinds_section(const PlotSubject& subject, const PictureView& view) {
    if (!fold("What each kind of light depends on", false)) return;
    if (subject.point.at == nullptr || subject.point.material == nullptr)
        return small_dim(
            "Pick a pixel to see how its terms change when the light, the viewer or the surface moves.");
    const Light& light = subject.scene.lights[static_cast<std::size_t>(subject.light)];
    if (!ImGui::BeginTable("##kinds", 6, ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_SizingStretchProp))
        return;
    header();
    bool starred = false;
    for (const LightKind kind : enumerators<LightKind>) {
        const LightSensitivity sensitivity = light_sensitivity(
            subject.scene, view.map.size, of_kind_at(light, kind, *subject.point.at, view),
            *subject.point.material, subject.point.at->point.camera, subject.point.at->normal.camera);
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        coloured(kind == light.kind ? theme().text : theme().dim_text, choice_of(kind).label);
        for (const Column& column : columns) starred |= cell(kind, column, sensitivity);
        figure_cell(sensitivity.falloff);
        figure_cell(sensitivity.spot);
    }
    ImGui::EndTable();
    small_dim(
        "Which term changes when the light, the viewer or the surface moves? Each kind of light is tried "
        "out, "
        "in white, at this light's position; a spot is aimed at the point.");
    if (starred)
        small_dim(
            "* The lecture's table says that a sun's light does not depend on the viewer: that is true of "
            "its diffuse term.");
}

// A cross-section of a rough surface, with the rays that bounce off it.

namespace {

/// The number of facets in the drawing: the central part of the profile, at which the rays are aimed.
constexpr double shown = 56;
constexpr int max_rays = 48;

/// Maps the section's coordinates to the window, with the same scale along both axes.
struct FacetProfile {
    ImVec2 origin;
    double unit = 1, middle_x = 0, level = 0;
    [[nodiscard]] ImVec2 at(glm::dvec2 p) const {
        return {origin.x + static_cast<float>((p.x - middle_x) * unit),
                origin.y - static_cast<float>((p.y - level) * unit)};
    }
};

void dashed(ImDrawList& list, ImVec2 a, ImVec2 b, ImU32 colour) {
    const int pieces = static_cast<int>(std::min(length_of(b - a) / px(6), 59.0f)) + 1;
    const ImVec2 step = (b - a) / float(pieces);
    for (int i = 0; i < pieces; ++i)
        list.AddLine(a + float(i) * step, a + (float(i) + 0.5f) * step, colour, px(1));
}

void draw_ray(ImDrawList& list, const FacetProfile& section, const FacetRay& ray) {
    constexpr double farther = 6;  // the length of a drawn ray: the drawing's height
    const bool blocked = ray.fate != RayFate::Free;
    const ImVec2 from = section.at(ray.at + farther * (ray.from - ray.at)), at = section.at(ray.at);
    const ImVec2 to = section.at(blocked ? ray.to : ray.at + farther * (ray.to - ray.at));
    list.AddLine(from, at, to_u32(theme()[Symbol::L], blocked ? 0.35f : 0.6f), px(1));
    const ImU32 colour = to_u32(blocked ? theme().warning : theme()[Symbol::R], 0.9f);
    if (ray.fate == RayFate::Free)
        list.AddLine(at, to, colour, px(1));
    else if (ray.fate == RayFate::Shadowed)
        list.AddCircleFilled(at, px(2), colour);
    else
        dashed(list, at, to, colour);
}

void draw_profile(ImDrawList& list, const FacetProfile& section, const MicrofacetPicture& picture,
                  float bottom) {
    for (std::size_t i = 0; i + 1 < picture.profile.size(); ++i) {
        if (std::abs(picture.profile[i].x - section.middle_x) > shown / 2 + 2) continue;
        const ImVec2 a = section.at(picture.profile[i]), b = section.at(picture.profile[i + 1]);
        list.AddQuadFilled(a, b, {b.x, bottom}, {a.x, bottom}, to_u32(theme().field));
        const bool shines =
            std::binary_search(picture.shining.begin(), picture.shining.end(), static_cast<int>(i));
        list.AddLine(a, b, to_u32(shines ? theme()[Symbol::H] : theme().text), px(shines ? 3 : 1.2f));
    }
}

void draw_section(const MicrofacetPicture& picture) {
    const Rect room = plot_room(120);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    begin_drawing(list, room);
    const auto middle = picture.profile.size() / 2;
    FacetProfile section;
    section.unit = double(room.size().x) / shown;
    section.middle_x = picture.profile[middle].x;
    double low = 1e9, sum = 0, count = 0;
    for (const glm::dvec2 p : picture.profile)
        if (std::abs(p.x - section.middle_x) < shown / 2) low = std::min(low, p.y), sum += p.y, ++count;
    section.level = sum / std::max(count, 1.0);
    section.origin = {(room.low.x + room.high.x) / 2, room.low.y + 0.7f * room.size().y};
    std::vector<const FacetRay*> inside;
    for (const FacetRay& ray : picture.rays)
        if (std::abs(ray.at.x - section.middle_x) < shown / 2) inside.push_back(&ray);
    const std::size_t stride = std::max(inside.size() / max_rays, std::size_t{1});
    for (std::size_t i = 0; i < inside.size(); i += stride) draw_ray(list, section, *inside[i]);
    draw_profile(list, section, picture, room.high.y);
    end_drawing(list, room);
}

/// Draws a histogram of the rays' directions, as a lobe.
void draw_histogram(const MicrofacetPicture& picture, const MicrofacetOptions& options) {
    std::vector<glm::dvec2> bars;
    double most = 1e-3;
    for (int i = 0; i < histogram_bins; ++i) {
        const double share = picture.histogram[static_cast<std::size_t>(i)], width = 180.0 / histogram_bins;
        bars.emplace_back(-90 + i * width, share);
        bars.emplace_back(-90 + (i + 1) * width, share);
        most = std::max(most, share);
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PolarArea area = draw_polar_axes(list, plot_room(130), most);
    draw_polar_curve(list, area, bars, theme()[Symbol::R]);
    draw_direction(list, area, -options.light_deg, theme()[Symbol::L], "l", true);
    draw_direction(list, area, picture.h_deg, theme()[Symbol::H], "h", false);
    draw_direction(list, area, options.view_deg, theme()[Symbol::V], "v", false);
}

void fields(PlotsState& plots, const PlotSubject& subject) {
    MicrofacetOptions& options = plots.microfacets;
    const LocalDirections local = local_directions(subject.point);
    const bool can_follow = subject.point.light != nullptr && local.light_deg < 89;
    ImGui::BeginDisabled(!can_follow);
    switch_field("As picked", plots.follow_pick,
                 {"Uses the light's and the viewer's angles at the picked point", ""});
    ImGui::EndDisabled();
    const auto angle = [](const char* label, double& deg, float initial, const char* what) {
        auto value = static_cast<float>(deg);
        const Real number{
            .range = {0, 89, "0 to 89"}, .unit = "degrees", .step = 0.25f, .format = "%.0f", .usual_max = 89};
        if (number_field(label, value, number, initial, {what, ""})) deg = value;
    };
    if (can_follow && plots.follow_pick) {
        options.light_deg = std::round(local.light_deg);
        options.view_deg = std::clamp(std::round(std::abs(local.view_deg)), 0.0, 89.0);
    }
    ImGui::BeginDisabled(can_follow && plots.follow_pick);
    angle("Light", options.light_deg, 30, "From the normal");
    angle("Viewer", options.view_deg, 30,
          "From the normal, on the other side: facets whose normal is h shine");
    ImGui::EndDisabled();
    auto roughness = static_cast<float>(options.roughness);
    const Real number{.range = zero_to_one, .step = 0.005f, .format = "%.2f", .usual_max = 1};
    if (number_field("Roughness", roughness, number, 0.25f,
                     {"The standard deviation of the facets' tilts is this times 90 degrees", ""}))
        options.roughness = double(roughness);
}

}  // namespace

void microfacet_section(PlotsState& plots, const PlotSubject& subject) {
    if (!fold("Microfacets: a rough surface is many mirrors", false)) return;
    fields(plots, subject);
    const MicrofacetPicture& p =
        plots.profile.of(plots.microfacets, [&] { return microfacet_picture(plots.microfacets); });
    draw_section(p);
    legend({{Symbol::L, "in"}, {Symbol::R, "out"}, {Symbol::H, "facets whose normal is h"}});
    warning_text(fmt::format("shadowed {:.0f} %, masked {:.0f} %, inward {:.0f} %", 100 * p.shadowed,
                             100 * p.masked, 100 * p.inward));
    small_dim(fmt::format(
        "Smith: {:.0f} % shadowed · {:.1f} % of the facets shine; their density predicts {:.1f} %",
        100 * (1 - p.smith_g1), 100 * p.shining_share, 100 * p.shining_expected));
    draw_histogram(p, plots.microfacets);
    small_dim("Fraction of the rays leaving in each direction: the lobe.");
}

}  // namespace glint
