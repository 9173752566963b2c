#include "ui/features/games/quiz.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "models/io/file.h"
#include "ui/commands/command.h"
#include "ui/feature.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Makes the page of a question. Its picture is twice as large as on paper, for high-resolution displays.
Result<QuizPage> page_of(LessonRunner& runner, const SceneDocument& document, const Lesson& lesson,
                         const LessonStep& step, const Prediction& question) {
    QuizPage page;
    page.title = step.title;
    page.question = question.question;
    for (const LessonOption& option : question.options) page.options.push_back(option.text);
    for (const LessonPart& part : step.parts)
        if (const auto* text = std::get_if<std::vector<ProseBlock>>(&part))
            page.text.insert(page.text.end(), text->begin(), text->end());
    const Result<SceneDocument> set = LessonRunner::with(document, step.set, lesson, step.line);
    if (const Problem* problem = problem_of(set)) return *problem;
    const Result<SceneDocument> shown =
        LessonRunner::for_paper(std::get<SceneDocument>(set), step, lesson, false);
    if (const Problem* problem = problem_of(shown)) return *problem;
    const PictureSize size{2 * lesson.size.width, 2 * lesson.size.height};
    Result<Picture> picture = runner.picture(std::get<SceneDocument>(shown), lesson, size, 4);
    if (const Problem* problem = problem_of(picture)) return *problem;
    page.picture = std::get<Picture>(std::move(picture));
    return page;
}

Result<QuizPages> read_pages(const std::string& path, LoadProgress& progress) {
    Result<Lesson> read = read_lesson(path);
    if (const Problem* problem = problem_of(read)) return *problem;
    QuizPages quiz;
    quiz.lesson = std::get<Lesson>(std::move(read));
    LessonRunner runner(1);
    const Result<SceneDocument> opened = runner.open(quiz.lesson);
    if (const Problem* problem = problem_of(opened)) return *problem;
    for (const LessonStep& step : quiz.lesson.steps)
        for (const LessonPart& part : step.parts) {
            if (progress.cancelled) throw LoadCancelled();
            const auto* p = std::get_if<Prediction>(&part);
            if (p == nullptr || p->kind != PredictionKind::Choice) continue;
            Result<QuizPage> page = page_of(runner, std::get<SceneDocument>(opened), quiz.lesson, step, *p);
            if (const Problem* problem = problem_of(page)) return *problem;
            quiz.pages.push_back(std::get<QuizPage>(std::move(page)));
        }
    return quiz;
}

std::string kept_file(const UiState& state) {
    return state.persistence.file(state.get<QuizState>().form_b ? "quiz-b.json" : "quiz.json");
}

/// Before the lessons, the quiz includes only the questions in plain language.
std::size_t count_pages(const QuizState& quiz) {
    const auto plain = static_cast<std::size_t>(quiz.pages->lesson.plain);
    const std::size_t all = quiz.pages->pages.size();
    return quiz.after || plain == 0 ? all : std::min(all, plain);
}

QuizAnswers answers_of(const QuizState& quiz) { return {quiz.after, quiz.taken, quiz.person, quiz.seconds}; }
std::string text_of(const QuizState& quiz, const QuizAnswers& answers) {
    return json_text(answers_json(quiz.pages->lesson, answers));
}

/// The stored answers, if they match the questions of this quiz.
std::optional<QuizAnswers> kept_answers(const UiState& state) {
    constexpr std::size_t longest_file = 1 << 16;
    const QuizState& quiz = state.get<QuizState>();
    if (state.persistence.folder.empty()) return {};
    const Result<std::string> text = read_file(kept_file(state), longest_file);
    if (problem_of(text) != nullptr) return {};
    const Result<QuizAnswers> read =
        read_answers(quiz.pages->lesson, std::get<std::string>(text), kept_file(state));
    const auto* answers = std::get_if<QuizAnswers>(&read);
    if (answers == nullptr || answers->options.size() != quiz.pages->pages.size()) return {};
    return *answers;
}

/// Restores the answers of an earlier session and continues at the first unanswered question.
void recall_answers(UiState& state) {
    QuizState& quiz = state.get<QuizState>();
    quiz.taken.assign(quiz.pages->pages.size(), {});
    quiz.seconds.assign(quiz.taken.size(), 0);
    quiz.kept = answers_of(quiz);
    const std::optional<QuizAnswers> answers = kept_answers(state);
    if (!answers) return;
    quiz.kept = *answers;
    quiz.after = answers->after;
    quiz.taken = answers->options;
    quiz.person = answers->person;
    if (!answers->seconds.empty()) quiz.seconds = answers->seconds;
    const auto first = std::find(quiz.taken.begin(), quiz.taken.end(), std::nullopt);
    quiz.at = static_cast<std::size_t>(first - quiz.taken.begin());
}

void keep_answers(UiState& state) {
    QuizState& quiz = state.get<QuizState>();
    const QuizAnswers now = answers_of(quiz);
    if (now == quiz.kept) return;
    const char* const answers = "Your answers";
    if (!can_keep(state, answers)) return;
    quiz.kept = now;
    const auto written = write_file_at_once(kept_file(state), text_of(quiz, now));
    if (const Problem* problem = problem_of(written)) tell_not_kept(state, answers, *problem);
}

void begin_quiz_again(QuizState& quiz) {
    quiz.put_away = std::exchange(quiz.taken, decltype(quiz.taken)(quiz.taken.size()));
    quiz.at = 0;
}

void take_pages(UiState& state) {
    QuizState& quiz = state.get<QuizState>();
    Result<QuizPages> read = quiz.loading->take();
    quiz.loading.reset();
    if (const Problem* problem = problem_of(read)) {
        quiz.open = false;
        return state.notifications.add(*problem);
    }
    quiz.pages = std::get<QuizPages>(std::move(read));
    const std::vector<QuizPage>& pages = quiz.pages->pages;
    recall_answers(state);
    if (pages.empty()) return;
    quiz.sheet.reset(pages.front().picture.size, 4, static_cast<int>(pages.size()));
    for (std::size_t i = 0; i < pages.size(); ++i) quiz.sheet.put(static_cast<int>(i), pages[i].picture);
}

std::size_t count_taken(const QuizState& quiz) {
    return static_cast<std::size_t>(
        std::count_if(quiz.taken.begin(), quiz.taken.end(), [](const auto& t) { return t.has_value(); }));
}

void page(QuizState& quiz) {
    const QuizPage& page = quiz.pages->pages[quiz.at];
    ImGui::PushFont(fonts().heading);
    ImGui::TextUnformatted(page.title.c_str());
    ImGui::PopFont();
    const float width = std::min(ImGui::GetContentRegionAvail().x, px(361));
    const PictureSize cell = quiz.sheet.cell;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size{width, width * float(cell.height) / float(cell.width)};
    quiz.sheet.draw(*ImGui::GetWindowDrawList(), static_cast<int>(quiz.at), low, low + size);
    ImGui::Dummy(size);
    ImGui::Dummy({0, px(4)});
    prose(page.text);
    prose({{ProseKind::Heading, 3, -1, {{.text = page.question, .link = {}}}}});
    for (std::size_t i = 0; i < page.options.size(); ++i) {
        const bool taken = quiz.taken[quiz.at] == i;
        if (option_card(letter_of_option(i), page.options[i], taken ? OptionLook::Taken : OptionLook::Open))
            quiz.taken[quiz.at] = i;
    }
}

void save_answers(UiState& state, const std::string& path) {
    const auto written =
        write_file_at_once(path, text_of(state.get<QuizState>(), answers_of(state.get<QuizState>())));
    if (const Problem* problem = problem_of(written)) return state.notifications.add(*problem);
    std::error_code not_there;
    if (!state.persistence.folder.empty()) std::filesystem::remove(kept_file(state), not_there);
    state.notifications.add(Tone::Done,
                            fmt::format("Saved {}", std::filesystem::path(path).filename().string()));
}

void last_page(UiState& state) {
    QuizState& quiz = state.get<QuizState>();
    prose_line(fmt::format("You answered {} of {} questions.", count_taken(quiz), count_pages(quiz)));
    prose_line(
        "The right answers are not shown here: the lessons explain them, and after the lessons you answer "
        "the questions again.");
    ImGui::Dummy({0, px(6)});
    if (ImGui::RadioButton("before the lessons", !quiz.after)) quiz.after = false;
    ImGui::SameLine(0, px(16));
    if (ImGui::RadioButton("after them", quiz.after)) quiz.after = true;
    ImGui::Dummy({0, px(6)});
    ImGui::SetNextItemWidth(px(160));
    (void)text_field("##person", "your number or code", quiz.person);
    tooltip("Your number or code",
            "Use the same one before and after the lessons, so your gain can be computed");
    ImGui::Dummy({0, px(6)});
    if (main_button("Save my answers…"))
        state.files.ask(answers_purpose, quiz.after ? "answers-after.json" : "answers-before.json");
    tooltip("Save my answers", "Saves a file for `glint quiz ANSWERS.json...`, which evaluates a class");
    small_dim("The file contains your code but no name, unless you put one in the file name.");
}

void answer_by_key(QuizState& quiz, KeyPress press) {
    if (!press.is_alone()) return;
    const std::size_t count = count_pages(quiz);
    const std::size_t options = quiz.at < count ? quiz.pages->pages[quiz.at].options.size() : 0;
    if (const auto option = option_of_key(press, options))
        quiz.taken[quiz.at] = option;
    else if (press.key == Key::Enter || press.key == Key::PageDown)
        quiz.at = std::min(quiz.at + 1, count);
    else if (press.key == Key::PageUp && quiz.at > 0)
        --quiz.at;
}

void ways_on(QuizState& quiz) {
    const std::size_t count = count_pages(quiz);
    ImGui::Separator();
    const float width = px(92), right = ImGui::GetWindowContentRegionMax().x;
    ImGui::BeginDisabled(quiz.at == 0);
    if (ImGui::Button("‹ Back##quiz", {width, 0})) --quiz.at;
    ImGui::EndDisabled();
    tooltip("Previous question", "Shortcut: PgUp");
    if (count_taken(quiz) > 0) {
        ImGui::SameLine();
        if (ImGui::Button("Begin again##quiz")) begin_quiz_again(quiz);
        tooltip("Begin again", "Clears all answers and starts at the first question");
    } else if (!quiz.put_away.empty()) {
        ImGui::SameLine();
        if (ImGui::Button("Restore them##quiz")) quiz.taken = std::exchange(quiz.put_away, {});
        tooltip("Restore them", "The answers from before you began again");
    }
    const std::string place = quiz.at < count ? fmt::format("{} of {}", quiz.at + 1, count) : "the end";
    ImGui::SameLine((right - ImGui::CalcTextSize(place.c_str()).x) / 2);
    dim_text(place.c_str());
    if (quiz.at >= count) return;
    ImGui::SameLine(right - width);
    if (chosen_button("Next ›##quiz", quiz.taken[quiz.at].has_value(), width)) ++quiz.at;
    tooltip("Next question", "Shortcut: PgDn or Enter");
}

}  // namespace

const FilePurpose answers_purpose{.title = "Save my answers",
                                  .button = "Save",
                                  .hint = "Answers (.json) for `glint quiz`",
                                  .extensions = {".json"},
                                  .saves = true,
                                  .is_about_scene = false,
                                  .use = save_answers};

namespace {

/// Form B is meant for after the lessons, unless the user says otherwise.
void open_form(UiState& state, bool form_b) {
    QuizState& quiz = state.get<QuizState>();
    quiz.open = true;
    if (std::exchange(quiz.form_b, form_b) != form_b) {
        quiz.pages.reset();
        quiz.loading.reset();
        quiz.put_away.clear();
        quiz.at = 0;
        quiz.after = form_b;
    }
    if (quiz.pages || quiz.loading) return;
    std::filesystem::path path = state.get<LessonState>().inventory;
    if (form_b) path.replace_filename("inventory-b.md");
    quiz.loading = state.jobs.start<QuizPages>(
        "Quiz", [path = path.string()](LoadProgress& progress) { return read_pages(path, progress); });
}

void open_form_b(UiState& state) { open_form(state, true); }

/// Adds the time since the last call to the time spent on page `was`.
void count_time(QuizState& quiz, std::size_t was) {
    const double now = ImGui::GetTime();
    if (was < quiz.seconds.size()) quiz.seconds[was] += std::round(10 * (now - quiz.since)) / 10;
    quiz.since = now;
}

/// Draws the dialog. Keys: an option's letter chooses it, Enter and PgDn go to the next question, PgUp goes
/// back.
void quiz_dialog(UiState& state, const UiInput& input) {
    QuizState& quiz = state.get<QuizState>();
    if (quiz.loading && quiz.loading->done()) take_pages(state);
    if (quiz.loading) redraw_within(0.05);
    if (!quiz.open) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ImVec2 size{std::min(px(640), window.x - px(40)), std::min(px(700), window.y - px(30))};
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(size);
    if (!begin_modal("What do you believe about lighting?##quiz", &quiz.open,
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
        return;
    if (!quiz.pages) {
        dim_text("Drawing the pictures …");
    } else {
        const std::size_t was = quiz.at;
        if (ImGui::IsWindowAppearing()) quiz.since = ImGui::GetTime();
        if (!ImGui::IsWindowAppearing())
            for (const KeyPress& press : input.presses) answer_by_key(quiz, press);
        ImGui::PushID(static_cast<int>(quiz.at));  // each page has its own scroll position
        ImGui::BeginChild("##page", {0, -ImGui::GetFrameHeightWithSpacing() - px(8)});
        if (quiz.at < count_pages(quiz))
            page(quiz);
        else
            last_page(state);
        ImGui::EndChild();
        ImGui::PopID();
        ways_on(quiz);
        if (quiz.at != was) count_time(quiz, was);
        keep_answers(state);
    }
    if (!quiz.open || state.files.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace

void open_quiz(UiState& state) { open_form(state, false); }

namespace {

std::vector<WindowCommand> quiz_commands() {
    return {
        {.name = "Quiz: what do you believe about lighting?",
         .section = Section::LectureGames,
         .run = open_quiz,
         .why_disabled =
             [](const UiState& s) {
                 return unless(!s.get<LessonState>().inventory.empty(), "Glint's quiz is not installed");
             },
         .quiet = true,
         .words = "test game"},
        {.name = "Quiz, form B: the same questions with other numbers",
         .section = Section::LectureGames,
         .run = open_form_b,
         .why_disabled =
             [](const UiState& s) {
                 return unless(!s.get<LessonState>().inventory.empty(), "Glint's quiz is not installed");
             },
         .quiet = true,
         .words = "test game after"},
    };
}

}  // namespace

extern const Feature quiz_feature;
const Feature quiz_feature{.dialog = {[](const UiState& s) { return s.get<QuizState>().open; },
                                      [](UiState& s) { s.get<QuizState>().open = false; }, quiz_dialog},
                           .sheet = [](UiState& s) { return &s.get<QuizState>().sheet; },
                           .commands = quiz_commands};

}  // namespace glint
