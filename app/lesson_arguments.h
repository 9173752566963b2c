#pragma once
// Finds the lessons that a command is about.

#include <string>
#include <vector>

#include "models/lesson/lesson.h"

namespace glint {

/// Returns the files that the words name: a file, a folder of lessons, or a lesson of the program by its name
/// or number ("05-lambert", "lambert", "5"). Without words: all lessons of the program. Throws Failure.
[[nodiscard]] std::vector<std::string> named_lessons(const std::vector<std::string>& words);

/// The file of the only lesson that `word` names. Throws Failure.
[[nodiscard]] std::string lesson_file(const std::string& word);
/// The only lesson that `word` names, read. Throws Failure.
[[nodiscard]] Lesson open_lesson(const std::string& word);

}  // namespace glint
