#pragma once
// The list of lessons: those that come with the program, and those next to the open one, with their progress.

#include <optional>
#include <string>
#include <vector>

#include "ui/features/lessons/course.h"

namespace glint {

struct UiState;
struct UiInput;

struct LessonEntry {
    std::string path, title, topic;  // without a title if the file cannot be read: opening it reports why
    std::optional<LessonRecord> record;
};

struct LessonListState {
    bool open = false;
    int chosen = -1;  // with the arrow keys, counted across both lists
    std::vector<LessonEntry> own,
        beside;  // those that come with the program; those in the open lesson's folder, if different
};

/// The number at the beginning of the file's name, "05"; empty if there is none.
[[nodiscard]] std::string number_of(const LessonEntry& entry);

/// Reads the lessons that come with the program into the list; this takes a few milliseconds.
void list_own_lessons(UiState& state);
/// Opens the dialog; a click in it, or the arrow keys and Enter, opens a lesson.
void open_lessons(UiState& state);
/// Draws the dialog. Precondition: it is open.
void lessons_dialog(UiState& state, const UiInput& input);

}  // namespace glint
