#include "ui/features/lessons/course.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "models/io/file.h"
#include "models/progress.h"
#include "models/utf8.h"
#include "ui/features/lessons/lesson.h"
#include "ui/ui.h"

namespace glint {
namespace {

/// Divides the parts of a lesson into stations.
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
    void operator()(const Claim&) const {}     // used only by `glint lessons --check`
    void operator()(const Exercise&) const {}  // only printed on paper

  private:
    void begin() {
        stations_.emplace_back();
        stations_.back().step = step_;
    }
    std::vector<Station>& stations_;
    std::size_t step_ = 0;
};

/// Computes the station's scenes and answers. `step`: the scene of the station's step.
std::optional<Problem> make_ready(Station& station, const Lesson& lesson, const SceneDocument& step,
                                  LessonRunner& runner) {
    // The picture must not give the answer away, so it is the one for printed handouts; the reveal shows the
    // rest.
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

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_file = std::size_t{1} << 20;
const char* const skipped_word = "skipped";

std::string file_of(const UiState& state) { return state.persistence.file("lessons.json"); }

Json json_of(const GivenAnswer& given) {
    if (given.skipped) return skipped_word;
    if (!given.locked) return {};
    return given.why.empty() ? Json(Json::array_t{given.value}) : Json(Json::array_t{given.value, given.why});
}

/// Whether the value consists only of numbers, as many as in the right answer.
bool fits(const Json& value, const StationQuestion& question) {
    const Json& right = question.right.value;
    const auto is_finite = [](const Json& v) { return v.is_number() && std::isfinite(v.get<double>()); };
    if (question.asks->kind == PredictionKind::Choice)
        return value.is_number_integer() && value.get<double>() >= 0 &&
               value.get<double>() < static_cast<double>(question.asks->options.size());
    if (!right.is_array()) return is_finite(value);
    const Json::array_t& list = elements_of(value);
    return list.size() == elements_of(right).size() && std::all_of(list.begin(), list.end(), is_finite);
}

std::optional<GivenAnswer> read_given(const Json& json, const StationQuestion& question) {
    if (json == Json()) return GivenAnswer{};
    if (json.is_string()) return GivenAnswer{{}, false, true};
    const Json::array_t& list = elements_of(json);
    const bool has_reason = list.size() == 2 && list[1].is_string();
    if ((list.size() != 1 && !has_reason) || !fits(list[0], question)) return {};
    return GivenAnswer{list[0], true, false, has_reason ? list[1].get<std::string>() : ""};
}

/// The member `name` if it is a non-negative integer, or `otherwise` if it is not.
int count_in(const Json& json, const char* name, int otherwise) {
    const Json* found = find_member(json, name);
    if (found == nullptr || !found->is_number_integer()) return otherwise;
    return static_cast<int>(std::clamp(found->get<double>(), 0.0, 1e6));
}

const Json::array_t& list_in(const Json& json, const char* name) {
    static const Json nothing;
    const Json* found = find_member(json, name);
    return elements_of((found == nullptr ? nothing : *found));
}

/// The records in the file; empty if the file is missing.
Result<Json> read_records(const UiState& state) {
    const std::string file = file_of(state);
    std::error_code failed;
    if (!fs::exists(file, failed) && !failed) return Json::object();
    const Result<std::string> text = read_file(file, longest_file);
    if (const Problem* problem = problem_of(text)) return *problem;
    Json read = json_or_null(std::get<std::string>(text));
    if (!read.is_object()) return Problem{file, "", "was not written by Glint", "JSON, or no file"};
    return read;
}

/// Writes the records, unless the file would be too long to be read back.
Result<std::monostate> write_records(const UiState& state, const Json& records) {
    const std::string text = json_text(records);
    if (text.size() > longest_file) return Problem{file_of(state), "", "is full", "at most 1 MiB"};
    return write_file_at_once(file_of(state), text);
}

/// Writes the lesson's record to the file and keeps all others there. Does not overwrite an unreadable file.
Result<std::monostate> keep_record(const UiState& state) {
    const LessonState& lesson = state.get<LessonState>();
    Result<Json> read = read_records(state);
    if (const Problem* problem = problem_of(read)) return *problem;
    const Course& course = *lesson.course;
    auto& records = std::get<Json>(read);
    records[record_key(lesson.folder, course.lesson.path)] = progress_json(course, lesson.progress);
    return write_records(state, records);
}

}  // namespace

std::string record_key(const std::string& folder, const std::string& path) {
    std::error_code failed;
    const fs::path file(path);
    if (!folder.empty() &&
        fs::equivalent(file.parent_path().empty() ? "." : file.parent_path(), folder, failed))
        return escaped_bytes(file.stem().string());
    const fs::path whole = fs::absolute(file, failed).lexically_normal();
    return escaped_bytes(failed ? path : whole.string());
}

Json progress_json(const Course& course, const CourseProgress& progress) {
    Json given = Json::array(), tasks = Json::array();
    for (std::size_t i = 0; i < course.stations.size(); ++i) {
        Json answers = Json::array(), done = Json::array();
        for (const GivenAnswer& g : progress.given[i]) answers.push_back(json_of(g));
        for (const bool d : progress.tasks[i]) done.push_back(d);
        given.push_back(answers);
        tasks.push_back(done);
    }
    const CourseScore score = score_of(course, progress);
    return {{"at", progress.station},       {"stations", course.stations.size()},
            {"questions", score.questions}, {"locked", score.locked},
            {"right", score.right},         {"tasks", score.tasks},
            {"done", score.done},           {"answers", given},
            {"tasks_done", tasks}};
}

std::optional<CourseProgress> read_progress(const Json& json, const Course& course) {
    CourseProgress progress = fresh_progress(course);
    const Json::array_t &given = list_in(json, "answers"), &tasks = list_in(json, "tasks_done");
    if (given.size() != course.stations.size() || tasks.size() != course.stations.size()) return {};
    for (std::size_t i = 0; i < course.stations.size(); ++i) {
        const std::vector<StationQuestion>& questions = course.stations[i].questions;
        const Json::array_t &answers = elements_of(given[i]), &done = elements_of(tasks[i]);
        if (answers.size() != questions.size() || done.size() != progress.tasks[i].size()) return {};
        for (std::size_t q = 0; q < questions.size(); ++q) {
            const std::optional<GivenAnswer> read = read_given(answers[q], questions[q]);
            if (!read) return {};
            progress.given[i][q] = *read;
        }
        for (std::size_t t = 0; t < done.size(); ++t) progress.tasks[i][t] = done[t] == Json(true);
    }
    progress.station =
        std::min(static_cast<std::size_t>(count_in(json, "at", 0)), course.stations.size() - 1);
    return progress;
}

std::optional<LessonRecord> read_record(const Json& json) {
    if (!json.is_object()) return {};
    LessonRecord record;
    record.at = static_cast<std::size_t>(count_in(json, "at", 0));
    record.stations = static_cast<std::size_t>(std::max(count_in(json, "stations", 1), 1));
    record.score = {count_in(json, "questions", 0), count_in(json, "locked", 0), count_in(json, "right", 0),
                    count_in(json, "tasks", 0), count_in(json, "done", 0)};
    return record;
}

Json lesson_records(const UiState& state) {
    if (state.persistence.folder.empty()) return Json::object();
    Result<Json> read = read_records(state);
    return problem_of(read) == nullptr ? std::get<Json>(std::move(read)) : Json::object();
}

CourseProgress recall_progress(const UiState& state, const Course& course) {
    const Json records = lesson_records(state);
    const Json* record =
        find_member(records, record_key(state.get<LessonState>().folder, course.lesson.path));
    if (record == nullptr) return fresh_progress(course);
    return read_progress(*record, course).value_or(fresh_progress(course));
}

void keep_progress(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    if (!lesson.course || lesson.lecturer || lesson.progress == lesson.written) return;
    const char* const answers = "Your answers and progress";
    if (!can_keep(state, answers)) return;
    const Result<std::monostate> written = keep_record(state);
    if (const Problem* problem = problem_of(written)) tell_not_kept(state, answers, *problem);
    lesson.written = lesson.progress;
}

}  // namespace glint
