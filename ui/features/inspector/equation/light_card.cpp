// A card for each light: its part of the equation at the picked point.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "models/scene/reflection.h"
#include "renderer/explain/equation_text.h"
#include "ui/features/inspector/equation/equation_tab.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/ui.h"
#include "ui/widgets/kept.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

glm::vec3 vector_of(Quantity letter, const ExplainedPoint& point, const ExplainedLight& light) {
    switch (letter) {
    case Quantity::L:
        return light.l.camera;
    case Quantity::V:
        return point.view.camera;
    case Quantity::R:
        return light.r.camera;
    case Quantity::H:
        return light.h.camera;
    default:
        return point.normal.camera;
    }
}

/// "n·l 0.713 44.5°": a cosine with its angle. Hovering over it highlights the arrow `to` in the picture. A
/// mistake may leave a vector unnormalised, so its length scales the product. Then the cosine is drawn
/// as a warning, and the length ("|n| 1.250") is added to `causes` unless it is already there.
void angle(TextLine& line, UiState& state, Quantity cosine, Symbol to, float value,
           const ExplainedPoint& point, const ExplainedLight& light, std::string& causes) {
    const auto [first, second] = vectors_of(cosine);
    const glm::vec3 a = vector_of(first, point, light), b = vector_of(second, point, light);
    const float lengths = glm::length(a) * glm::length(b);
    const float of_unit_vectors = lengths > 0 ? glm::dot(a, b) / lengths : value;
    const bool has_length = std::abs(value - of_unit_vectors) > 1e-3f;
    for (const auto& [letter, v] : {std::pair(first, a), std::pair(second, b)}) {
        const std::string name = fmt::format("|{}|", row_of(letter).letter);
        if (has_length && std::abs(glm::length(v) - 1) > 1e-3f && causes.find(name) == causes.npos)
            causes += fmt::format("{}{}{}", causes.empty() ? "" : " ", name, shown_number(glm::length(v)));
    }
    const double degrees = angle_deg(has_length ? of_unit_vectors : value);
    ImVec2 low;
    line.together([&] {
        line.symbol(cosine);
        low = last_item().low - ImVec2(px(14), 0);
        line.gap(4).number(fmt::format("{} {:5.1f}°", shown_number(value), degrees),
                           has_length ? theme().warning : theme().text);
    });
    const Rect area{low, last_item().high};
    line.gap(8);
    list_control(fmt::format("angle {}", row_of(cosine).letter).c_str(), "", area);
    if (is_pointed_at(area)) state.get<InspectorState>().pointed_vector = to;
}

void angles(UiState& state, const Explanation& explanation, const ExplainedPoint& point,
            const ExplainedLight& light, QuantityMark* mark) {
    TextLine line(0, mark);
    std::string causes;
    const auto angle_of = [&](Quantity cosine, Symbol to, float value) {
        angle(line, state, cosine, to, value, point, light, causes);
    };
    line.copied_as(fmt::format("n·l {}, r·v {}, n·h {}", short_text(light.n_dot_l, 4),
                               short_text(light.r_dot_v, 4), short_text(light.n_dot_h, 4)));
    angle_of(Quantity::NL, Symbol::L, light.n_dot_l);
    const ReflectionInfo info = info_of(explanation.reflection);
    if (info.cosine == HighlightCosine::LV) angle_of(Quantity::LV, Symbol::L, light.l_dot_v);
    if (info.uses_r()) angle_of(Quantity::RV, Symbol::R, light.r_dot_v);
    if (info.uses_h) angle_of(Quantity::NH, Symbol::H, light.n_dot_h);
    if (causes.empty()) return;
    line.plain(causes, theme().warning);
    tooltip(causes.c_str(),
            "Not unit length: the length scales the product, so it is not the angle's cosine");
    list_control(causes.c_str(), "", last_item());
}

/// A number of the light, with `decimals` decimals.
NumberHandle light_number(const HandledScene& scene, int light, const char* key, int decimals) {
    NumberHandle handle = number_handle(scene, fmt::format("/lights/{}/{}", light, key));
    handle.number.kind.format = decimal_format(handle.number.value, decimals);
    return handle;
}

/// The ray from the lit point to a light, in the light's own coordinates.
struct Ray {
    int light = -1;
    glm::dvec3 lit{0}, way{0};  // way: unit length
    glm::vec4 written{0};       // the light's position as last set along the ray
};

Ray ray_to(const Light& light, const ExplainedLight& explained) {
    const glm::dvec3 way = light.space == LightSpace::World ? explained.l.world : explained.l.camera;
    const glm::dvec3 place = glm::dvec3(light.position) / double(light.position.w);
    return {explained.index, place - double(explained.distance) * way, way, light.position};
}

/// "dist" and the number that moves the light towards or away from the point, without changing l.
void distance_handle(TextLine& line, const HandledScene& scene, const ExplainedLight& explained,
                     int decimals) {
    const auto index = static_cast<std::size_t>(explained.index);
    const Light& light = scene.shown.lights[index];
    float distance = explained.distance;
    NumberHandle handle = light_number(scene, explained.index, "position/0", decimals);
    handle.name = "Distance of " + light.name;
    handle.number.help = "Moves the light along l, towards the point or away from it";
    handle.number.pointer = fmt::format("/lights/{}/position", explained.index);
    handle.number.initial = std::numeric_limits<double>::quiet_NaN();  // no position is a natural default
    handle.number.kind = {.range = above_zero,
                          .unit = "scene units",
                          .format = decimal_format(distance, decimals),
                          .logarithmic = true};
    handle.number.value = distance;
    handle.number.place = scene.edited != nullptr ? &distance : nullptr;
    // Kept while the number is being edited: typing "0.5" passes through a distance of "0", at which the
    // direction to the light would be lost.
    Ray& kept = widget_state<Ray>();
    const bool goes_on = number_in_hand() && kept.light == explained.index && light.position == kept.written;
    const Ray ray = goes_on ? kept : ray_to(light, explained);
    line.symbol(Quantity::Distance).gap(2).handle(handle, theme().text);
    if (distance == explained.distance) return;
    scene.edited->lights[index].position = glm::vec4(ray.lit + double(distance) * ray.way, 1);
    kept = {explained.index, ray.lit, ray.way, light.position};
}

/// The numbers of "falloff = 1 / (constant + linear dist + quadratic dist²), dist".
void falloff_line(const HandledScene& scene, const ExplainedLight& explained) {
    const Falloff& f = scene.shown.lights[static_cast<std::size_t>(explained.index)].falloff;
    const std::array<double, 4> values{f.constant, f.linear, f.quadratic, explained.distance};
    constexpr std::array least{2, 2, 2, 2};
    const double last_digit = last_digit_of(shown_number(explained.falloff));
    const std::vector<int> decimals = decimals_for(
        values, least,
        [](std::span<const double> v) { return 1 / (v[0] + v[1] * v[3] + v[2] * v[3] * v[3]); },
        0.45 * last_digit);
    TextLine line(14, scene.mark);
    const auto number = [&](const char* key, int places) {
        line.handle(light_number(scene, explained.index, key, places), theme().text);
    };
    line.gap(14).together([&] {
        line.symbol(Quantity::Falloff).plain(" = 1/(");
        number("falloff/constant", decimals[0]);
    });
    line.together([&] {
        line.plain("+");
        number("falloff/linear", decimals[1]);
        line.symbol(Quantity::Distance);
    });
    line.together([&] {
        line.plain(" +");
        number("falloff/quadratic", decimals[2]);
        line.symbol(Quantity::Distance).plain("²),  ");
    });
    line.together([&] { distance_handle(line, scene, explained, decimals[3]); });
}

/// The numbers of "spot = (cos angle)^exponent within cutoff".
void cone_line(const HandledScene& scene, const ExplainedLight& explained) {
    const SpotCone& cone = scene.shown.lights[static_cast<std::size_t>(explained.index)].spot;
    const std::array<double, 2> values{explained.spot_angle_deg, cone.exponent};
    constexpr std::array least{1, 0};
    const double last_digit = last_digit_of(shown_number(explained.spot));
    const std::vector<int> decimals = decimals_for(
        values, least,
        [](std::span<const double> v) { return std::pow(std::cos(v[0] * std::numbers::pi / 180), v[1]); },
        explained.spot > 0 ? 0.45 * last_digit : 1);
    TextLine line(14, scene.mark);
    line.gap(14).together([&] {
        line.symbol(Quantity::Spot).plain(" = (cos ");
        line.number(decimal_text(values[0], decimals[0]) + "°", theme().text).plain(")");
        line.exponent(light_number(scene, explained.index, "spot/exponent", decimals[1]), theme().text);
    });
    NumberHandle cutoff = light_number(scene, explained.index, "spot/cutoff_deg", 1);
    cutoff.number.kind.format = "%.1f°";
    line.together([&] {
        line.plain(" within");
        line.handle(cutoff, theme().text);
        if (explained.spot == 0) line.plain(", else 0");
    });
}

/// The factor f, and the lines for falloff and spot.
void share_lines(const HandledScene& scene, const LightOfEquation& in) {
    const Light& light = scene.shown.lights[static_cast<std::size_t>(in.light.index)];
    const bool has_cone = light.kind == LightKind::Spot && light.spot.cutoff_deg <= 90;
    const bool falls_off = light.kind == LightKind::Point || light.kind == LightKind::Spot;
    draw_line(share_line(in), scene, 0);
    if (falls_off) falloff_line(scene, in.light);
    if (has_cone) cone_line(scene, in.light);
}

/// The samples of an area light, under a foldable heading.
void sample_rows(const ExplainedLight& area, const Light& light, int channel, QuantityMark* mark) {
    if (!fold(sample_words(area, light).c_str(), false)) return;
    const std::vector<double> weights = sample_weights(area);
    for (std::size_t i = 0; i < area.samples.size(); ++i) {
        const ExplainedLight& s = area.samples[i];
        TextLine line(14, mark);
        line.gap(14).plain(fmt::format("{}  ", i + 1)).symbol(Quantity::NL);
        line.number(shown_number(s.n_dot_l), s.n_dot_l > 0 ? theme().text : theme().warning).gap(6);
        line.symbol(Quantity::Form).number(decimal_text(s.falloff, 5), theme().text).gap(6);
        line.symbol(Quantity::Highlight).number(shown_number(s.specular_factor[channel]), theme().text);
        line.result(fmt::format("{:.1f} %", 100 * weights[i]), theme().dim_text);
    }
    small_dim("The mean weights each sample by its percentage of the total form factor.");
}

/// Draws the light's total in a channel and its share of the pixel, at the right end of its row, with a bar.
/// Returns the x coordinate at which this text begins.
float total_text(const Rect& row, float total, float share) {
    const std::string text = fmt::format("{} {:3.0f} %", shown_number(total), 100 * share);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::PushFont(fonts().figures);
    const float left = row.high.x - ImGui::CalcTextSize(text.c_str()).x;
    list.AddText({left, row.low.y}, to_u32(theme().text), text.c_str());
    ImGui::PopFont();
    const float bar = row.high.y + px(1);
    list.AddRectFilled({row.low.x, bar}, {row.high.x, bar + px(2)}, to_u32(theme().field));
    list.AddRectFilled({row.low.x, bar}, {row.low.x + share * row.size().x, bar + px(2)},
                       to_u32(theme().accent));
    list_control("light total", text, row);
    return left;
}

/// Draws the light's icon, name, total and share; true while hovered.
bool name_row(UiState& state, const Explanation& explanation, int index, glm::vec3 added) {
    const Light& light = explained_scene(state).lights[static_cast<std::size_t>(index)];
    ImGui::Dummy({0, px(3)});
    light_icon(light);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##light")) state.editor.selection = {Selection::Kind::Light, index};
    const bool pointed = is_pointed_at();
    const float indent = ImGui::CalcTextSize("      ").x, right = low.x + ImGui::GetContentRegionAvail().x;
    const Rect row{low, {right, low.y + ImGui::GetTextLineHeight()}};
    const float end = total_text(row, added[state.get<InspectorState>().channel],
                                 static_cast<float>(share_of_pixel(explanation, added)));
    cut_text(*ImGui::GetWindowDrawList(), {low.x + indent, low.y}, end - px(8), whole_label(light.name));
    tooltip("Light",
            is_read_only() ? "In the scene on the screen" : "Hover to see it alone, click to show its panel",
            "Right: what it adds to the pixel in this channel, and its share of R + G + B");
    ImGui::Dummy({0, px(1)});
    return pointed;
}

const char* name_of_term(Symbol term) {
    return term == Symbol::Ambient ? "ambient" : term == Symbol::Diffuse ? "diffuse" : "specular";
}

/// A term's line; while hovered, the picture shows this term of this light alone.
void light_term(UiState& state, const HandledScene& scene, const EquationLine& term, int light) {
    ImGui::PushID(static_cast<int>(term.term));
    ImGui::BeginGroup();
    draw_line(term, scene, state.get<InspectorState>().channel);
    ImGui::EndGroup();
    ImGui::PopID();
    const auto [low, high] = last_item();
    // Only over its letter and its result, because the numbers in between can be dragged.
    const bool ends =
        is_pointed_at({low, {low.x + px(14), high.y}}) || is_pointed_at({{high.x - px(52), low.y}, high});
    if (ends && term.left_out != switched_off) {
        const Symbol symbol = colour_of(term.term);
        show_instead(state, with_term_alone(with_light_alone(scene.shown, light), symbol),
                     fmt::format("{} of {} alone", name_of_term(symbol),
                                 scene.shown.lights[static_cast<std::size_t>(light)].name));
    }
}

}  // namespace

void light_card(UiState& state, const Explanation& explanation, const ExplainedPoint& point,
                std::size_t which, glm::vec3 added) {
    const ExplainedLight& explained = point.lights[which];
    const Scene& scene = explained_scene(state);
    const auto index = static_cast<std::size_t>(explained.index);
    if (index >= scene.lights.size()) return;
    const Light& light = scene.lights[index];
    const auto& marked = state.get<InspectorState>().marked;
    const bool is_marked = marked && marked->light == explained.index;
    QuantityMark mark{is_marked ? std::optional(marked->quantity) : std::nullopt,
                      is_marked && ImGui::GetTime() < marked->scrolls_until};
    const HandledScene handled{scene, editable_scene(state), &mark};
    ImGui::PushID(explained.index);
    ImGui::BeginGroup();
    if (name_row(state, explanation, explained.index, added))
        show_instead(state, with_light_alone(scene, explained.index), light.name + " alone");
    const LightOfEquation in{scene, explanation, explained};
    const bool is_area = light.kind == LightKind::Area;
    if (!is_area) angles(state, explanation, point, explained, &mark);  // each sample has its own angles
    share_lines(handled, in);
    for (const EquationLine& term : light_lines(in)) light_term(state, handled, term, explained.index);
    if (is_area) sample_rows(explained, light, state.get<InspectorState>().channel, &mark);
    if (const std::string reason = dark_reason(explained, light); !reason.empty()) warning_text(reason);
    if (const std::string words = blocked_words(state, explanation, which); !words.empty())
        wrapped_dim(words);
    ImGui::EndGroup();
    if (is_pointed_at(last_item())) state.get<InspectorState>().pointed_light = explained.index;
    ImGui::PopID();
}

}  // namespace glint
