// The answer fields, one for each kind of question, and the comparison of a given answer with the right one.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Draws the field for a number. True if Enter was pressed in it.
bool number_answer(LessonState& lesson, const Prediction& question) {
    const float width = px(130);
    ImGui::PushFont(fonts().reading);
    ImGui::SetNextItemWidth(width);
    // In the first frame of a window, windows drawn later take the focus away again.
    if (!ImGui::IsWindowAppearing() && std::exchange(lesson.takes_keys, false)) ImGui::SetKeyboardFocusHere();
    const bool entered =
        text_field("##answer", "a number", lesson.typed, ImGuiInputTextFlags_EnterReturnsTrue);
    if (entered && !can_lock(lesson)) {  // keep the focus, so that the text can be corrected
        lesson.takes_keys = true;
        redraw_within(0);
    }
    tooltip("Your answer", "A number, or a calculation such as 1/2 or cos(30*deg)");
    if (!question.unit.empty()) {
        const float gap = px(8), left = ImGui::GetContentRegionAvail().x - width - gap;
        const bool beside = ImGui::CalcTextSize(question.unit.c_str()).x <= left;
        if (beside) ImGui::SameLine(0, gap);
        if (beside) ImGui::AlignTextToFramePadding();
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(question.unit.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::PopFont();
    if (const std::string why = why_no_answer(lesson); !lesson.typed.empty() && !why.empty()) small_dim(why);
    return entered;
}

void choice_answer(LessonState& lesson, const Prediction& question) {
    for (std::size_t i = 0; i < question.options.size(); ++i) {
        const bool taken = lesson.chosen == Json(i);
        if (option_card(letter_of_option(i), question.options[i].text,
                        taken ? OptionLook::Taken : OptionLook::Open))
            lesson.chosen = Json(i);
    }
}

/// The numbers in a text; any other characters separate them.
std::vector<double> typed_numbers(const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t at = 0; at < text.size();) {
        double number = 0;
        const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
        if (error == std::errc{} && std::isfinite(number)) numbers.push_back(number);
        at = error == std::errc{} ? static_cast<std::size_t>(end - text.data()) : at + 1;
    }
    return numbers;
}

/// Fields for entering a position or a curve without a mouse: a pixel, or evenly spaced heights from A to B.
void typed_answer(LessonState& lesson, const Prediction& question, const char* hint) {
    ImGui::SetNextItemWidth(-1);
    const bool typed = text_field("##typed", hint, lesson.typed);
    tooltip("Type it", hint);
    const std::vector<double> numbers = typed_numbers(lesson.typed);
    if (!typed || numbers.size() < 2) return;
    const PictureSize size = lesson.course->lesson.size;
    if (question.kind == PredictionKind::Click)
        lesson.chosen = Json{std::clamp(numbers[0], 0.0, size.width - 1.0),
                             std::clamp(numbers[1], 0.0, size.height - 1.0)};
    if (question.kind != PredictionKind::Sketch) return;
    const std::size_t count = sketch_length(question);
    const double step = static_cast<double>(count - 1) / static_cast<double>(numbers.size() - 1);
    for (std::size_t i = 0; i + 1 < numbers.size(); ++i)
        sketch(lesson.chosen, count, {step * static_cast<double>(i), numbers[i]},
               {step * static_cast<double>(i + 1), numbers[i + 1]});
}

void sketch_answer(LessonState& lesson, const Prediction& question) {
    small_dim("Draw the curve with the mouse, along the line from A to B in the picture.");
    sketch_plot(lesson, question, lesson.chosen, nullptr);
    typed_answer(lesson, question, "or type heights from A to B: 1, 0.5, 0");
    if (lesson.chosen == Json()) return;
    const bool wipes = small_button("Wipe");
    tooltip("Wipe", "Removes the curve so you can draw it again");
    if (wipes) lesson.chosen = {};
}

/// Draws one of two answers in a row: a large figure under a small label that says whose answer it is.
void figure(const char* word, const std::string& text, const ImVec4& colour) {
    ImGui::BeginGroup();
    small_dim(word);
    ImGui::PushFont(fonts().heading);
    ImGui::PushTextWrapPos(0);
    coloured(colour, text);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::EndGroup();
    list_control(word, "", last_item());
}

/// Draws the two answers side by side if they fit.
void two_figures(const std::string& mine, const std::string& right, bool counts) {
    const float left = ImGui::GetCursorPosX(), half = ImGui::GetContentRegionAvail().x / 2;
    ImGui::PushFont(fonts().heading);
    const auto fits = [&](const std::string& text) {
        return ImGui::CalcTextSize(text.c_str()).x < half - px(8);
    };
    const bool beside = fits(mine) && fits(right);
    ImGui::PopFont();
    if (!mine.empty()) {
        figure("You said", mine, counts ? theme().accent : theme().warning);
        if (beside) {
            ImGui::SameLine();
            ImGui::SetCursorPosX(left + half);
        }
    }
    figure("It is", right, theme().accent);
}

std::string off_words(const Prediction& question, double off, double right) {
    switch (question.kind) {
    case PredictionKind::Number: {
        const std::string by = "Off by " + answer_text(off, question.unit);
        const double percent = 100 * off / std::abs(right);
        return percent < 10'000 ? fmt::format("{} ({:.0f} %)", by, percent) : by;
    }
    case PredictionKind::Click:
        return fmt::format("Off by {:.0f} px in the lesson's picture", off);
    case PredictionKind::Sketch:
        return fmt::format("{:.2f} apart (root mean square)", off);
    case PredictionKind::Colour:
        return fmt::format("Off by at most {:.0f} of 255 levels per channel", 255 * off);
    case PredictionKind::Choice:
        break;
    }
    return {};
}

void revealed_choice(const StationQuestion& question, const GivenAnswer& given) {
    const std::vector<LessonOption>& options = question.asks->options;
    for (std::size_t i = 0; i < options.size(); ++i) {
        const bool right = question.right.value == Json(i);
        const bool taken = given.locked && given.value == Json(i);
        const OptionLook look = taken ? (right ? OptionLook::TakenRight : OptionLook::TakenWrong)
                                      : (right ? OptionLook::Right : OptionLook::Other);
        (void)option_card(letter_of_option(i), options[i].text, look);
        if (look == OptionLook::TakenWrong && !options[i].thinks.empty())
            small_dim("The thinking behind it: " + options[i].thinks);
    }
}

void revealed_value(LessonState& lesson, const StationQuestion& question, const GivenAnswer& given) {
    const Prediction& asks = *question.asks;
    const Json& right = question.right.value;
    switch (asks.kind) {
    case PredictionKind::Number:
        return two_figures(given.locked ? answer_text(given.value.get<double>(), asks.unit) : "",
                           answer_text(right.get<double>(), asks.unit), is_right(question, given));
    case PredictionKind::Choice:
        return revealed_choice(question, given);
    case PredictionKind::Click:
        return small_dim(given.locked ? "In the picture: the ring is yours, the cross is the answer."
                                      : "In the picture: the cross is the answer.");
    case PredictionKind::Sketch:
        sketch_plot(lesson, asks, given.value, &right);
        if (given.locked) coloured(theme().warning, "yours");
        if (given.locked) ImGui::SameLine(0, px(14));
        return coloured(theme().accent, "the answer");
    case PredictionKind::Colour:
        if (given.locked) colour_row("You said", given.value);
        return colour_row("It is", right);
    }
}

}  // namespace

std::string given_words(const Prediction& question, const GivenAnswer& given) {
    if (given.skipped) return "Not predicted";
    switch (question.kind) {
    case PredictionKind::Number:
        return "You say " + answer_text(given.value.get<double>(), question.unit);
    case PredictionKind::Choice:
        return "You say: " + question.options[static_cast<std::size_t>(given.value.get<double>())].text;
    case PredictionKind::Click:
    case PredictionKind::Sketch:
    case PredictionKind::Colour:
        break;
    }
    return "Your answer is locked in";
}

void answer_fields(UiState& state, const StationQuestion& question) {
    LessonState& lesson = state.get<LessonState>();
    const Prediction& asks = *question.asks;
    bool entered = false;
    switch (asks.kind) {
    case PredictionKind::Number:
        entered = number_answer(lesson, asks);
        break;
    case PredictionKind::Choice:
        choice_answer(lesson, asks);
        break;
    case PredictionKind::Click:
        prose_line(lesson.chosen == Json() ? "Click the position in the picture."
                                           : "The ring marks your position. Click elsewhere to move it.",
                   theme().accent);
        typed_answer(lesson, asks, "or type x, y in the lesson's pixels");
        break;
    case PredictionKind::Sketch:
        sketch_answer(lesson, asks);
        break;
    case PredictionKind::Colour:
        (void)pick_colour("##colour", lesson.chosen);
        break;
    }
    small_dim("Why do you think so?");
    ImGui::SetNextItemWidth(-1);
    entered |=
        text_field("##why", "a few words, only for you", lesson.reason, ImGuiInputTextFlags_EnterReturnsTrue);
    tooltip("Your reason", "Kept with your answer, and shown again next to the right one");
    ImGui::Dummy({0, px(3)});
    const std::string why = why_no_answer(lesson);
    const bool can = why.empty();
    ImGui::BeginDisabled(!can);
    const bool locked = main_button("Lock it in");
    ImGui::EndDisabled();
    tooltip("Lock it in", can ? "Makes your answer final and shows the right one (Enter)" : why.c_str());
    if (can && (locked || entered)) return lock_in(state);
    ImGui::SameLine(0, px(12));
    ImGui::PushStyleColor(ImGuiCol_Button, {0, 0, 0, 0});
    ImGui::PushStyleColor(ImGuiCol_Text, theme().dim_text);
    const bool skipped = ImGui::Button("Show it anyway");
    ImGui::PopStyleColor(2);
    tooltip("Show it anyway", "Shows the answer without your prediction: you learn less that way");
    if (skipped) reveal_unanswered(state);
}

std::string why_no_answer(const LessonState& lesson) {
    const auto open = open_question(lesson);
    if (!open) return "No question here";
    const Prediction& question = *lesson.station().questions[*open].asks;
    const bool is_number = question.kind == PredictionKind::Number;
    if (is_number ? lesson.typed.empty() : lesson.chosen == Json()) return "Answer first";
    if (is_number) return calculated(lesson.typed, 0).problem;
    if (question.kind != PredictionKind::Sketch) return {};
    const Json::array_t& values = elements_of(lesson.chosen);
    const auto is_drawn = [](const Json& v) { return v.is_number(); };
    const auto gap = std::find_if_not(values.begin(), values.end(), is_drawn);
    if (values.size() == sketch_length(question) && gap == values.end()) return {};
    const auto end = std::find_if(gap, values.end(), is_drawn);
    return fmt::format("The curve has a gap from {} to {} on the horizontal axis: draw it there too",
                       gap - values.begin(), end - values.begin());
}

bool can_lock(const LessonState& lesson) { return why_no_answer(lesson).empty(); }

bool answer_by_key(UiState& state, KeyPress press) {
    LessonState& lesson = state.get<LessonState>();
    const auto open = open_question(lesson);
    if (!open || lesson.lecturer) return false;
    if (press == KeyPress{Key::Enter} && can_lock(lesson)) {
        lock_in(state);
        return true;
    }
    const auto option = option_of_key(press, lesson.station().questions[*open].asks->options.size());
    if (option) lesson.chosen = Json(*option);
    return option.has_value();
}

void revealed_answer(UiState& state, const StationQuestion& question, const GivenAnswer& given) {
    const Prediction& asks = *question.asks;
    revealed_value(state.get<LessonState>(), question, given);
    if (given.locked && asks.kind != PredictionKind::Choice) {
        const double off = how_far(asks.kind, given.value, question.right.value);
        const bool exact = off < 1e-3 * question.right.tolerance;
        const double right = asks.kind == PredictionKind::Number ? question.right.value.get<double>() : 0;
        const bool counts = is_right(question, given);
        const std::string words = off_words(asks, off, right);
        if (counts)
            coloured(theme().accent, exact ? "Exactly." : "Close enough. " + words + ".");
        else
            warning_text(words + ".");
        const std::string thought = thought_behind(asks, question.right, given.value);
        if (!thought.empty()) small_dim("The thinking behind it: " + thought);
    }
    if (!given.why.empty()) small_dim("Your reason: " + given.why);
    if (given.skipped && !state.get<LessonState>().lecturer) small_dim("You did not predict it.");
    const Reveal* reveal = state.get<LessonState>().station().reveal;
    if (reveal == nullptr || !reveal->pick) return;
    const char* const label = asks.term.empty() ? "The pixel's equation" : "Show it in the equation";
    if (small_button(label)) show_in_equation(state, asks);
    tooltip(label, asks.term.empty() ? "For the pixel that the lesson picked"
                                     : "The picked pixel's equation, with this number marked");
}

}  // namespace glint
