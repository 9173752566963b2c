#pragma once
// The parts of the lesson's column and of the quiz, and the switch above the column.

#include <imgui.h>

#include <optional>
#include <string>

#include "ui/features/lessons/lesson.h"

namespace glint {

/// How an option of a choice stands: to be taken, taken, or told apart once the answer is known.
enum class OptionLook { Open, Taken, Right, TakenRight, TakenWrong, Other };

/// A card with an option's words, as wide as the room; true when it was clicked. `letter`: "A".
bool option_card(const std::string& letter, const std::string& text, OptionLook look);
/// "A", "B" and so on.
[[nodiscard]] std::string letter_of_option(std::size_t index);
/// Returns which of so many options a key takes: the one with its letter, pressed alone.
[[nodiscard]] std::optional<std::size_t> option_of_key(KeyPress press, std::size_t options);

/// A button that is the next thing to do: on the accent's ground, as wide as its words or as `width`.
bool main_button(const char* label, float width = 0);

/// A colour's square beside its bytes, 0 to 255, and a word: channels from 0 to 1, as displayed.
void colour_row(const char* word, const Json& colour);
/// Draws a picker of such a colour; true when it was touched.
bool pick_colour(const char* id, Json& colour);

/// The plot of a sketch, empty at first: draws with the mouse while `right` is null, else shows both curves.
void sketch_plot(LessonState& lesson, const Prediction& question, const Json& mine, const Json* right);

/// The ways to answer the open question, and the button that locks the answer in.
void answer_fields(UiState& state, const StationQuestion& question);
/// An answer beside the right one, with how far it is off and the way to the equation.
void revealed_answer(UiState& state, const StationQuestion& question, const GivenAnswer& given);
/// What somebody has answered, in one line, while it is not revealed yet.
[[nodiscard]] std::string given_words(const Prediction& question, const GivenAnswer& given);

/// Switches the lecturer's mode: what was shown in it does not count as seen by a student. Asks first, as
/// go_on() does.
void switch_lecturer(UiState& state);

/// Something to do: its words, its controls, and whether it is done.
void task_box(UiState& state, const Task& task, bool done, bool holds_now);

/// A number as answers are written: four digits, no more.
[[nodiscard]] std::string answer_text(double value, const std::string& unit);

}  // namespace glint
