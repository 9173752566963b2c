#pragma once
// The concept inventory in the window: a picture and four options per question, before or after the lessons,
// and the answers as a file for `glint quiz`. Until they are saved, the answers are kept with the window's
// settings, so that the next session can continue.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lessons/lesson.h"
#include "lessons/quiz.h"
#include "renderer/picture.h"
#include "ui/document/file_dialog.h"
#include "ui/document/job.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

struct UiState;
struct UiInput;

struct QuizPage {
    std::string title;
    std::vector<ProseBlock> text;
    std::string question;
    std::vector<std::string> options;
    Picture picture;  // does not reveal the answer
};
struct QuizPages {
    Lesson lesson;
    std::vector<QuizPage> pages;
};

struct QuizState {
    bool open = false, after = false;  // `after`: taken after the lessons, not before
    bool form_b = false;               // whether the questions are those of the parallel form B
    std::string person;                // a number or code, for the file
    std::vector<double> seconds;       // spent on each page
    double since = 0;                  // when the page was opened
    JobPtr<QuizPages> loading;
    std::optional<QuizPages> pages;
    std::vector<std::optional<std::size_t>> taken;     // the option chosen on each page, counted from 0
    std::vector<std::optional<std::size_t>> put_away;  // discarded by *Begin again*, which can be reverted
    QuizAnswers kept;                                  // the answers as stored on disk
    std::size_t at = 0;                                // index of the page; pages.size() at the end
    PictureSheet sheet;
};

extern const FilePurpose answers_purpose;  // writes the answers, and stops keeping them for the next session
/// Opens the dialog; unsaved answers are kept.
void open_quiz(UiState& state);

}  // namespace glint
