#include "ui/features/views/debug_view_controls.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "ui/commands/command.h"
#include "ui/feature.h"
#include "ui/features/plots/plot.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr std::array<DebugViewInfo, debug_view_count> infos{{
    {DebugView::Picture, "Picture", "The picture itself"},
    {DebugView::Normal, "Normals",
     "Red, green, blue are x, y, z in camera coordinates, from −1 to 1; striped where n·v < 0, away from the "
     "viewer"},
    {DebugView::Orientation, "Front and back",
     "Which side of a face is visible, by the order of its corners on the screen: blue is the front, red the "
     "back"},
    {DebugView::NDotL, "n·l",
     "The cosine between the normal and one light, before it is clamped: blue faces away"},
    {DebugView::Depth, "Depth", "Distance in front of the camera, in scene units: near is light"},
    {DebugView::Face, "Faces", "Every polygon in its own colour"},
    {DebugView::FacetAngle, "Facet – normal",
     "Angle between the polygon's own normal and the interpolated one: where smooth shading deviates"},
    {DebugView::Silhouette, "Silhouette",
     "The outline drawn over the picture: on a coarse mesh, its corners show under any shading"},
    {DebugView::Emission, "Emission alone", "One term of the sum"},
    {DebugView::Ambient, "Ambient alone", "One term of the sum"},
    {DebugView::Diffuse, "Diffuse alone", "One term of the sum"},
    {DebugView::Specular, "Specular alone", "One term of the sum"},
}};

ImU32 packed_bytes(std::array<std::uint8_t, 3> c) { return IM_COL32(c[0], c[1], c[2], 255); }

/// Draws the near or the far half of a ball of normals, seen from the camera. Each direction has exactly its
/// colour in the picture.
void draw_normal_ball(ImDrawList& list, ImVec2 centre, float radius, bool away) {
    constexpr int cells = 24;
    const float cell = 2 * radius / cells;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const float x = (float(i) + 0.5f) * 2 / cells - 1, y = 1 - (float(j) + 0.5f) * 2 / cells;
            const float squared = 1 - x * x - y * y;
            if (squared < 0) continue;
            const float z = (away ? -1.0f : 1.0f) * std::sqrt(squared);
            const auto colour = normal_color({x, y, z});
            const ImVec2 low = centre - radius * ImVec2(1, 1) + cell * ImVec2(float(i), float(j));
            list.AddRectFilled(low, low + (cell + 0.5f) * ImVec2(1, 1),
                               packed_bytes(away ? turned_away_color(colour, i, j) : colour));
        }
}

/// A colour sample and its label, in a legend that has no bar.
struct Sample {
    const char* words;
    void (*draw)(ImDrawList& list, ImVec2 centre, float radius);
};
std::span<const Sample> samples_of(DebugView view) {
    static constexpr Sample normals[] = {
        {"towards you", [](ImDrawList& l, ImVec2 at, float r) { draw_normal_ball(l, at, r, false); }},
        {"away, n·v < 0", [](ImDrawList& l, ImVec2 at, float r) { draw_normal_ball(l, at, r, true); }}};
    static constexpr Sample sides[] = {
        {"front", [](ImDrawList& l, ImVec2 at,
                     float r) { l.AddCircleFilled(at, r, packed_bytes(side_color(true, 1))); }},
        {"back", [](ImDrawList& l, ImVec2 at, float r) {
             l.AddCircleFilled(at, r, packed_bytes(side_color(false, 1)));
         }}};
    if (view == DebugView::Normal) return normals;
    if (view == DebugView::Orientation) return sides;
    return {};
}

/// Half the height of a row.
float sample_radius(DebugView view) { return px(view == DebugView::Normal ? 16 : 6); }

void draw_samples(ImDrawList& list, DebugView view, ImVec2 low) {
    const float radius = sample_radius(view);
    for (const Sample& sample : samples_of(view)) {
        sample.draw(list, low + ImVec2(radius, radius), radius);
        const ImVec2 words = low + ImVec2(2 * radius + px(5), radius - small_text_height() / 2);
        plot_text(list, words, theme().text, sample.words);
        low.x += px(122);
    }
}

struct Reading {
    const char* name;
    std::string text;
    float value;
};

void draw_bar(ImDrawList& list, const DebugViewState& state, const Rect& bar,
              std::span<const Reading> readings) {
    const DebugViewScale& scale = state.painter->scale();
    constexpr int steps = 64;
    const Interval range{scale.low, scale.high};
    const auto x_of = [&](double value) {
        const double share = (value - range.low) / range.length();
        return bar.low.x + static_cast<float>(std::clamp(share, 0.0, 1.0)) * bar.size().x;
    };
    for (int i = 0; i < steps; ++i) {
        const double value = range.low + range.length() * (i + 0.5) / steps;
        list.AddRectFilled({bar.low.x + bar.size().x * float(i) / steps, bar.low.y},
                           {bar.low.x + bar.size().x * float(i + 1) / steps + 0.5f, bar.high.y},
                           packed_bytes(debug_view_color(state.set.choice.view, scale, value)));
    }
    const std::vector<double> marks = ticks(range, 5);
    const double step = marks.size() > 1 ? marks[1] - marks[0] : range.length();
    for (const double mark : marks) {
        list.AddLine({x_of(mark), bar.high.y}, {x_of(mark), bar.high.y + px(3)}, to_u32(theme().dim_text));
        plot_text(list, {x_of(mark), bar.high.y + px(10)}, theme().dim_text, tick_text(mark, step), true);
    }
    for (const Reading& reading : readings) {
        if (std::isnan(reading.value)) continue;
        const float x = x_of(reading.value);
        arrow_head(list, {x, bar.low.y + px(3)}, {0, 1}, 7, 4, to_u32(theme().text));
    }
}

std::vector<Reading> readings_of(const DebugViewState& state, const PictureView& view,
                                 std::optional<glm::ivec2> picked) {
    std::vector<Reading> readings;
    const auto add = [&](const char* name, glm::ivec2 whole) {
        const glm::ivec2 p = pixel_at_place(whole, view.map.size, state.painter->size());
        readings.push_back({name, state.painter->value_text(p.x, p.y), state.painter->value_at(p.x, p.y)});
    };
    if (picked) add("picked", *picked);
    const glm::dvec2 cursor = view.to_pixel(ImGui::GetIO().MousePos);
    if (ImGui::IsMousePosValid() && is_inside(view.map.size, cursor)) add("cursor", glm::ivec2(cursor));
    return readings;
}

std::string title_of(const DebugViewState& state, const Scene& scene) {
    const DebugViewChoice& choice = state.set.choice;
    if (choice.view != DebugView::NDotL) {
        const std::string unit = choice.view == DebugView::Depth        ? ", scene units"
                                 : choice.view == DebugView::FacetAngle ? ", degrees"
                                                                        : "";
        return info_of(choice.view).label + unit;
    }
    if (scene.lights.empty()) return "n·l: no lights";
    const std::size_t light =
        std::min(static_cast<std::size_t>(std::max(choice.light, 0)), scene.lights.size() - 1);
    return "n·l of " + scene.lights[light].name;
}

}  // namespace

const DebugViewInfo& info_of(DebugView view) { return infos[static_cast<std::size_t>(view)]; }

DebugView debug_view_after(DebugView view, int steps) {
    return static_cast<DebugView>((static_cast<int>(view) + steps + debug_view_count) % debug_view_count);
}

bool debug_view_choice(DebugViewState& state) {
    DebugView& view = state.set.choice.view;
    bool chosen = false;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, small_padding());
    const bool plain = view == DebugView::Picture;
    ImGui::PushStyleColor(ImGuiCol_FrameBg, plain ? theme().field : theme().accent);
    ImGui::PushStyleColor(ImGuiCol_Button, plain ? theme().field : theme().accent);
    ImGui::PushStyleColor(ImGuiCol_Text, plain ? theme().text : theme().accent_text);
    // In a narrow row, the drop-down leaves room for the buttons of a comparison, so that they never
    // disappear.
    ImGui::SetNextItemWidth(std::clamp(ImGui::GetContentRegionAvail().x - px(215), px(50), px(126)));
    const bool open = ImGui::BeginCombo("##look", info_of(view).label, ImGuiComboFlags_HeightLargest);
    ImGui::PopStyleColor(3);
    if (open) {
        for (const DebugViewInfo& info : infos) {
            if (info.view == DebugView::Emission) ImGui::Separator();
            if (ImGui::Selectable(info.label, info.view == view)) view = info.view, chosen = true;
            tooltip(info.label, info.what);
        }
        ImGui::EndCombo();
    } else {
        tooltip("The shown quantity", info_of(view).what, "",
                keys_of(CommandId::NextDebugView) + ", " + keys_of(CommandId::PreviousDebugView));
    }
    ImGui::SameLine(0, px(4));
    ImGui::PopStyleVar();
    return chosen;
}

void light_choice(DebugViewState& state, const Scene& scene) {
    if (state.set.choice.view != DebugView::NDotL || scene.lights.empty()) return;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, small_padding());
    ImGui::SetNextItemWidth(px(86));
    int& light = state.set.choice.light;  // index in the edited scene, which may have more lights
    int shown = std::min(light, static_cast<int>(scene.lights.size()) - 1);
    const int before = shown;
    (void)light_combo("##debug_view_light", shown, scene.lights);
    if (shown != before) light = shown;
    ImGui::PopStyleVar();
    tooltip("Light", "The light whose n·l is shown, even if it is off");
    ImGui::SameLine(0, px(4));
}

float legend_width(const DebugViewState& state) {
    const DebugView shown = state.set.choice.view;
    if (shown == DebugView::Picture || !state.painter) return 0;
    return px(samples_of(shown).empty() ? 236 : 256);
}

void draw_debug_view_legend(ImDrawList& list, const DebugViewState& state, const Scene& scene,
                            const PictureView& view, std::optional<glm::ivec2> picked) {
    const DebugView shown = state.set.choice.view;
    if (shown == DebugView::Picture || !state.painter) return;
    const bool has_bar = state.painter->scale().has_bar;
    const float samples = samples_of(shown).empty() ? 0 : 2 * sample_radius(shown) + px(6);
    const std::vector<Reading> readings = readings_of(state, view, picked);
    const float line = small_text_height() + px(3);
    const ImVec2 size{legend_width(state),
                      px(14) + line * float(1 + readings.size()) + (has_bar ? px(32) : 0) + samples};
    const Rect area = clip_area(list);
    const ImVec2 low{area.low.x + px(8), area.high.y - px(8) - size.y};
    badge_ground(list, {low, low + size});
    ImVec2 at = low + px(1) * ImVec2(10, 6);
    plot_text(list, at, theme().text, title_of(state, scene));
    at.y += line;
    draw_samples(list, shown, at + ImVec2(0, px(2)));
    at.y += samples;
    if (has_bar) {
        draw_bar(list, state, {at + px(1) * ImVec2(6, 5), {low.x + size.x - px(16), at.y + px(13)}},
                 readings);
        at.y += px(32);
    }
    for (const Reading& reading : readings) {
        plot_text(list, at, theme().dim_text, reading.name);
        list.AddText(fonts().figures, small_text_height(), at + ImVec2(px(46), 0), to_u32(theme().text),
                     reading.text.c_str());
        at.y += line;
    }
}

// Picks the brightest, the darkest or the first clipped pixel of the surfaces in the picture.

namespace {

enum class Sought { None, Brightest, Darkest, Clipped };

/// Waits for a picture that includes linear colours.
struct FindPixelState {
    Sought sought = Sought::None;
};

/// How well a colour matches; the first pixel with the largest value is picked. `exposure` as in the scene.
float fitness(Sought sought, glm::vec3 linear, float exposure) {
    const float luminance = glm::dot(linear, {0.2126f, 0.7152f, 0.0722f});  // ITU-R BT.709
    if (sought == Sought::Brightest) return luminance;
    if (sought == Sought::Darkest) return -luminance;
    return exposure * std::max({linear.x, linear.y, linear.z}) > 1.0005f ? 1 : -HUGE_VALF;
}

std::optional<glm::ivec2> find(Sought sought, const UiState& state) {
    const Picture& picture = *state.rendered;
    std::optional<glm::ivec2> best;
    float most = -HUGE_VALF;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) {
            if (state.renderer->object_at(x, y) < 0) continue;
            const float fits =
                fitness(sought, picture.linear_at(x, y), state.rendered_scene.display.exposure);
            if (fits > most) most = fits, best = glm::ivec2(x, y);
        }
    return best;
}

void pick_found(UiState& state) {
    Sought& sought = state.get<FindPixelState>().sought;
    if (sought == Sought::None) return;
    if (state.rendered->linear.empty() || !(state.rendered->size == state.full_size)) return redraw_within(0);
    const Sought wanted = std::exchange(sought, Sought::None);
    const std::optional<glm::ivec2> found = find(wanted, state);
    if (!found)
        return state.notifications.tell(
            wanted == Sought::Clipped ? "No pixel is clipped" : "No surface is visible", Tone::Warning);
    const PictureSize size = state.rendered->size;
    ask_about(state.viewport, (glm::dvec2(*found) + 0.5) / glm::dvec2(size.width, size.height));
    state.layout.right = state.left_shows_inspector = state.viewport.touched = true;
    constexpr const char* names[] = {"", "Brightest", "Darkest", "First clipped"};
    state.notifications.tell(
        fmt::format("{} pixel: {}, {}", names[static_cast<int>(wanted)], found->x, found->y));
    redraw_within(0);
}

template <Sought what> WindowCommand find_command(const char* name, const char* words) {
    return {.name = name,
            .section = Section::InspectFind,
            .run = [](UiState& s) { s.get<FindPixelState>().sought = what; },
            .why_disabled =
                [](const UiState& s) {
                    const std::string refusal = s.on_screen.refusal();
                    return refusal.empty() ? unless_drawn(s.rendered) : refusal;
                },
            .line_above = what == Sought::Brightest,
            .words = words};
}

std::vector<WindowCommand> find_commands() {
    return {find_command<Sought::Brightest>("Go to the brightest pixel", "find maximum"),
            find_command<Sought::Darkest>("Go to the darkest pixel", "find minimum"),
            find_command<Sought::Clipped>("Go to the first clipped pixel", "find overexposed bright")};
}

}  // namespace

extern const Feature find_pixel_feature;
const Feature find_pixel_feature{
    .update = pick_found,
    .needs =
        [](const UiState& s) {
            const bool seeks = s.get<FindPixelState>().sought != Sought::None;
            return PictureNeeds{.linear = seeks, .full_size = seeks};
        },
    .commands = find_commands,
    .leave_document = [](UiState& s, const SceneDocument&) { s.get<FindPixelState>() = {}; }};

}  // namespace glint
