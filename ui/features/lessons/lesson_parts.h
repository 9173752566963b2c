#pragma once
// The parts of the lesson's column and of the quiz, and the switch above the column.

#include <imgui.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"
#include "ui/features/lessons/lesson.h"
#include "ui/widgets/theme.h"

namespace glint {

/// The state of an option: available, chosen, or marked once the answer is known.
enum class OptionLook { Open, Taken, Right, TakenRight, TakenWrong, Other };

/// A card with an option's text, as wide as the window; true when clicked. `letter`: "A".
bool option_card(const std::string& letter, const std::string& text, OptionLook look);
/// "A", "B" and so on.
[[nodiscard]] std::string letter_of_option(std::size_t index);
/// Returns which of `options` options a key chooses: the one with its letter, without modifier keys.
[[nodiscard]] std::optional<std::size_t> option_of_key(KeyPress press, std::size_t options);

/// The main button: in the accent colour, as wide as its label unless `width` is given.
bool main_button(const char* label, float width = 0);

/// A swatch with the colour's bytes, 0 to 255, and a label. `colour`: channels from 0 to 1, as displayed.
void colour_row(const char* word, const Json& colour);
/// Draws a picker for such a colour; true when it was edited.
bool pick_colour(const char* id, Json& colour);

/// The plot of a sketch. The mouse draws while `right` is null; otherwise the two curves are shown.
void sketch_plot(LessonState& lesson, const Prediction& question, const Json& mine, const Json* right);

/// The answer fields of the open question, and the button that locks the answer in.
void answer_fields(UiState& state, const StationQuestion& question);
/// An answer next to the right one, with their difference and a link to the equation.
void revealed_answer(UiState& state, const StationQuestion& question, const GivenAnswer& given);
/// A given answer on one line, before the reveal.
[[nodiscard]] std::string given_words(const Prediction& question, const GivenAnswer& given);

/// Switches the lecturer's mode; stations shown in it do not count as seen by a student. Asks first, as
/// go_on() does.
void switch_lecturer(UiState& state);

/// Draws a task: its text, its controls, and whether it is done.
void task_box(UiState& state, const Task& task, bool done, bool holds_now);

/// Formats a number as it appears in answers: at most four digits.
[[nodiscard]] std::string answer_text(double value, const std::string& unit);

// Draws a lesson's text in a column: large, with its styles, and with symbols of the equation in their
// colours.

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
