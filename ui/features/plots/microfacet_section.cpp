// A rough surface in section, with the rays that bounce off it.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/features/plots/plot.h"
#include "ui/features/plots/plots_tab.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Facets across the drawing: the middle of the profile, at which the rays are aimed.
constexpr double shown = 56;
constexpr int max_rays = 48;

/// Maps the section's coordinates to the window: the same scale along both axes.
struct Section {
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

void draw_ray(ImDrawList& list, const Section& section, const FacetRay& ray) {
    constexpr double farther = 6;  // as long as the drawing is high
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

void draw_profile(ImDrawList& list, const Section& section, const MicrofacetPicture& picture, float bottom) {
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
    Section section;
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
                 {"Uses the light's and the viewer's angle at the picked point", ""});
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
                     {"The tilts' standard deviation is this times 90 degrees", ""}))
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
    small_dim("Share of rays leaving in each direction: the lobe.");
}

}  // namespace glint
