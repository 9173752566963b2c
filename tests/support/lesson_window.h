#pragma once
// Shared by the tests of lessons in the window: a window with an open lesson, and a student who
// answers with mouse and keys.

#include <filesystem>
#include <string>
#include <thread>

#include "tests/places.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"

namespace glint::test {

/// The file of a lesson that comes with the program.
inline std::string shipped_lesson(const std::string& name) {
    return (std::filesystem::path(project_folder) / "assets/lessons" / (name + ".md")).string();
}

/// A folder with the scene of own_lesson().
struct LessonFolder : TemporaryDirectory {
    LessonFolder() { (void)file("ball.json", R"({"glint": 1, "objects": [{"name": "Ball"}]})"); }
};

/// A user's lesson with these steps, for a LessonFolder.
inline std::string own_lesson(const std::string& steps) {
    return "# Mine\n\n```lesson\ntopic: Own\nscene: ball.json\nsize: 32x32\n```\n\n" + steps;
}

inline void drop(HeadlessWindow& bench, const std::string& path) {
    bench.open(path);
    bench.frames(3);
}

inline void type(HeadlessWindow& bench, const std::string& text) {
    for (const char c : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
    (void)bench.frame();
}

/// Runs frames until the tasks' conditions have been evaluated on the current scene.
inline void wait_for_tasks(HeadlessWindow& bench) {
    const LessonState& lesson = bench.state.get<LessonState>();
    do {
        (void)bench.frame();
        std::this_thread::yield();
    } while (lesson.watching || !lesson.watched || !(lesson.watched->of == bench.scene()));
    bench.frames(2);
}

/// The first open question. Precondition: there is one.
inline const StationQuestion& asked(const HeadlessWindow& bench) {
    const LessonState& lesson = bench.state.get<LessonState>();
    return lesson.station().questions[open_question(lesson).value()];
}

/// Enters an answer with mouse and keys, the correct one if possible, without locking it in.
inline void give_answer(HeadlessWindow& bench) {
    const StationQuestion& question = asked(bench);
    const Json& right = question.right.value;
    switch (question.asks->kind) {
    case PredictionKind::Number:
        bench.click(bench.control("Your answer"));
        return type(bench, std::to_string(right.get<double>()));
    case PredictionKind::Choice:
        return bench.click(
            bench.control(question.asks->options[static_cast<std::size_t>(right.get<double>())].text));
    case PredictionKind::Click: {
        const glm::dvec2 place{elements_of(right)[0].get<double>(), elements_of(right)[1].get<double>()};
        const PictureSize size = bench.state.rendered->size;
        return bench.click(
            bench.at_pixel(share_of_lesson_pixel(bench.state, place) * glm::dvec2(size.width, size.height)));
    }
    case PredictionKind::Sketch: {
        const Rect plot = bench.area_of("Sketch");
        const float y = (plot.low.y + plot.high.y) / 2;
        return bench.drag({plot.low.x + 1, y}, {plot.high.x - 1, y});
    }
    case PredictionKind::Colour: {
        const Rect picker = bench.area_of("Colour to predict");
        return bench.click(picker.low + ImVec2(40, 40));
    }
    }
}

}  // namespace glint::test
