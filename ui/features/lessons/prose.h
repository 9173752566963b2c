#pragma once
// Text of a lesson in a column: large, with its styles, and with the letters of the equation in their
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
/// Its height at that width.
[[nodiscard]] float prose_height(const std::string& text, float width);
/// Draws it at a position of the window, at that width; the cursor stays.
void prose_at(ImDrawList& list, ImVec2 at, float width, const std::string& text, const ImVec4& colour);

/// A piece of a word in one colour: a letter of the equation in its own.
struct ColouredPiece {
    std::string_view text;
    bool is_symbol = false;
    Symbol symbol = Symbol::N;
};
/// A word split where its colour changes. Vectors are letters next to a dot, "n·l"; factors have an index,
/// "k_d".
[[nodiscard]] std::vector<ColouredPiece> coloured_pieces(std::string_view word);

}  // namespace glint
