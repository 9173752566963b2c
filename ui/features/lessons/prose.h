#pragma once
// Draws a lesson's text in a column: large, with its styles, and with symbols of the equation in their
// colours.

#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"
#include "ui/widgets/theme.h"

namespace glint {

/// Draws paragraphs, lists, quotes and code into the current window, at its full width.
void prose(const std::vector<ProseBlock>& blocks);

/// One paragraph of plain text.
void prose_line(const std::string& text);
void prose_line(const std::string& text, const ImVec4& colour);
/// The height of a paragraph at that width.
[[nodiscard]] float prose_height(const std::string& text, float width);
/// Draws a paragraph at a position in the window, at that width; the cursor does not move.
void prose_at(ImDrawList& list, ImVec2 at, float width, const std::string& text, const ImVec4& colour);

/// A piece of a word in one colour; a symbol of the equation has its own colour.
struct ColouredPiece {
    std::string_view text;
    bool is_symbol = false;
    Symbol symbol = Symbol::N;
};
/// Splits a word where its colour changes. Vectors are letters next to a dot, "n·l"; factors have an index,
/// "k_d".
[[nodiscard]] std::vector<ColouredPiece> coloured_pieces(std::string_view word);

}  // namespace glint
