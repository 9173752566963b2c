// The lesson's column: the current station, its text and question, and navigation.

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

#include "ui/features/export/animation.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

const std::string& step_title(const Course& course, std::size_t station) {
    const LessonStep& step = course.lesson.steps[course.stations[station].step];
    return step.title.empty() ? course.lesson.title : step.title;
}

/// Draws a clickable stroke for each station: strokes of answered stations are filled, and the current
/// station's is thicker.
void station_strokes(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    const std::size_t count = lesson.course->stations.size();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, high = px(14), step = width / float(count);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::optional<std::size_t> clicked;
    for (std::size_t i = 0; i < count; ++i) {
        const ImVec2 at{low.x + step * float(i), low.y};
        ImGui::SetCursorScreenPos(at);
        ImGui::PushID(static_cast<int>(i));
        if (hit_area("##station", {step, high})) clicked = i;
        ImGui::PopID();
        const bool here = i == lesson.progress.station, hovered = ImGui::IsItemHovered();
        const bool over = is_answered(lesson.progress, i) && (i < lesson.progress.station || here);
        const float thick = px(here ? 6.0f : hovered ? 5.0f : 3.0f);
        const ImVec4& colour = here || over ? theme().accent : hovered ? theme().text : theme().line;
        list.AddRectFilled({at.x + px(1), at.y + (high - thick) / 2},
                           {at.x + step - px(1), at.y + (high + thick) / 2}, to_u32(colour), px(1.5f));
        tooltip(fmt::format("Station {}", i + 1).c_str(), step_title(*lesson.course, i).c_str());
    }
    ImGui::SetCursorScreenPos(low + ImVec2(0, high + px(4)));
    if (clicked) go_on(state, static_cast<int>(*clicked) - static_cast<int>(lesson.progress.station));
}

void heading(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    const bool has_title = !lesson.course->lesson.steps[lesson.station().step].title.empty();
    small_dim(has_title ? lesson.course->lesson.title : lesson.course->lesson.topic);
    station_strokes(state);
    ImGui::PushFont(fonts().heading);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(step_title(*lesson.course, lesson.progress.station).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::Dummy({0, px(2)});
}

/// Draws the text of a question or a task next to a vertical bar, below a small label.
void asked(const char* word, const std::string& text) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::Indent(px(12));
    ImGui::PushFont(fonts().small);
    coloured(theme().accent, word);
    ImGui::PopFont();
    prose_line(text);
    ImGui::Unindent(px(12));
    const float end = ImGui::GetCursorScreenPos().y - px(6);
    ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + px(3), end}, to_u32(theme().accent));
    list_control(text.c_str(), word, {from, {from.x + ImGui::GetContentRegionAvail().x, end}});
}

/// Shows a lecturer the options, without controls that could be clicked by mistake.
void posed(const StationQuestion& question) {
    const std::vector<LessonOption>& options = question.asks->options;
    for (std::size_t i = 0; i < options.size(); ++i)
        (void)option_card(letter_of_option(i), letter_of_option(i) + ":  " + options[i].text,
                          OptionLook::Other);
}

void questions(UiState& state) {
    const Station& station = state.get<LessonState>().station();
    const auto open = open_question(state.get<LessonState>());
    if (open && !state.get<LessonState>().course->lesson.steps[station.step].picture.empty())
        small_dim(
            "Until you answer, the picture shows a different setting, because the real one would reveal the "
            "answer.");
    for (std::size_t i = 0; i < station.questions.size(); ++i) {
        if (open && i > *open && !state.get<LessonState>().lecturer) return;
        const StationQuestion& question = station.questions[i];
        ImGui::PushID(static_cast<int>(i));
        asked(open == i ? "WHAT DO YOU THINK?" : "QUESTION", question.asks->question);
        const GivenAnswer& given = state.get<LessonState>().given()[i];
        if (!open)
            revealed_answer(state, question, given);
        else if (state.get<LessonState>().lecturer)
            posed(question);
        else if (i < *open)
            small_dim(given_words(*question.asks, given));
        else
            answer_fields(state, question);
        ImGui::Dummy({0, px(8)});
        ImGui::PopID();
        if (open != open_question(state.get<LessonState>())) return redraw_within(0);  // just locked in
    }
    if (!open || !state.get<LessonState>().lecturer) return;
    if (main_button("Show the answer")) reveal_unanswered(state);
    tooltip("Show the answer", "Shortcut: PgDn");
}

void told(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    const Station& station = lesson.station();
    if (std::exchange(lesson.scrolls_down, false)) ImGui::SetScrollHereY(0.6f);
    if (station.reveal != nullptr && !station.reveal->play.empty()) {
        if (ImGui::Button(state.get<AnimateState>().playing ? "Stop" : "Play it")) play_reveal(state);
        tooltip("Play it", "Plays back and forth between the two ends");
    }
    const bool current = lesson.watched && lesson.watched->station == lesson.progress.station;
    std::size_t task = 0;
    for (const StationPart& part : station.after) {
        if (part.told != nullptr) {
            prose(*part.told);
            continue;
        }
        ImGui::PushID(static_cast<int>(task));
        asked("DO IT", "Drag " + part.task->drag + ".");
        const bool now = current && task < lesson.watched->done.size() && lesson.watched->done[task];
        task_box(state, *part.task, lesson.progress.tasks[lesson.progress.station][task], now);
        ImGui::Dummy({0, px(8)});
        ImGui::PopID();
        ++task;
    }
}

/// Shows the score after the last station.
void summary(UiState& state) {
    const LessonState& lesson = state.get<LessonState>();
    if (lesson.progress.station + 1 < lesson.course->stations.size()) return;
    const CourseScore score = score_of(*lesson.course, lesson.progress);
    std::string text = fmt::format("End of this lesson. {} of {} questions predicted, {} of them correctly",
                                   score.locked, score.questions, score.right);
    if (score.tasks > 0) text += fmt::format("; {} of {} tasks done by hand", score.done, score.tasks);
    ImGui::Dummy({0, px(4)});
    small_dim(text + ".");
    if (small_button("Begin again")) begin_again(state);
    tooltip("Begin again", "Clears all answers and starts at the first station");
}

/// The bottom row: back, current station, next.
void ways_on(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    const std::size_t at = lesson.progress.station, count = lesson.course->stations.size();
    const bool open = open_question(lesson).has_value();
    ImGui::Separator();
    const float width = px(92), right = ImGui::GetWindowContentRegionMax().x;
    ImGui::BeginDisabled(at == 0);
    const bool back = ImGui::Button("‹ Back", {width, 0});
    ImGui::EndDisabled();
    tooltip("Back", "The previous station, with its scene", "", "PgUp");
    const std::string place = fmt::format("{} of {}", at + 1, count);
    ImGui::SameLine((right - ImGui::CalcTextSize(place.c_str()).x) / 2);
    dim_text(place.c_str());
    ImGui::SameLine(right - width);
    const bool last = at + 1 == count;
    const bool next = chosen_button(last ? "Lessons…" : "Next ›", !open, width);
    tooltip(last ? "Lessons" : "Next", last ? "Choose another lesson" : "The next station, with its scene",
            "", last ? "" : "PgDn");
    if (back) go_on(state, -1);
    if (next && last) open_lessons(state);
    if (next && !last) go_on(state, 1);
}

/// Offers to restore the lesson's scene after edits.
void way_back(UiState& state) {
    if (open_question(state.get<LessonState>())) return;
    ImGui::BeginDisabled(!has_strayed(state));
    if (ImGui::Button("Back to the lesson's scene", {ImGui::GetContentRegionAvail().x, 0}))
        back_to_scene(state);
    ImGui::EndDisabled();
    tooltip("Back to the lesson's scene",
            "Restores the scene as it was before you changed it; undo brings yours back");
}

/// The height of the rows below the text. It is always reserved, so that the text does not jump during a
/// drag.
float height_below(const UiState& state) {
    const float row = ImGui::GetFrameHeightWithSpacing();
    return row + px(8) + (open_question(state.get<LessonState>()) ? 0 : row);
}

}  // namespace

void lesson_column(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    if (!lesson.course) return;  // the lesson was closed in this frame
    heading(state);
    ImGui::BeginChild("##lesson", {0, -height_below(state)});
    if (std::exchange(lesson.scrolls_up, false)) ImGui::SetScrollY(0);
    for (const auto* text : lesson.station().before) prose(*text);
    questions(state);
    if (!open_question(lesson)) {
        told(state);
        summary(state);
    }
    ImGui::EndChild();
    way_back(state);
    ways_on(state);
}

std::string lesson_caption(const UiState& state) {
    const LessonState& lesson = state.get<LessonState>();
    if (!lesson.course) return {};
    if (const auto open = open_question(lesson)) return lesson.station().questions[*open].asks->question;
    return step_title(*lesson.course, lesson.progress.station);
}

// Finds an answer's number in the equation.

namespace {

/// A field of an explanation (docs/explain.md) and the letter under which its number is shown.
struct TermPlace {
    std::string_view field;
    Quantity quantity;
    InspectorTab tab = InspectorTab::Equation;
};
constexpr std::array places{
    TermPlace{"n_dot_l", Quantity::NL},
    TermPlace{"r_dot_v", Quantity::RV},
    TermPlace{"n_dot_h", Quantity::NH},
    TermPlace{"l_dot_v", Quantity::LV},
    TermPlace{"falloff", Quantity::Falloff},
    TermPlace{"spot", Quantity::Spot},
    TermPlace{"distance", Quantity::Distance},
    TermPlace{"diffuse", Quantity::DiffuseTerm},
    TermPlace{"specular", Quantity::SpecularTerm},
    TermPlace{"ambient", Quantity::AmbientTerm},
    TermPlace{"diffuse_factor", Quantity::NL},
    TermPlace{"cool_to_warm.k_w", Quantity::WarmShare},
    TermPlace{"r", Quantity::R, InspectorTab::Vectors},
    TermPlace{"l", Quantity::L, InspectorTab::Vectors},
    TermPlace{"h", Quantity::H, InspectorTab::Vectors},
};

/// The position of a field such as "lights[0].r.world[0]", and the light's index; for an unknown field, the
/// position of the sum.
std::pair<TermPlace, int> place_of(std::string_view term) {
    int light = -1;
    if (std::sscanf(std::string(term).c_str(), "lights[%d]", &light) == 1)
        term.remove_prefix(term.find('.') + 1);
    for (const TermPlace& place : places) {
        if (!term.starts_with(place.field)) continue;
        const std::string_view rest = term.substr(place.field.size());
        if (rest.empty() || rest.front() == '.' || rest.front() == '[') return {place, light};
    }
    return {{"sum", Quantity::Result}, -1};
}

}  // namespace

void mark_in_equation(UiState& state, const Prediction& question) {
    constexpr double seen_s = 5, scrolls_s = 0.3;
    const auto [place, light] = place_of(question.term);
    InspectorState& inspector = state.get<InspectorState>();
    inspector.tab = place.tab;
    inspector.world_frame = question.term.find("world") != std::string::npos;
    if (!question.term.empty())
        inspector.marked = {place.quantity, light, ImGui::GetTime() + scrolls_s, ImGui::GetTime() + seen_s};
    if (light >= 0) {
        state.editor.selection = valid_selection({Selection::Kind::Light, light}, state.editor.scene());
        inspector.corner = 0;
    }
    redraw_within(0);
}

void show_in_equation(UiState& state, const Prediction& question) {
    const Station& station = state.get<LessonState>().station();
    if (station.reveal == nullptr || !station.reveal->pick) return;
    mark_in_equation(state, question);
    ask_about(state.viewport, share_of_lesson_pixel(state, glm::dvec2(*station.reveal->pick) + 0.5));
    state.layout.right = state.left_shows_inspector = true;
}

}  // namespace glint
