// A card for each light: its part of the equation at the picked point.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/inspect/debug_views/blocker.h"
#include "ui/fields/field_panel.h"
#include "ui/inspector/equation/equation_tab.h"
#include "ui/inspector/equation/factors.h"
#include "ui/inspector/equation/text_line.h"
#include "ui/inspector/equation/words.h"
#include "ui/inspector/inspector.h"
#include "ui/ui.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// "n·l 0.713 44.5°": a cosine with its angle. Pointing at it lights up the arrow `to` in the picture.
void angle(TextLine& line, UiState& state, Symbol to, Symbol from, float cosine) {
    line.dot(from, to);
    const ImVec2 low = last_item().low - ImVec2(px(14), 0);
    line.gap(4).number(fmt::format("{} {:5.1f}°", shown_number(cosine), angle_deg(cosine)), theme().text);
    const Rect area{low, last_item().high};
    line.gap(8);
    list_control(to == Symbol::H ? "n·h" : to == Symbol::R ? "r·v" : "n·l", "", area);
    if (is_pointed_at(area)) state.inspector.pointed_vector = to;
}

void angles(UiState& state, const Explanation& explanation, const ExplainedLight& light) {
    TextLine line(0);
    angle(line, state, Symbol::L, Symbol::N, light.n_dot_l);
    if (explanation.reflection == Reflection::Phong) angle(line, state, Symbol::R, Symbol::V, light.r_dot_v);
    if (explanation.reflection == Reflection::BlinnPhong)
        angle(line, state, Symbol::H, Symbol::N, light.n_dot_h);
}

/// "F = intensity × falloff × spot", with what falloff and spot are made of.
bool share_lines(UiState& state, const ExplainedLight& explained) {
    Scene& scene = state.editor.scene();
    const int index = explained.index;
    const Light& light = scene.lights[static_cast<std::size_t>(index)];
    const bool falls_off = light.kind == LightKind::Point || light.kind == LightKind::Spot;
    const bool cone = light.kind == LightKind::Spot && light.spot.cutoff_deg <= 90;
    const auto number = [&](const char* key, const char* format) {
        NumberHandle handle = number_handle(scene, fmt::format("/lights/{}/{}", index, key));
        handle.number.kind.format = format;
        return handle;
    };
    bool edited = false;
    TextLine line;
    line.plain("F = I");
    edited |= line.handle(number("intensity", "%.2f"), theme().text);
    if (falls_off) line.times().plain("falloff").number(shown_number(explained.falloff), theme().text);
    if (cone) line.times().plain("spot").number(shown_number(explained.spot), theme().text);
    if (light.kind != LightKind::Area) line.result(shown_number(share_of(explained, light)), theme().text);
    if (falls_off) {
        TextLine below;
        below.gap(14).plain("falloff 1/(");
        edited |= below.handle(number("falloff/constant", "%.2f"), theme().text);
        below.plain("+");
        edited |= below.handle(number("falloff/linear", "%.2f"), theme().text);
        below.plain("r +");
        edited |= below.handle(number("falloff/quadratic", "%.2f"), theme().text);
        below.plain("r²),  r").number(fmt::format(" {:.2f}", explained.distance), theme().text);
    }
    if (cone) {
        TextLine below;
        below.gap(14)
            .plain("spot (cos ")
            .number(fmt::format("{:.1f}°", explained.spot_angle_deg), theme().text);
        below.plain(")");
        edited |= below.exponent(number("spot/exponent", "%.3g"), theme().text);
        below.plain(" within");
        edited |= below.handle(number("spot/cutoff_deg", "%.1f°"), theme().text);
    }
    return edited;
}

/// The light's icon and name; true while pointed at.
bool name_row(UiState& state, const ExplainedLight& explained, const Light& light) {
    ImGui::Dummy({0, px(3)});
    light_icon(light);
    if (ImGui::Selectable(fmt::format("      {}", light.name).c_str()))
        state.editor.selection = {Selection::Kind::Light, explained.index};
    const bool pointed = is_pointed_at();
    tooltip("Light", "Rest here: this light alone. Click: its panel");
    return pointed;
}

const char* name_of_term(Symbol term) {
    return term == Symbol::Ambient ? "ambient" : term == Symbol::Diffuse ? "diffuse" : "specular";
}

/// A term's line; pointed at, the picture shows this term of this light alone.
bool light_term(UiState& state, const TermLine& term, int light) {
    const Scene& scene = state.editor.scene();
    ImGui::PushID(term.letter);
    ImGui::BeginGroup();
    const bool edited = draw_term_line(term);
    ImGui::EndGroup();
    ImGui::PopID();
    const auto [low, high] = last_item();
    // Only its letter and its result: the numbers in between can be dragged themselves.
    const bool ends =
        is_pointed_at({low, {low.x + px(14), high.y}}) || is_pointed_at({{high.x - px(52), low.y}, high});
    if (ends && term.on)
        show_instead(state, with_term_alone(with_light_alone(scene, light), term.symbol),
                     fmt::format("{} of {} alone", name_of_term(term.symbol),
                                 scene.lights[static_cast<std::size_t>(light)].name));
    return edited;
}

void factor(TextLine& line, const Factor& f, bool& edited) {
    const ImVec4& colour = f.dot ? theme().text : theme()[f.symbol];
    if (f.dot) line.dot(f.dot->first, f.dot->second);
    if (*f.letter != 0) line.symbol(f.symbol, f.letter, f.index);
    if (f.number) {
        edited |= line.handle(*f.number, colour);
    } else if (f.clamped_from < 0) {
        line.number(fmt::format(" {} → 0", shown_number(f.clamped_from)), theme().warning);
    } else if (*f.letter != 'F') {  // F has its own line
        line.number(shown_number(f.value), colour);
    }
    if (f.exponent) edited |= line.exponent(*f.exponent, theme()[Symbol::Specular]);
}

/// Triangles times lights that are asked within a millisecond or two.
constexpr std::size_t at_once = 250'000;

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Object& object : scene.objects) count += object.mesh ? object.mesh->triangles.size() : 0;
    return count;
}

/// The object between the point and the light, or -1.
int blocker_index(const Scene& scene, const ExplainedPoint& point, const ExplainedLight& light) {
    const bool area = scene.lights[static_cast<std::size_t>(light.index)].kind == LightKind::Area;
    // The middle sample of an area light speaks for all: a point light in the middle of the panel.
    const ExplainedLight& asked =
        area && !light.samples.empty() ? light.samples[light.samples.size() / 2] : light;
    if (!(asked.n_dot_l > 0)) return -1;
    return blocker(scene, point.point.world, asked.l.world, double(asked.distance)).value_or(-1);
}

/// Per light of the point.
std::vector<int> blocker_indices(const Scene& scene, const ExplainedPoint& point) {
    std::vector<int> all;
    for (const ExplainedLight& light : point.lights) all.push_back(blocker_index(scene, point, light));
    return all;
}

}  // namespace

bool draw_term_line(const TermLine& term) {
    bool edited = false;
    TextLine line(28);
    line.symbol(term.symbol, term.letter).gap(4).plain("=").gap(4);
    for (std::size_t i = 0; i < term.factors.size(); ++i) {
        if (i > 0) line.times();
        factor(line, term.factors[i], edited);
    }
    if (!term.on) line.plain("  switched off", theme().warning);
    line.result(shown_number(term.result), term.result == 0 ? theme().disabled_text : theme()[term.symbol]);
    return edited;
}

std::string blocked_words(UiState& state, const Explanation& explanation, const ExplainedPoint& point,
                          std::size_t which) {
    const Scene& scene = state.editor.scene();
    const BlockedKey key{state.picture_serial, {explanation.x, explanation.y}, state.inspector.corner};
    auto& blocked = state.inspector.blocked;
    const bool slow = triangle_count(scene) * point.lights.size() > at_once;
    if (slow && ImGui::IsAnyMouseDown() && !blocked.is_of(key)) return "";
    const std::vector<int>& by = blocked.of(key, [&] { return blocker_indices(scene, point); });
    if (which >= by.size() || by[which] < 0) return "";
    const auto object = static_cast<std::size_t>(by[which]);
    if (object >= scene.objects.size()) return "";
    const std::string name = by[which] == explanation.object_index
                                 ? "Its own surface"
                                 : fmt::format("“{}”", scene.objects[object].name);
    return fmt::format(
        "{} stands in the way of this light, but Glint casts no shadows: each point is lit for itself", name);
}

void light_card(UiState& state, const Explanation& explanation, const ExplainedPoint& point,
                std::size_t which) {
    const ExplainedLight& explained = point.lights[which];
    Scene& scene = state.editor.scene();
    const auto index = static_cast<std::size_t>(explained.index);
    if (index >= scene.lights.size()) return;
    const Light before = scene.lights[index];
    bool edited = false;
    ImGui::PushID(explained.index);
    ImGui::BeginGroup();
    if (name_row(state, explained, before))
        show_instead(state, with_light_alone(scene, explained.index), before.name + " alone");
    if (before.kind == LightKind::Area)
        small_dim(sample_words(explained));  // each has angles of its own
    else
        angles(state, explanation, explained);
    edited |= share_lines(state, explained);
    for (const TermLine& term : term_lines({scene, explanation, explained, state.inspector.channel}))
        edited |= light_term(state, term, explained.index);
    if (const std::string reason = dark_reason(explained, before); !reason.empty()) warning_text(reason);
    if (const std::string words = blocked_words(state, explanation, point, which); !words.empty())
        wrapped_dim(words);
    ImGui::EndGroup();
    if (is_pointed_at(last_item())) state.inspector.pointed_light = explained.index;
    ImGui::PopID();
    if (edited) keep_valid(scene.lights[index], before);
}

}  // namespace glint
