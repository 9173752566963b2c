#pragma once
// The parts of the lesson's column and of the quiz, and the switch above the column.

#include <imgui.h>

#include <optional>
#include <string>

#include "ui/features/lessons/lesson.h"

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
/// Draws a picker of such a colour; true when it was edited.
bool pick_colour(const char* id, Json& colour);

/// The plot of a sketch, empty at first. The mouse draws while `right` is null; else both curves are shown.
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

/// A task: its text, its controls, and whether it is done.
void task_box(UiState& state, const Task& task, bool done, bool holds_now);

/// Formats a number as in answers: at most four digits.
[[nodiscard]] std::string answer_text(double value, const std::string& unit);

}  // namespace glint
