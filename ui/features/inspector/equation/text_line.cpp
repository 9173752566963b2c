#include "ui/features/inspector/equation/text_line.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "ui/features/inspector/equation/copy_menu.h"
#include "ui/features/inspector/equation/quantity_look.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

// The mark of the current light's card (QuantityMark in ui/features/inspector/equation/text_line.h).
std::optional<Quantity> marked;
bool marked_scrolls = false;

constexpr float padding_x = 2, padding_y = 1;  // of a handle, logical pixels

/// The width of the current number, at least that of two digits, so that it is easy to grab.
float handle_width(const NumberHandle& handle) {
    const std::string text = shown_text(static_cast<float>(handle.number.value), handle.number.kind);
    ImGui::PushFont(fonts().figures);
    const float width = std::max(ImGui::CalcTextSize(text.c_str()).x, ImGui::CalcTextSize("00").x);
    ImGui::PopFont();
    return width + 2 * px(padding_x) + px(2);
}

void draw_mark_around(const Rect& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low = area.low - px(1) * ImVec2(4, 1), high = area.high + px(1) * ImVec2(4, 1);
    list.AddRect({std::max(low.x, list.GetClipRectMin().x + px(1)), low.y}, high, to_u32(theme().accent),
                 px(4), 0, px(2));
}

void dotted_line(ImVec2 low, ImVec2 high, ImU32 colour) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const int dots = static_cast<int>((high.x - low.x - px(4)) / px(3));
    for (int i = 0; i <= dots; ++i) {
        const float x = low.x + px(2) + px(3) * float(i);
        list.AddRectFilled({x, high.y - px(1)}, {x + px(1.5f), high.y}, colour);
    }
}

}  // namespace

TextLine::TextLine(float indent) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    left_ = x_ = at.x;
    y_ = at.y;
    right_ = at.x + ImGui::GetContentRegionAvail().x;
    indent_ = px(indent);
}

float TextLine::height() {
    ImGui::PushFont(fonts().figures);
    const float line = ImGui::GetTextLineHeight();
    ImGui::PopFont();
    return line + 2 * px(padding_y);
}

/// Moves the cursor to a position where the next `width` fits, on a new line if needed.
void TextLine::place(float width) {
    keep_together(width);
    ImGui::SetCursorScreenPos({x_, y_});
    x_ += width;
}

void TextLine::keep_together(float width) {
    if (measures_) return;
    if (x_ + width <= right_ || x_ <= left_ + indent_) return;
    x_ = left_ + indent_;
    y_ += height();
}

TextLine& TextLine::piece(const std::string& text, const ImVec4& colour, ImFont* font, float down) {
    ImGui::PushFont(font);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    if (measures_) {
        x_ += size.x;
        ImGui::PopFont();
        return *this;
    }
    place(size.x);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddText({at.x, at.y + (height() - size.y) / 2 + down}, to_u32(colour),
                                        text.c_str());
    ImGui::PopFont();
    ImGui::Dummy({size.x, height()});
    return *this;
}

TextLine& TextLine::plain(const std::string& text) { return plain(text, theme().dim_text); }
TextLine& TextLine::plain(const std::string& text, const ImVec4& colour) {
    return piece(text, colour, fonts().body, 0);
}
TextLine& TextLine::code(const std::string& text, const ImVec4& colour) {
    return piece(text, colour, fonts().figures, 0);
}
TextLine& TextLine::number(const std::string& text, const ImVec4& colour) {
    piece(text, colour, fonts().figures, 0);
    if (!measures_ && mark_ && !marks_result_) end_mark(last_item());
    menu_of(text);
    return *this;
}
TextLine& TextLine::raised(const std::string& text, const ImVec4& colour) {
    piece(text, colour, fonts().small, -px(4));
    menu_of(text);
    return *this;
}

void TextLine::menu_of(const std::string& number) {
    if (measures_) return;
    // The line's position makes the IDs of its menus unique.
    ImGui::PushID(static_cast<int>(left_));
    ImGui::PushID(static_cast<int>(y_ - ImGui::GetWindowPos().y + ImGui::GetScrollY()));
    copy_menu(numbers_++, number, line_);
    ImGui::PopID();
    ImGui::PopID();
}
TextLine& TextLine::copied_as(std::string line) {
    line_ = std::move(line);
    return *this;
}

QuantityMark::QuantityMark(std::optional<Quantity> quantity, bool scrolls) {
    marked = quantity;
    marked_scrolls = scrolls;
}
QuantityMark::~QuantityMark() { marked.reset(); }

TextLine& TextLine::symbol(Quantity quantity) {
    const ImVec2 begin{x_, y_};
    letters(quantity);
    if (measures_ || marked != quantity) return *this;
    marked.reset();
    const Rect last = last_item();  // for a cosine, its second letter
    const bool went_on = last.low.y > begin.y + px(2);
    mark_ = Rect{{went_on ? left_ + indent_ : begin.x, last.low.y}, last.high};
    marks_result_ = (quantity >= Quantity::AmbientTerm && quantity <= Quantity::SpecularTerm) ||
                    quantity == Quantity::Result || quantity == Quantity::WarmShare;
    list_control("Marked number", row_of(quantity).letter, *mark_);
    if (marked_scrolls) ImGui::SetScrollHereY(0.4f);
    return *this;
}

TextLine::~TextLine() {
    if (mark_) draw_mark_around(*mark_);
}

/// Draws the mark around the letter and its value, together if they are next to each other.
void TextLine::end_mark(const Rect& value) {
    const Rect letter = *mark_;
    mark_.reset();
    if (!marks_result_ && value.low.y == letter.low.y) return draw_mark_around({letter.low, value.high});
    draw_mark_around(letter);
    draw_mark_around(value);
}

void TextLine::letters(Quantity quantity) {
    const QuantityRow& row = row_of(quantity);
    const auto letter = [&](Quantity q) {
        piece(row_of(q).letter, theme()[colour_of(q)], fonts().body, 0);
        if (!measures_) tooltip(text_of(q).c_str(), row_of(q).meaning);
    };
    if (is_cosine(quantity)) {
        const auto vectors = vectors_of(quantity);
        ImGui::PushFont(fonts().body);
        keep_together(ImGui::CalcTextSize(row.letter).x);
        ImGui::PopFont();
        letter(vectors.first);
        plain("·");
        if (!measures_) tooltip(row.letter, row.meaning);
        letter(vectors.second);
        return;
    }
    letter(quantity);
    if (*row.index == 0) return;
    piece(row.index, theme()[colour_of(quantity)], fonts().small, px(3));
    if (!measures_) tooltip(text_of(quantity).c_str(), row.meaning);
}

TextLine& TextLine::times() { return gap(2).plain("×").gap(2); }

TextLine& TextLine::gap(float width) {
    x_ += px(width);
    return *this;
}

bool TextLine::edit(const NumberHandle& handle, const ImVec4& colour, float down) {
    const float width = handle_width(handle);
    const SceneNumber& n = handle.number;
    if (measures_) {
        x_ += width;
        return false;
    }
    place(width);
    ImGui::SetCursorScreenPos(ImGui::GetCursorScreenPos() + ImVec2(0, down));
    ImGui::PushStyleColor(ImGuiCol_FrameBg, {0, 0, 0, 0});
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(padding_x), px(padding_y)});
    auto value = static_cast<float>(n.value);
    const bool changed = bare_number(handle.name.c_str(), value, n.kind, static_cast<float>(n.initial),
                                     {n.help, n.pointer}, width) &&
                         n.place != nullptr;
    if (changed) *n.place = value;
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    if (!is_read_only()) dotted_line(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), to_u32(colour, 0.8f));
    return changed;
}

bool TextLine::handle(const NumberHandle& handle, const ImVec4& colour) { return edit(handle, colour, 0); }
bool TextLine::exponent(const NumberHandle& handle, const ImVec4& colour) {
    return edit(handle, colour, -px(4));
}

void TextLine::result(const std::string& text, const ImVec4& colour) {
    ImGui::PushFont(fonts().figures);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::PopFont();
    if (x_ + px(3) + width > right_) y_ += height();
    x_ = right_ - width;
    number(text, colour);
    if (mark_) end_mark(last_item());
}

}  // namespace glint
