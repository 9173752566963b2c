#include "ui/features/lessons/lesson_parts.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "renderer/explain/quantity.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/plots/plot.h"
#include "ui/widgets/area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

using Points = std::vector<glm::dvec2>;

std::array<float, 3> channels_of(const Json& colour) {
    std::array<float, 3> channels{0.5f, 0.5f, 0.5f};
    const Json::array_t& list = elements_of(colour);
    for (std::size_t i = 0; i < std::min<std::size_t>(list.size(), 3); ++i)
        channels[i] = std::clamp(static_cast<float>(list[i].get<double>()), 0.0f, 1.0f);
    return channels;
}

/// The drawn values of a sketch; NaN where nothing has been drawn, which draw_curve() leaves out.
Points points_of(const Json& values) {
    Points points;
    const Json::array_t& list = elements_of(values);
    for (std::size_t i = 0; i < list.size(); ++i)
        points.emplace_back(static_cast<double>(i), list[i].is_number()
                                                        ? list[i].get<double>()
                                                        : std::numeric_limits<double>::quiet_NaN());
    return points;
}

/// The upper end of the plot: high enough for the values of any unclipped picture, and for the right values
/// once they are revealed.
double top_of(const Json* right) {
    double top = 1;
    if (right != nullptr)
        for (const Json& v : elements_of(*right)) top = std::max(top, v.get<double>());
    return 1.08 * top;
}

void draw_with_hand(LessonState& lesson, const Prediction& question, const PlotArea& area) {
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) return lesson.sketched.reset();
    const ImVec2 hand = ImGui::GetIO().MousePos;
    glm::dvec2 at = area.value(hand);
    at.y = std::clamp(at.y, area.y.low, area.y.high);  // keep the drawn curve visible
    // A stroke that comes this close to an end of the line is extended to that end.
    const float near_an_end = px(10);
    if (hand.x < area.rect.low.x + near_an_end) at.x = area.x.low;
    if (hand.x > area.rect.high.x - near_an_end) at.x = area.x.high;
    sketch(lesson.chosen, sketch_length(question), lesson.sketched.value_or(at), at);
    lesson.sketched = at;
}

struct OptionColours {
    ImVec4 ground, rim, ink;
};

OptionColours colours_of(OptionLook look, bool hovered) {
    const Theme& t = theme();
    switch (look) {
    case OptionLook::Open:
        return {hovered ? t.field_hovered : t.field, t.line, t.text};
    case OptionLook::Taken:
        return {t.field_active, t.accent, t.text};
    case OptionLook::Right:
    case OptionLook::TakenRight:
        return {t.field, t.accent, t.text};
    case OptionLook::TakenWrong:
        return {t.field, t.warning, t.text};
    case OptionLook::Other:
        return {t.panel, t.line, t.dim_text};
    }
    return {};
}

/// Draws a ring around the option's key, filled if chosen; the right option has a tick.
void option_mark(ImDrawList& list, ImVec2 middle, OptionLook look, const OptionColours& colours,
                 const std::string& letter) {
    const float radius = px(8);
    const ImU32 ink = to_u32(colours.rim);
    list.AddCircle(middle, radius, look == OptionLook::Open ? to_u32(theme().dim_text) : ink, 0, px(1.5f));
    const bool taken =
        look == OptionLook::Taken || look == OptionLook::TakenRight || look == OptionLook::TakenWrong;
    if (taken) list.AddCircleFilled(middle, radius - px(2.5f), ink);
    if (look != OptionLook::Right && look != OptionLook::TakenRight) {
        ImGui::PushFont(fonts().small);
        const ImVec2 low = middle - 0.5f * ImGui::CalcTextSize(letter.c_str());
        list.AddText(low, to_u32(taken ? theme().panel : theme().dim_text), letter.c_str());
        ImGui::PopFont();
        return;
    }
    const ImVec2 foot = middle + ImVec2(px(-1), px(4));
    const ImU32 tick = to_u32(taken ? theme().panel : colours.rim);
    list.AddLine(foot - ImVec2(px(3), px(3)), foot, tick, px(2));
    list.AddLine(foot, foot + ImVec2(px(5), px(-8)), tick, px(2));
}

}  // namespace

std::string letter_of_option(std::size_t index) {
    return std::string(1, static_cast<char>('A' + index % 26));
}

std::optional<std::size_t> option_of_key(KeyPress press, std::size_t options) {
    const auto index = static_cast<std::size_t>(press.key);  // Key::A is 0
    return press.is_alone() && index < options ? std::optional(index) : std::nullopt;
}

std::string answer_text(double value, const std::string& unit) {
    const double rounded = std::abs(value) < 5e-5 ? 0 : value;
    return fmt::format("{:.4g}{}{}", rounded, unit.empty() || unit == "%" ? "" : " ", unit);
}

bool main_button(const char* label, float width) { return chosen_button(label, true, width); }

bool option_card(const std::string& letter, const std::string& text, OptionLook look) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, pad = px(7), left = px(30);
    const float room = std::max(width - left - pad, px(40));
    const float high = prose_height(text, room) + 2 * pad;
    ImGui::PushID(letter.c_str());
    const bool clicked = hit_area("##option", {width, high});
    ImGui::PopID();
    const bool can = look == OptionLook::Open || look == OptionLook::Taken;
    const bool hovered = can && ImGui::IsItemHovered();
    if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    list_control(text.c_str(), letter, last_item());
    const OptionColours colours = colours_of(look, hovered);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = low + ImVec2(width, high);
    list.AddRectFilled(low, end, to_u32(colours.ground), px(5));
    list.AddRect(low, end, to_u32(colours.rim), px(5), 0, px(look == OptionLook::Open ? 1 : 1.5f));
    option_mark(list, low + ImVec2(px(16), high / 2), look, colours, letter);
    prose_at(list, low + ImVec2(left, pad), room, text, colours.ink);
    return clicked && can;
}

void colour_row(const char* word, const Json& colour) {
    const std::array<float, 3> c = channels_of(colour);
    const ImVec2 low = ImGui::GetCursorScreenPos(), size = px(1) * ImVec2(64, 34);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, low + size, to_u32({c[0], c[1], c[2], 1}), px(4));
    list.AddRect(low, low + size, to_u32(theme().line), px(4));
    ImGui::Dummy(size);
    ImGui::SameLine(0, px(10));
    ImGui::BeginGroup();
    small_dim(word);
    const auto byte = [&c](std::size_t i) { return static_cast<int>(std::lround(255 * c[i])); };
    mono_text(fmt::format("{:3} {:3} {:3}", byte(0), byte(1), byte(2)));
    ImGui::EndGroup();
    list_control(word, "", last_item());
}

bool pick_colour(const char* id, Json& colour) {
    std::array<float, 3> c = channels_of(colour);
    ImGui::SetNextItemWidth(std::min(ImGui::GetContentRegionAvail().x, px(230)));
    const bool touched =
        ImGui::ColorPicker3(id, c.data(),
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                                ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_NoLabel);
    list_control("Colour to predict", "", last_item());
    for (float& channel : c) channel = std::clamp(channel, 0.0f, 1.0f);  // larger values can be typed
    if (touched) colour = Json(c);
    return touched;
}

void sketch_plot(LessonState& lesson, const Prediction& question, const Json& mine, const Json* right) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, px(190)};
    (void)hit_area("##sketch", size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Interval x{0, static_cast<double>(sketch_length(question)) - 1}, y{0, top_of(right)};
    const AxisText x_text{"from A to B", "pixels"}, y_text{"intensity", ""};
    const PlotArea area = draw_axes(list, {low, low + size}, x, y, x_text, y_text);
    list_control("Sketch", "", area.rect);
    if (right == nullptr) {
        if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        draw_with_hand(lesson, question, area);
    } else {
        draw_curve(list, area, points_of(*right), theme().accent, 2);
    }
    const Points drawn = points_of(mine);
    if (!drawn.empty()) draw_curve(list, area, drawn, theme().warning, 2);
}

namespace {

constexpr std::string_view times_sign = "·";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The quantity that this sequence of letters denotes, including an index if it has one.
std::optional<Quantity> quantity_of(std::string_view run, bool beside_dot) {
    for (const QuantityRow& row : quantity_rows) {
        const bool is_vector = row.quantity >= Quantity::N && row.quantity <= Quantity::H;
        if (text_of(row.quantity) == run && (*row.index != 0 || (is_vector && beside_dot)))
            return row.quantity;
    }
    return {};
}

/// Arranges words in lines.
class Flow {
  public:
    Flow(ImDrawList* list, ImVec2 at, float width) : list_(list), at_(at), x_(at.x), right_(at.x + width) {}

    void span(const ProseSpan& span, const ImVec4& colour) {
        std::string_view text = span.text;
        while (!text.empty()) {
            const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
            word(text.substr(0, end), span, colour);
            if (end == text.size()) return;
            if (text[end] == '\n')
                new_line();
            else
                gap_ = true;
            text.remove_prefix(end + 1);
        }
    }
    /// The y coordinate below the drawn text.
    [[nodiscard]] float end() const { return at_.y + line_height(); }

    [[nodiscard]] static float line_height() {
        ImGui::PushFont(fonts().reading);
        const float line = ImGui::GetTextLineHeight() * 1.28f;
        ImGui::PopFont();
        return line;
    }

  private:
    static ImFont* font_of(const ProseSpan& span) {
        return span.code ? fonts().figures : span.strong || span.emphasis ? fonts().heading : fonts().reading;
    }
    static float size_of(const ProseSpan& span) {
        const float reading = fonts().reading->FontSize * ImGui::GetIO().FontGlobalScale;
        return span.code ? 0.94f * reading : reading;
    }
    static float width_of(std::string_view text, const ProseSpan& span) {
        return font_of(span)->CalcTextSizeA(size_of(span), 1e9f, 0, text.data(), text.data() + text.size()).x;
    }
    void new_line() {
        x_ = at_.x;
        at_.y += line_height();
        gap_ = false;
    }
    /// Draws a word, on a new line if it does not fit on this one.
    void word(std::string_view text, const ProseSpan& span, const ImVec4& colour) {
        if (text.empty()) return;
        const float blank = gap_ && x_ > at_.x ? width_of(" ", span) : 0;
        gap_ = false;
        if (x_ + blank + width_of(text, span) > right_ && x_ > at_.x)
            new_line();
        else
            x_ += blank;
        for (const ColouredPiece& piece : coloured_pieces(text))
            draw(piece.text, span, piece.is_symbol ? theme()[piece.symbol] : colour);
    }
    void draw(std::string_view text, const ProseSpan& span, const ImVec4& colour) {
        const float size = size_of(span), width = width_of(text, span);
        if (list_ != nullptr) {
            const ImVec2 low{x_, at_.y + (line_height() - size) / 2 - px(1)};
            if (span.code)
                list_->AddRectFilled({low.x - px(1), low.y - px(1)},
                                     {low.x + width + px(1), low.y + size + px(2)}, to_u32(theme().field),
                                     px(3));
            list_->AddText(font_of(span), size, low, to_u32(colour), text.data(), text.data() + text.size());
            if (!span.link.empty())
                list_->AddLine({low.x, low.y + size + px(1)}, {low.x + width, low.y + size + px(1)},
                               to_u32(colour, 0.5f));
        }
        x_ += width;
    }

    ImDrawList* list_;  // null: only measure
    ImVec2 at_;
    float x_, right_;
    bool gap_ = false;
};

/// Moves the cursor below the drawn text.
void take_room(ImVec2 from, float end, float below) {
    ImGui::SetCursorScreenPos(from);
    ImGui::Dummy({0, std::max(end - from.y, 0.0f) + px(below)});
}

void code_block(const ProseBlock& block) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, pad = px(8);
    std::string text;
    for (const ProseSpan& span : block.spans) text += span.text;
    while (!text.empty() && text.back() == '\n') text.pop_back();
    ImGui::PushFont(fonts().figures);
    const float high = ImGui::CalcTextSize(text.c_str(), nullptr, false, width - 2 * pad).y;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, from + ImVec2(width, high + 2 * pad), to_u32(theme().field), px(4));
    list.AddText(nullptr, 0, from + ImVec2(pad, pad), to_u32(theme().text), text.c_str(), nullptr,
                 width - 2 * pad);
    ImGui::PopFont();
    take_room(from, from.y + high + 2 * pad, 6);
}

void block_of_words(const ProseBlock& block) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float indent = 0;
    if (block.kind == ProseKind::Item) {
        indent = px(20) * float(std::max(block.level, 1));
        const std::string mark = block.number < 0 ? "•" : fmt::format("{}.", block.number);
        list.AddText(fonts().reading, fonts().reading->FontSize * ImGui::GetIO().FontGlobalScale,
                     {from.x + indent - px(18), from.y + px(2)}, to_u32(theme().dim_text), mark.c_str());
    }
    if (block.kind == ProseKind::Quote) indent = px(12);
    Flow flow(&list, {from.x + indent, from.y}, std::max(width - indent, px(40)));
    ImVec4 colour = block.kind == ProseKind::Quote ? theme().dim_text : theme().text;
    for (ProseSpan span : block.spans) {
        span.strong = span.strong || block.kind == ProseKind::Heading;
        flow.span(span, colour);
    }
    if (block.kind == ProseKind::Quote)
        list.AddRectFilled(from, {from.x + px(3), flow.end()}, to_u32(theme().accent));
    take_room(from, flow.end(), block.kind == ProseKind::Item ? 1 : 6);
}

}  // namespace

std::vector<ColouredPiece> coloured_pieces(std::string_view word) {
    std::vector<ColouredPiece> pieces;
    const auto add = [&pieces](std::string_view text, std::optional<Quantity> quantity) {
        if (text.empty()) return;
        if (quantity) return pieces.push_back({text, true, colour_of(*quantity)});
        const bool goes_on = !pieces.empty() && !pieces.back().is_symbol;
        if (goes_on)
            pieces.back().text = {pieces.back().text.data(), pieces.back().text.size() + text.size()};
        else
            pieces.push_back({text});
    };
    for (std::size_t i = 0; i < word.size();) {
        std::size_t end = i;
        while (end < word.size() && (is_letter(word[end]) || (word[end] == '_' && end > i))) ++end;
        if (end == i) {
            add(word.substr(i, 1), {});
            ++i;
            continue;
        }
        const std::string_view run = word.substr(i, end - i);
        const bool after =
            i >= times_sign.size() && word.substr(i - times_sign.size(), times_sign.size()) == times_sign;
        add(run, quantity_of(run, after || word.substr(end).starts_with(times_sign)));
        i = end;
    }
    return pieces;
}

void prose(const std::vector<ProseBlock>& blocks) {
    for (const ProseBlock& block : blocks) {
        if (block.kind == ProseKind::Code)
            code_block(block);
        else
            block_of_words(block);
    }
}

void prose_line(const std::string& text) { prose_line(text, theme().text); }

void prose_line(const std::string& text, const ImVec4& colour) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    Flow flow(ImGui::GetWindowDrawList(), from, ImGui::GetContentRegionAvail().x);
    flow.span({.text = text, .link = {}}, colour);
    take_room(from, flow.end(), 4);
}

float prose_height(const std::string& text, float width) {
    Flow flow(nullptr, {0, 0}, width);
    flow.span({.text = text, .link = {}}, {});
    return flow.end();
}

void prose_at(ImDrawList& list, ImVec2 at, float width, const std::string& text, const ImVec4& colour) {
    Flow flow(&list, at, width);
    flow.span({.text = text, .link = {}}, colour);
}

}  // namespace glint
