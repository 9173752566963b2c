#pragma once
// Prints a lesson: as a handout with room for answers, as an answer key, as slides, and as lecturer's notes.

#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"
#include "lessons/run_lesson.h"

namespace glint {

/// Student: without claims, and without the pictures and text of reveals. Key: includes all of them. Slides:
/// one step after another for a projector, each question and its answer on its own slide. Instructor: the
/// goals, and for each question the answer and typical wrong answers.
enum class PageKind { Student, Key, Slides, Instructor };

/// A self-contained HTML page, with a picture of each step whose scene differs from the previous one. Returns
/// a problem if the lesson's scene cannot be opened or an answer cannot be computed.
[[nodiscard]] Result<std::string> handout_html(LessonRunner& runner, const Lesson& lesson, PageKind kind);

/// The size of the lesson's printed pictures: the lesson's own size, or a multiple of it that is at least 640
/// pixels wide.
[[nodiscard]] PictureSize handout_size(const Lesson& lesson);

/// The alternative text of a step's picture: the lesson's description, or else the names of the objects and
/// lights in the scene.
[[nodiscard]] std::string alternative_text(const LessonStep& step, const Scene& scene);

// Self-contained HTML pages of lessons, for screen and print.

/// A complete page. `body` is HTML, `title` is text.
[[nodiscard]] std::string page_html(std::string_view title, std::string_view body);

/// A line of a lesson as HTML, with subscripts: k_d becomes k with a subscript d.
[[nodiscard]] std::string lesson_html(std::string_view text);

/// Replaces each one-letter name that has a one-letter index, such as k_d, with `form`, whose arguments are
/// the two letters: `{0}<sub>{1}</sub>`. `underline` separates them in the text.
[[nodiscard]] std::string with_indices(std::string_view text, std::string_view underline,
                                       const std::string& form);

/// Text of a lesson as HTML. Omits quotes that begin with "In the window".
[[nodiscard]] std::string prose_html(const std::vector<ProseBlock>& blocks);

}  // namespace glint
