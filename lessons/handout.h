#pragma once
// A lesson as a page: on paper with room for answers, with its key, as slides, and as the lecturer's notes.

#include <string>

#include "lessons/run_lesson.h"

namespace glint {

/// Student: without the claims, pictures and text of reveals. Key: with all of them. Slides: one step after
/// another for a projector, each question and its answer on a slide of its own. Instructor: the goals, and
/// for each question the answer and what students say instead.
enum class PageKind { Student, Key, Slides, Instructor };

/// A self-contained HTML page, with a picture of each step whose scene differs from the one before. A problem
/// if the lesson's scene cannot be opened or an answer cannot be computed.
[[nodiscard]] Result<std::string> handout_html(LessonRunner& runner, const Lesson& lesson, PageKind kind);

/// The size of the lesson's pictures on paper: its own, or a multiple of it that is at least 640 pixels wide.
[[nodiscard]] PictureSize handout_size(const Lesson& lesson);

/// Describes the picture of a step to those who cannot see it: as the lesson does, else by the names of what
/// is in the scene.
[[nodiscard]] std::string alternative_text(const LessonStep& step, const Scene& scene);

}  // namespace glint
