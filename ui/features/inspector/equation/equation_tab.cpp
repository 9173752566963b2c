#include "ui/features/inspector/equation/equation_tab.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vector_relational.hpp>
#include <map>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include "models/scene/reflection.h"
#include "models/scene/scene.h"
#include "renderer/explain/equation_text.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

char corner_letter(int corner) { return static_cast<char>('A' + corner % 26); }

/// Buttons for the corners, with their weights, which sum to 1.
void corner_buttons(InspectorState& state, const Explanation& explanation) {
    for (int i = 0; i < static_cast<int>(explanation.corners.size()); ++i) {
        const ExplainedCorner& corner = explanation.corners[static_cast<std::size_t>(i)];
        const std::string label = fmt::format("{} {:.2f}", corner_letter(i), corner.weight);
        if (i % 4 != 0) ImGui::SameLine(0, px(4));
        ImGui::PushFont(fonts().figures);
        if (chosen_button(label.c_str(), i == state.corner)) state.corner = i;
        ImGui::PopFont();
        tooltip("Corner", "This corner's share of the pixel; click to show its numbers");
    }
}

/// Names the corner to which the following numbers belong.
void lit_at(InspectorState& state, const Explanation& explanation, const Shading& shading) {
    if (!explanation.lit_per_corner || explanation.corners.empty()) return;
    if (explanation.corners.size() == 1)
        return wrapped_dim(flat_at_provoking_corner(shading)
                               ? "Lit once for the whole triangle, at its provoking corner:"
                               : "Lit once for the whole polygon, at its centroid:");
    state.corner = std::clamp(state.corner, 0, static_cast<int>(explanation.corners.size()) - 1);
    wrapped_dim(
        fmt::format("The corners' colours are mixed with {} weights. A light's total and share are for the "
                    "pixel; its lines are for corner {}:",
                    choice_of(explanation.interpolation).word, corner_letter(state.corner)));
    corner_buttons(state, explanation);
}

/// The pixel under each method of weighting the corners: hovering previews a method, a click applies it.
void interpolations(UiState& state, const Explanation& explanation) {
    for (const ExplainedInterpolation& each : explanation.interpolations) {
        const Choice choice = choice_of(each.interpolation);
        const bool is_chosen = each.interpolation == explanation.interpolation;
        ImGui::PushID(choice.label);
        if (ImGui::Selectable(choice.label, is_chosen, 0, {px(92), 0}))
            if (Scene* scene = editable_scene(state)) scene->shading.interpolation = each.interpolation;
        const bool pointed = is_pointed_at();
        tooltip(choice.label, choice.meaning, "Hover to preview, click to apply", "/shading/interpolation");
        ImGui::SameLine(0, px(6));
        mono_text(shown_vector(each.sum));
        ImGui::PopID();
        if (!pointed || is_chosen) continue;
        Scene other = explained_scene(state);
        other.shading.interpolation = each.interpolation;
        show_instead(state, other, fmt::format("{} weights", choice.label));
    }
}

/// Shows whether a highlight between the corners is lost here, or the corners are dense enough to preserve
/// it.
void against_phong(const UiState& state, const Explanation& explanation) {
    if (!explanation.lit_per_corner) return;
    const std::optional<Explanation> phong = under_phong(state, explanation);
    if (!phong) return;
    // Does not compare the bytes: clipped values are equal even if something is lost.
    if (shown_vector(phong->sum) == shown_vector(explanation.sum))
        return wrapped_dim("Phong shading gives the same colour here: nothing is lost between the corners.");
    const glm::vec3 lost = phong->sum - explanation.sum;
    const auto row = [](const char* label, const char* what, glm::vec3 value) {
        const float left = ImGui::GetCursorPosX();
        dim_text(label);
        tooltip(label, what);
        ImGui::SameLine(left + px(98));
        mono_text(shown_vector(value));
    };
    row("Phong", "The pixel lit at its own point, not at the corners", phong->sum);
    if (glm::all(glm::greaterThanEqual(lost, glm::vec3(0))))
        row("lost", "Light between the corners that none of their colours contains", lost);
    else if (glm::all(glm::lessThanEqual(lost, glm::vec3(0))))
        row("too much", "Light at the corners that does not reach this point", -lost);
    else
        row("differs", "This colour minus Phong's; negative values are lost between the corners", -lost);
}

/// The tone, which replaces emission, ambient and diffuse under cool-to-warm shading.
void tone_line(const ExplainedTone& tone, int channel, QuantityMark* mark) {
    TextLine line(14, mark);
    line.symbol(Quantity::WarmShare).plain(" = (1 + ").symbol(Quantity::NL).plain(")/2 = ");
    line.number(shown_number(tone.k_w), theme().text);
    TextLine mix(14, mark);
    mix.gap(14).symbol(Quantity::Warm).number(shown_number(tone.warm[channel]), theme().text);
    mix.times().symbol(Quantity::WarmShare).plain(" + ").symbol(Quantity::Cool);
    mix.number(shown_number(tone.cool[channel]), theme().text);
    mix.times().plain("(1 − ").symbol(Quantity::WarmShare).plain(")");
    mix.result(shown_number(tone.color[channel]), theme().text);
}

void unlit(UiState& state, const Explanation& explanation, const ExplainedPoint& point) {
    const int channel = state.get<InspectorState>().channel;
    const auto& marked = state.get<InspectorState>().marked;
    const bool is_marked = marked && marked->light < 0;
    QuantityMark mark{is_marked ? std::optional(marked->quantity) : std::nullopt};
    if (point.cool_to_warm.used) return tone_line(point.cool_to_warm, channel, &mark);
    for (const EquationLine& line : unlit_lines(explained_scene(state), explanation, point)) {
        ImGui::PushID(static_cast<int>(line.term));
        draw_line(line, {explained_scene(state), editable_scene(state), &mark}, channel);
        ImGui::PopID();
    }
}

void light_cards(UiState& state, const Explanation& explanation, const ExplainedPoint& point) {
    const auto& lights = point.lights;
    InspectorState& inspector = state.get<InspectorState>();
    if (lights.size() > 1) {
        const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
        const float width = ImGui::CalcTextSize("Largest share first").x + 2 * small_padding().x;
        if (!point.bounces.used) same_line_if_fits(width, px(8), right);  // next to "Show the ray"
        if (small_chosen_button("Largest share first", inspector.sorts_lights))
            inspector.sorts_lights ^= true;
        tooltip("Largest share first",
                "Sorts the lights by how much they add; otherwise in the scene's order");
    }
    std::vector<std::size_t> order(lights.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::map<int, glm::vec3> added = added_to_pixel(explanation);
    const auto adds = [&](std::size_t i) { return share_of_pixel(explanation, added[lights[i].index]); };
    if (inspector.sorts_lights)
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return adds(a) > adds(b); });
    const auto wanted = std::find_if(order.begin(), order.end(), [&](std::size_t i) {
        return inspector.marked && inspector.marked->light == lights[i].index;
    });
    inspector.cards.draw(
        static_cast<int>(lights.size()),
        [&](int i) {
            const std::size_t which = order[static_cast<std::size_t>(i)];
            light_card(state, explanation, point, which, added[lights[which].index]);
        },
        static_cast<int>(wanted - order.begin()));
}

void mistakes_note(const Scene& scene) {
    if (const std::string on = mistakes_text(scene.shading.mistakes); !on.empty())
        warning_text(on + ". A term can differ from the product of its factors.");
}

std::string section_title(const InspectorState& state, const Explanation& explanation) {
    constexpr std::array channels{"red", "green", "blue"};
    return fmt::format("In {}, under {} shading", channels[static_cast<std::size_t>(state.channel)],
                       choice_of(explanation.mode).label);
}

/// Drops the mark after a few seconds.
void forget_old_mark(InspectorState& inspector) {
    if (!inspector.marked) return;
    const double rest = inspector.marked->until - ImGui::GetTime();
    if (rest <= 0)
        inspector.marked.reset();
    else
        redraw_within(rest);
}

constexpr std::array formats{
    CopyFormat{CopyAs::Text, "text", "As `glint explain FILE --pixel X,Y` prints it"},
    CopyFormat{CopyAs::Json, "JSON",
               "As `glint explain … --format json` prints it; docs/explain.md describes its keys"},
    CopyFormat{CopyAs::Latex, "LaTeX", "As `glint explain … --format latex` prints it, for amsmath"}};

void copy_buttons(const UiState& state) {
    section_heading("Copy this explanation as");
    ImGui::PushFont(fonts().small);
    for (const CopyFormat& format : formats) {
        if (&format != &formats.front()) ImGui::SameLine();
        if (ImGui::Button(format.label)) copy_explanation(state, format);
        tooltip(format.label, format.what);
    }
    ImGui::PopFont();
}

}  // namespace

std::string explained_as(CopyAs format, const Explanation& explanation, const Scene& scene) {
    switch (format) {
    case CopyAs::Text:
        return explain_text(explanation, scene);
    case CopyAs::Json:
        return explain_json(explanation);
    case CopyAs::Latex:
        return explain_latex(explanation, scene);
    }
    return {};  // not reached
}

std::span<const CopyFormat> copy_formats() { return formats; }

void copy_explanation(const UiState& state, const CopyFormat& format) {
    const Explanation& explanation = *state.on_screen.explanation;
    ImGui::SetClipboardText(explained_as(format.as, explanation, explained_scene(state)).c_str());
    say(fmt::format("The explanation of pixel {}, {} is on the clipboard as {}", explanation.x, explanation.y,
                    format.label));
}

void equation_tab(UiState& state, const PictureView&) {
    if (!state.on_screen.explanation)
        return inspector_empty_state(
            "Click a pixel to see its lighting equation with its numbers: what each light adds, and why a "
            "light adds nothing.");
    const Explanation& explanation = *state.on_screen.explanation;
    forget_old_mark(state.get<InspectorState>());
    if (!explanation.hit)
        return wrapped_dim("No object is visible here: the pixel has the background's colour.");
    if (static_cast<std::size_t>(explanation.object_index) >= explained_scene(state).objects.size()) return;
    const bool is_local = explained_scene(state).transport.model == TransportModel::Local;
    // In a comparison the scene's own model may differ from that of the picked part.
    formula(explanation.reflection, asked_point(state.get<InspectorState>(), explanation).bounces.used
                                        ? TransportModel::Bounces
                                    : is_local ? TransportModel::Local
                                               : TransportModel::Shadows);
    if (explanation.material.reflection != OwnReflection::Scene)
        wrapped_dim(
            fmt::format("The object's own reflection model: {}", choice_of(explanation.reflection).label));
    if (!is_plain_front(explanation)) warning_text("The surface is seen from its " + side_words(explanation));
    sum_table(state, explanation);
    display_lines(state, explanation);
    my_pixel(state);
    if (explanation.reflection != Reflection::None) {
        section_heading(section_title(state.get<InspectorState>(), explanation).c_str());
        mistakes_note(explained_scene(state));
        lit_at(state.get<InspectorState>(), explanation, explained_scene(state).shading);
        interpolations(state, explanation);
        against_phong(state, explanation);
        const ExplainedPoint& point = asked_point(state.get<InspectorState>(), explanation);
        unlit(state, explanation, point);
        traced_controls(state, point);
        light_cards(state, explanation, point);
        if (point.lights.empty()) wrapped_dim("No light is on: only ambient and emission are left.");
    }
    copy_buttons(state);
}

namespace {

/// Formats a number for use in a program: without surrounding spaces, and with an ASCII minus.
std::string plain(std::string_view number) {
    constexpr std::string_view minus = "−";
    std::string text;
    while (!number.empty()) {
        const bool is_minus = number.starts_with(minus);
        if (is_minus || number.front() != ' ' || !text.empty()) text += is_minus ? '-' : number.front();
        number.remove_prefix(is_minus ? minus.size() : 1);
    }
    return text;
}

void copy_item(const char* label, const std::string& text) {
    if (ImGui::MenuItem(label)) {
        ImGui::SetClipboardText(text.c_str());
        say(text + " is on the clipboard");
    }
    list_control(label, "", last_item());
}

}  // namespace

void copy_menu(int id, const std::string& number, const std::string& line) {
    ImGui::PushID(id);
    tooltip("Right-click to copy", line.empty() ? "" : "The number alone, or its entire line");
    if (ImGui::BeginPopupContextItem("##copy")) {
        copy_item("Copy", plain(number));
        if (!line.empty()) copy_item("Copy line", line);
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

// Finds objects that block the line from the picked point to a light. The local model ignores them.

namespace {

/// Whether the object only marks a light's position, with the light at its centre.
bool marks(const Object& object, glm::vec3 light) {
    const Bounds& box = object.mesh->bounds;
    const glm::vec3 middle =
        glm::vec3(world_from_object(object.transform) * glm::vec4((box.min + box.max) / 2.0f, 1));
    const float size = glm::length(object.transform.scale * (box.max - box.min));
    return glm::distance(middle, light) < 0.1f * size;
}

}  // namespace

std::string blocked_words(const UiState& state, const Explanation& explanation, std::size_t which) {
    const Scene& scene = explained_scene(state);
    const std::vector<TracedLight>& rays = state.get<InspectorState>().rays;
    // Under the other models, the light's own line names the object that casts the shadow.
    if (scene.transport.model != TransportModel::Local || which >= rays.size()) return "";
    const TracedLight& ray = rays[which];
    const auto blocker = static_cast<std::size_t>(ray.object);  // -1 becomes the largest value
    if (!ray.in_front || blocker >= scene.objects.size() || marks(scene.objects[blocker], ray.to)) return "";
    const std::string name = ray.object == explanation.object_index
                                 ? "The object itself"
                                 : fmt::format("“{}”", scene.objects[blocker].name);
    return fmt::format(
        "{} is between this light and the point, but the local model lights each point on its own.", name);
}

namespace {

/// The width of a column; smaller if the names would not fit otherwise.
float channel_width() { return std::min(px(58), (ImGui::GetContentRegionAvail().x - px(100)) / 3); }
constexpr std::array channel_names{"red", "green", "blue"};

/// The headings "red green blue" of the columns; a click chooses the channel.
void header_row(InspectorState& inspector) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(fonts().small);
    dim_text("I =");
    for (int c = 0; c < 3; ++c) {
        ImGui::TableNextColumn();
        const char* name = channel_names[static_cast<std::size_t>(c)];
        ImGui::PushStyleColor(ImGuiCol_Text, c == inspector.channel ? theme().text : theme().dim_text);
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + px(8));
        if (ImGui::Selectable(name, false, 0, {ImGui::GetContentRegionAvail().x - px(4), 0}))
            inspector.channel = c;
        ImGui::PopStyleColor();
        const auto [low, high] = last_item();
        if (c == inspector.channel)
            ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - px(1.5f)}, high,
                                                      to_u32(theme().accent));
        tooltip(name, "Click to write out the products below in this channel");
    }
    ImGui::PopFont();
}

/// Draws the numbers of a row, which can be copied one at a time or all three together.
void cells(const char* row, glm::vec3 value, const ImVec4& colour) {
    ImGui::PushID(row);
    for (int c = 0; c < 3; ++c) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, colour);
        mono_text(shown_number(value[c]));
        ImGui::PopStyleColor();
        copy_menu(c, shown_number(value[c]), shown_vector(value));
    }
    ImGui::PopID();
}

void term_row(UiState& state, Symbol symbol, const char* name, glm::vec3 value, bool on) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    coloured(symbol, name);
    if (!on) {
        ImGui::SameLine(0, px(5));
        dim_text("off");
    }
    cells(name, value, value == glm::vec3(0) ? theme().disabled_text : theme()[symbol]);
    const Rect row{low, {ImGui::GetItemRectMax().x, low.y + ImGui::GetTextLineHeight()}};
    list_control(name, "", row);
    if (!on || !is_pointed_at(row)) return;
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, to_u32(theme().field));
    show_instead(state, with_term_alone(explained_scene(state), symbol), fmt::format("{} alone", name + 3));
}

void sum_row(glm::vec3 sum) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted("sum");
    const ImVec2 at = ImGui::GetItemRectMin() - ImVec2(0, px(1));
    cells("sum", sum, theme().text);
    ImGui::GetWindowDrawList()->AddLine(at, {ImGui::GetItemRectMax().x, at.y}, to_u32(theme().dim_text));
}

}  // namespace

void sum_table(UiState& state, const Explanation& explanation) {
    const TermSums sums = term_sums(explanation);
    const Terms& on = explained_scene(state).shading.terms;
    const float width = channel_width();
    if (!ImGui::BeginTable("##sum", 4, ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const char* channel : channel_names)
        ImGui::TableSetupColumn(channel, ImGuiTableColumnFlags_WidthFixed, width);
    header_row(state.get<InspectorState>());
    if (explained_scene(state).npr.cool_to_warm) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted("tone, for e + a + d");
        cells("tone", sums.tone, theme().text);
    } else {
        term_row(state, Symbol::Emission, "e  emission", sums.emission, on.emission);
        term_row(state, Symbol::Ambient, "a  ambient", sums.ambient, on.ambient);
        term_row(state, Symbol::Diffuse, "d  diffuse", sums.diffuse, on.diffuse);
    }
    // In a comparison the scene's own model may differ from that of the picked part.
    if (explained_scene(state).transport.model == TransportModel::Bounces || sums.bounced != glm::vec3(0))
        term_row(state, Symbol::Ambient, "b  bounced", sums.bounced, on.ambient);
    term_row(state, Symbol::Specular, "s  specular", sums.specular, on.specular);
    sum_row(explanation.stroke.coverage > 0 ? explanation.stroke.shaded : explanation.sum);
    ImGui::EndTable();
}

void display_lines(const UiState& state, const Explanation& explanation) {
    const Display& display = explained_scene(state).display;
    if (explanation.stroke.coverage > 0)
        small_dim(fmt::format("a stroke covers {:.0f} % of the pixel → {}", 100 * explanation.stroke.coverage,
                              shown_vector(explanation.sum)));
    std::string steps;
    if (display.exposure != 1) steps += fmt::format("× exposure {:.3g}  ", display.exposure);
    if (display.transfer == Transfer::Srgb) steps += "→ sRGB  ";
    const auto [r, g, b] = explanation.byte;
    if (!steps.empty()) small_dim(fmt::format("{}→ {} {} {}", steps, r, g, b));
    if (const std::string clipped = clipping_reason(explanation.sum, display.exposure); !clipped.empty()) {
        ImGui::PushFont(fonts().small);
        warning_text(clipped);
        ImGui::PopFont();
    }
}

}  // namespace glint
