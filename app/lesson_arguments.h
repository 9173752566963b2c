#pragma once
// Which lessons a command is about.

#include <string>
#include <vector>

#include "models/lesson/lesson.h"

namespace glint {

/// The files that the words name: a file, a folder of lessons, or a lesson that comes with the program by its
/// name or number ("05-lambert", "lambert", "5"). Without words, all that come with it. Throws Failure.
[[nodiscard]] std::vector<std::string> named_lessons(const std::vector<std::string>& words);

/// The file of the only lesson that `word` names. Throws Failure.
[[nodiscard]] std::string lesson_file(const std::string& word);
/// The only lesson that `word` names, read. Throws Failure.
[[nodiscard]] Lesson open_lesson(const std::string& word);

}  // namespace glint
