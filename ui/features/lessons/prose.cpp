#include "ui/features/lessons/prose.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>

#include "renderer/explain/quantity.h"
#include "ui/features/inspector/equation/quantity_look.h"
#include "ui/widgets/area.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr std::string_view times_sign = "·";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The quantity of this sequence of letters, including an index if it has one.
std::optional<Quantity> quantity_of(std::string_view run, bool beside_dot) {
    for (const QuantityRow& row : quantity_rows) {
        const bool is_vector = row.quantity >= Quantity::N && row.quantity <= Quantity::H;
        if (text_of(row.quantity) == run && (*row.index != 0 || (is_vector && beside_dot)))
            return row.quantity;
    }
    return {};
}

/// Line layout for words.
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
    /// The y below everything drawn.
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
    /// Draws a word; truncates it if it is longer than a line.
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

/// Continues below the drawn text.
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
