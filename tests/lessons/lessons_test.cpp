// Tests for the installed lessons: they open, their claims hold, and each claim fails with the mistakes that
// it names.
#include <algorithm>
#include <set>

#include "lessons/check_lesson.h"
#include "models/io/file.h"
#include "models/scene/mistakes.h"
#include "tests/places.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

const std::vector<Lesson>& own_lessons() {
    static const std::vector<Lesson> lessons = [] {
        std::vector<Lesson> read;
        const auto files = lesson_files({project_file("assets/lessons")});
        for (const std::string& file : std::get<std::vector<std::string>>(files)) {
            const Result<Lesson> lesson = read_lesson(file);
            if (const Problem* problem = problem_of(lesson)) FAIL(problem->text());
            read.push_back(std::get<Lesson>(lesson));
        }
        return read;
    }();
    return lessons;
}

std::vector<Checked> checked(LessonRunner& runner, const Lesson& lesson, bool claims_only = false) {
    const Result<std::vector<Checked>> result = check_lesson(runner, lesson, claims_only);
    if (const Problem* problem = problem_of(result)) FAIL(problem->text());
    return std::get<std::vector<Checked>>(result);
}

/// The claims of a lesson, in the order of check_lesson().
std::vector<const Claim*> claims_of(const Lesson& lesson) {
    std::vector<const Claim*> claims;
    for (const LessonStep& step : lesson.steps)
        for (const LessonPart& part : step.parts)
            if (const auto* claim = std::get_if<Claim>(&part)) claims.push_back(claim);
    return claims;
}

template <class Part> std::size_t count_of(const LessonStep& step) {
    return static_cast<std::size_t>(std::count_if(
        step.parts.begin(), step.parts.end(), [](const auto& p) { return std::holds_alternative<Part>(p); }));
}

}  // namespace

TEST_CASE("every lesson opens, and its claims, predictions, tasks and exercises hold", "[lesson]") {
    CHECK(own_lessons().size() >= 25);
    LessonRunner runner(1);
    for (const Lesson& lesson : own_lessons())
        for (const Checked& item : checked(runner, lesson)) {
            INFO(lesson.path << ":" << item.line << ": " << name_of(item.kind) << ": " << item.says << ": "
                             << item.why);
            CHECK(item.holds);
        }
}

TEST_CASE("every reveal of a lesson follows a question", "[lesson]") {
    for (const Lesson& lesson : own_lessons()) {
        CAPTURE(lesson.path);
        std::size_t claims = 0, tasks = 0, predictions = 0;
        for (const LessonStep& step : lesson.steps) {
            bool asked = false;
            for (const LessonPart& part : step.parts) {
                asked |= std::holds_alternative<Prediction>(part);
                if (const auto* reveal = std::get_if<Reveal>(&part)) {
                    CAPTURE(reveal->line);
                    CHECK(asked);
                }
            }
            claims += count_of<Claim>(step);
            tasks += count_of<Task>(step);
            predictions += count_of<Prediction>(step);
        }
        CHECK(claims >= 2);
        CHECK(tasks >= 1);
        CHECK(predictions >= 2);
    }
}

TEST_CASE("every choice in a lesson has 3 or 4 options, and each wrong one names a belief", "[lesson]") {
    for (const Lesson& lesson : own_lessons())
        for (const LessonStep& step : lesson.steps)
            for (const LessonPart& part : step.parts) {
                const auto* p = std::get_if<Prediction>(&part);
                if (p == nullptr || p->kind != PredictionKind::Choice) continue;
                INFO(lesson.path << ":" << p->line);
                CHECK((p->options.size() == 3 || p->options.size() == 4));
                const auto silent = std::count_if(p->options.begin(), p->options.end(),
                                                  [](const LessonOption& o) { return o.thinks.empty(); });
                CHECK(silent == 1);  // only the correct option
            }
}

TEST_CASE("most lessons would show an answer without the picture settings that hide it", "[lesson]") {
    // Each of the lessons listed below fails the check if these settings are removed.
    std::set<std::string> shown;
    LessonRunner runner(1);
    for (Lesson lesson : own_lessons()) {
        for (LessonStep& step : lesson.steps) step.picture.clear();
        for (const Checked& item : checked(runner, lesson))
            if (!item.holds && item.why.find("picture") != std::string::npos)
                shown.insert(lesson.name.substr(0, lesson.name.find('-')));
    }
    for (const char* const name : {"05", "07", "10", "11", "12", "13b", "14b", "15", "17", "18", "19"}) {
        CAPTURE(name);
        CHECK(shown.contains(name));
    }
}

TEST_CASE("every question of a lesson that is not a choice names typical wrong answers", "[lesson]") {
    for (const Lesson& lesson : own_lessons())
        for (const LessonStep& step : lesson.steps)
            for (const LessonPart& part : step.parts) {
                const auto* p = std::get_if<Prediction>(&part);
                if (p == nullptr || p->kind == PredictionKind::Choice) continue;
                INFO(lesson.path << ":" << p->line);
                CHECK(!p->wrong.empty());
            }
}

TEST_CASE("every lesson has notes for the lecturer", "[lesson]") {
    for (const Lesson& lesson : own_lessons()) {
        CAPTURE(lesson.path);
        CHECK(lesson.teaching.minutes >= 5);
        CHECK(!lesson.teaching.goals.empty());
        CHECK(!lesson.teaching.belief.empty());
        CHECK(!lesson.teaching.source.empty());
        CHECK(!lesson.teaching.says.empty());
    }
}

TEST_CASE("40 students get 40 different sheets, starting from any sheet number", "[lesson][exercise]") {
    for (const Lesson& lesson : own_lessons())
        for (const LessonStep& step : lesson.steps)
            for (const LessonPart& part : step.parts) {
                const auto* exercise = std::get_if<Exercise>(&part);
                if (exercise == nullptr) continue;
                INFO(lesson.path << ":" << exercise->line);
                for (const std::uint64_t seed : {1U, 7U, 1000000U}) {
                    std::set<std::string> questions;
                    for (std::uint64_t i = 0; i < 40; ++i)
                        questions.insert(
                            std::get<ExerciseInstance>(
                                exercise_with(*exercise, drawn_values(*exercise, seed + i), lesson.path))
                                .question);
                    CHECK(questions.size() == 40);
                }
            }
}

TEST_CASE("every lesson has four exercises with a formula and at least 40 variants", "[lesson][exercise]") {
    for (const Lesson& lesson : own_lessons()) {
        CAPTURE(lesson.path);
        std::size_t count = 0;
        for (const LessonStep& step : lesson.steps)
            for (const LessonPart& part : step.parts) {
                const auto* exercise = std::get_if<Exercise>(&part);
                if (exercise == nullptr) continue;
                ++count;
                CAPTURE(exercise->line);
                std::size_t variants = 1;
                for (const Exercise::Variable& variable : exercise->variables)
                    variants *= variable.values.size();
                CHECK(variants >= 40);
                CHECK(std::any_of(exercise->lines.begin(), exercise->lines.end(),
                                  [](const BlockLine& line) { return line.key == "closed"; }));
            }
        CHECK(count >= 4);
    }
}

TEST_CASE("every claim of a lesson names mistakes that make it fail", "[lesson][mistakes]") {
    for (const Lesson& lesson : own_lessons())
        for (const Claim* claim : claims_of(lesson)) {
            INFO(lesson.path << ":" << claim->line << ": " << claim->says);
            CHECK(!claim->falls_under.empty());
        }
}

TEST_CASE("a claim of a lesson fails with each mistake that it names", "[lesson][mistakes][long][release]") {
    LessonRunner runner(1);
    for (const Lesson& lesson : own_lessons()) {
        const std::vector<const Claim*> claims = claims_of(lesson);
        std::set<std::string> named;
        for (const Claim* claim : claims) named.insert(claim->falls_under.begin(), claim->falls_under.end());
        for (const std::string& mistake : named) {
            runner.set_always({{"/shading/mistakes/" + mistake, "true"}});
            const std::vector<Checked> results = checked(runner, lesson, true);
            REQUIRE(results.size() == claims.size());
            for (std::size_t i = 0; i < claims.size(); ++i) {
                const std::vector<std::string>& names = claims[i]->falls_under;
                if (std::find(names.begin(), names.end(), mistake) == names.end()) continue;
                INFO(lesson.path << ":" << claims[i]->line << ": holds under " << mistake);
                CHECK_FALSE(results[i].holds);
            }
        }
    }
}
