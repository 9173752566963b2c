#include "ui/inspector/equation/text_line.h"

#include <algorithm>
#include <cstdio>

#include "models/saturate.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float padding_x = 2, padding_y = 1;  // of a handle, logical pixels

/// The width of the number as it is now, at least that of two figures: enough to take hold of.
float handle_width(const NumberHandle& handle) {
    char text[64];
    std::snprintf(text, sizeof text, handle.number.kind.format, double(*handle.number.place));
    ImGui::PushFont(fonts().figures);
    const float width = std::max(ImGui::CalcTextSize(text).x, ImGui::CalcTextSize("00").x);
    ImGui::PopFont();
    return width + 2 * px(padding_x) + px(2);
}

void dotted_line(ImVec2 low, ImVec2 high, ImU32 colour) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const int dots = saturated_int((high.x - low.x - px(4)) / px(3));
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

/// Puts the cursor where the next `width` go, in a new line when they do not fit into this one.
void TextLine::place(float width) {
    if (x_ + width > right_ && x_ > left_ + indent_) {
        x_ = left_ + indent_;
        y_ += height();
    }
    ImGui::SetCursorScreenPos({x_, y_});
    x_ += width;
}

TextLine& TextLine::piece(const std::string& text, const ImVec4& colour, ImFont* font, float down) {
    ImGui::PushFont(font);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
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
TextLine& TextLine::number(const std::string& text, const ImVec4& colour) {
    return piece(text, colour, fonts().figures, 0);
}
TextLine& TextLine::symbol(Symbol symbol, const char* letter, const char* index) {
    piece(letter, theme()[symbol], fonts().body, 0);
    return *index != 0 ? piece(index, theme()[symbol], fonts().small, px(3)) : *this;
}

TextLine& TextLine::dot(Symbol a, Symbol b) {
    return symbol(a, letter_of(a)).plain("·").symbol(b, letter_of(b));
}

TextLine& TextLine::times() { return gap(3).plain("×").gap(3); }

TextLine& TextLine::gap(float width) {
    x_ += px(width);
    return *this;
}

bool TextLine::edit(const NumberHandle& handle, const ImVec4& colour, float down) {
    const float width = handle_width(handle);
    const SceneNumber& n = handle.number;
    place(width);
    ImGui::SetCursorScreenPos(ImGui::GetCursorScreenPos() + ImVec2(0, down));
    ImGui::PushStyleColor(ImGuiCol_FrameBg, {0, 0, 0, 0});
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(padding_x), px(padding_y)});
    const bool changed = bare_number(handle.name.c_str(), *n.place, n.kind, static_cast<float>(n.initial),
                                     {n.help, n.pointer}, width);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    dotted_line(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), to_u32(colour, 0.8f));
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
    x_ = x_ + width > right_ ? right_ + 1 : right_ - width;  // past the edge: place() begins a new line
    if (x_ > right_) {
        x_ = right_ - width;
        y_ += height();
    }
    piece(text, colour, fonts().figures, 0);
}

}  // namespace glint
