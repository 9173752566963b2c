#include "ui/features/lessons/course.h"

#include <algorithm>

#include "models/io/file.h"
#include "models/progress.h"

namespace glint {
namespace {

/// Cuts the parts of a lesson into stations.
class Cutter {
  public:
    explicit Cutter(std::vector<Station>& stations) : stations_(stations) {}

    void begin_step(std::size_t step) {
        step_ = step;
        begin();
    }
    void operator()(const std::vector<ProseBlock>& text) {
        Station& s = stations_.back();
        if (s.questions.empty() && s.reveal == nullptr)
            s.before.push_back(&text);
        else
            s.after.push_back({&text, nullptr});
    }
    void operator()(const Prediction& question) {
        if (stations_.back().reveal != nullptr || !stations_.back().after.empty()) begin();
        stations_.back().questions.push_back({&question, {}});
    }
    void operator()(const Reveal& reveal) {
        if (stations_.back().reveal != nullptr) begin();
        stations_.back().reveal = &reveal;
    }
    void operator()(const Task& task) { stations_.back().after.push_back({nullptr, &task}); }
    void operator()(const Claim&) const {}     // for `glint lessons --check`
    void operator()(const Exercise&) const {}  // for paper

  private:
    void begin() {
        stations_.emplace_back();
        stations_.back().step = step_;
    }
    std::vector<Station>& stations_;
    std::size_t step_ = 0;
};

/// Computes the station's scenes and answers. `step`: its step's scene.
std::optional<Problem> make_ready(Station& station, const Lesson& lesson, const SceneDocument& step,
                                  LessonRunner& runner) {
    // The question is posed as on paper: the reveal shows what the picture would give away.
    Result<SceneDocument> asked = LessonRunner::for_paper(step, lesson.steps[station.step], lesson, false);
    if (const Problem* problem = problem_of(asked)) return *problem;
    station.asked = station.questions.empty() ? step.scene : std::get<SceneDocument>(std::move(asked)).scene;
    station.revealed = step.scene;
    if (station.reveal != nullptr) {
        Result<SceneDocument> shown =
            LessonRunner::with(step, station.reveal->set, lesson, station.reveal->line);
        if (const Problem* problem = problem_of(shown)) return *problem;
        station.revealed = std::get<SceneDocument>(std::move(shown)).scene;
    }
    for (StationQuestion& question : station.questions) {
        Result<RightAnswer> right = right_answer(runner, step, lesson, *question.asks);
        if (const Problem* problem = problem_of(right)) return *problem;
        question.right = std::get<RightAnswer>(std::move(right));
    }
    return {};
}

std::vector<Station> stations_of(const Lesson& lesson) {
    std::vector<Station> stations;
    Cutter cut(stations);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        cut.begin_step(i);
        for (const LessonPart& part : lesson.steps[i].parts) std::visit(cut, part);
    }
    return stations;
}

}  // namespace

Result<std::shared_ptr<const Course>> open_course(const std::string& path) {
    Result<Lesson> read = read_lesson(path);
    if (const Problem* problem = problem_of(read)) return *problem;
    const auto course = std::make_shared<Course>();
    course->lesson = std::get<Lesson>(std::move(read));
    const Lesson& lesson = course->lesson;
    LessonRunner runner(1);  // separate from the window's
    Result<SceneDocument> opened = runner.open(lesson);
    if (const Problem* problem = problem_of(opened)) return *problem;
    course->document = std::get<SceneDocument>(std::move(opened));
    course->stations = stations_of(lesson);
    for (Station& station : course->stations) {
        if (load_cancelled()) return Problem{path, "", cancelled_words, ""};
        const LessonStep& step = lesson.steps[station.step];
        const Result<SceneDocument> set = LessonRunner::with(course->document, step.set, lesson, step.line);
        if (const Problem* problem = problem_of(set)) return *problem;
        if (const auto problem = make_ready(station, lesson, std::get<SceneDocument>(set), runner))
            return *problem;
    }
    course->document.scene = course->stations.front().asked;
    course->document.path.clear();
    return std::shared_ptr<const Course>(course);
}

bool is_lesson_file(const std::string& path) { return lower_extension(path) == ".md"; }

bool is_right(const StationQuestion& question, const GivenAnswer& given) {
    return given.locked &&
           how_far(question.asks->kind, given.value, question.right.value) <= question.right.tolerance;
}

CourseProgress fresh_progress(const Course& course) {
    CourseProgress progress;
    for (const Station& station : course.stations) {
        progress.given.emplace_back(station.questions.size());
        const auto tasks = std::count_if(station.after.begin(), station.after.end(),
                                         [](const StationPart& part) { return part.task != nullptr; });
        progress.tasks.emplace_back(static_cast<std::size_t>(tasks), false);
    }
    return progress;
}

bool is_answered(const CourseProgress& progress, std::size_t station) {
    const std::vector<GivenAnswer>& given = progress.given[station];
    return std::all_of(given.begin(), given.end(), [](const GivenAnswer& g) { return g.is_over(); });
}

CourseScore score_of(const Course& course, const CourseProgress& progress) {
    CourseScore score;
    for (std::size_t i = 0; i < course.stations.size(); ++i) {
        const std::vector<StationQuestion>& questions = course.stations[i].questions;
        for (std::size_t q = 0; q < questions.size(); ++q) {
            ++score.questions;
            score.locked += progress.given[i][q].locked;
            score.right += is_right(questions[q], progress.given[i][q]);
        }
        for (const bool done : progress.tasks[i]) {
            ++score.tasks;
            score.done += done;
        }
    }
    return score;
}

}  // namespace glint
