#pragma once
// A line of the equation: letters in their colours, numbers to read and numbers to drag, on one baseline. It
// goes on in the next line where the column ends.

#include <imgui.h>

#include <string>

#include "ui/inspector/equation/factors.h"
#include "ui/widgets/area.h"
#include "ui/widgets/theme.h"

namespace glint {

class TextLine {
  public:
    /// Begins at the cursor; lines after the first are indented by `indent` logical pixels.
    explicit TextLine(float indent = 14);

    TextLine& plain(const std::string& text);
    TextLine& plain(const std::string& text, const ImVec4& colour);
    /// Figures of equal width.
    TextLine& number(const std::string& text, const ImVec4& colour);
    TextLine& symbol(Symbol symbol, const char* letter, const char* index = "");
    /// "a·b", each letter in its colour.
    TextLine& dot(Symbol a, Symbol b);
    TextLine& times();
    /// A number to drag, dotted below. True when it was edited.
    bool handle(const NumberHandle& number, const ImVec4& colour);
    /// A handle raised like an exponent.
    bool exponent(const NumberHandle& number, const ImVec4& colour);
    /// At the right edge of the column.
    void result(const std::string& text, const ImVec4& colour);
    TextLine& gap(float width);

    [[nodiscard]] static float height();

  private:
    void place(float width);
    TextLine& piece(const std::string& text, const ImVec4& colour, ImFont* font, float down);
    bool edit(const NumberHandle& number, const ImVec4& colour, float down);

    float x_, y_, left_, right_, indent_;
};

}  // namespace glint
