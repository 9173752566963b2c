#pragma once
// A lesson on paper: text, pictures, questions with room for the answer, and for the lecturer the key.

#include <string>

#include "lessons/run_lesson.h"

namespace glint {

/// A self-contained HTML page, with a picture of each step whose scene differs from the one before. Without
/// `key`, omits claims, and the pictures and text of reveals. A problem if the lesson's scene cannot be
/// opened or an answer cannot be computed.
[[nodiscard]] Result<std::string> handout_html(LessonRunner& runner, const Lesson& lesson, bool key);

/// The size of the lesson's pictures on paper: its own, or a multiple of it that is at least 640 pixels wide.
[[nodiscard]] PictureSize handout_size(const Lesson& lesson);

}  // namespace glint
