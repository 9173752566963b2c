#include "ui/lessons/lesson_progress.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "models/io/file.h"
#include "models/io/temporary.h"
#include "models/io/utf8.h"
#include "ui/preferences/autosave.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_file = std::size_t{1} << 20;
const char* const skipped_word = "skipped";

std::string file_of(const UiState& state) { return state.persistence.file("lessons.json"); }

JsonValue json_of(const GivenAnswer& given) {
    if (given.skipped) return skipped_word;
    return given.locked ? JsonValue(JsonValue::Elements{given.value}) : JsonValue();
}

/// Numbers alone, as many as the right answer has.
bool fits(const JsonValue& value, const StationQuestion& question) {
    const JsonValue& right = question.right.value;
    const auto is_finite = [](const JsonValue& v) { return v.is_number() && std::isfinite(v.number()); };
    if (question.asks->kind == PredictionKind::Choice)
        return value.is_whole_number() && value.number() >= 0 &&
               value.number() < static_cast<double>(question.asks->options.size());
    if (!right.is_array()) return is_finite(value);
    const JsonValue::Elements& list = value.elements();
    return list.size() == right.elements().size() && std::all_of(list.begin(), list.end(), is_finite);
}

std::optional<GivenAnswer> read_given(const JsonValue& json, const StationQuestion& question) {
    if (json == JsonValue()) return GivenAnswer{};
    if (json.is_string()) return GivenAnswer{{}, false, true};
    if (json.elements().size() != 1 || !fits(json.elements()[0], question)) return {};
    return GivenAnswer{json.elements()[0], true, false};
}

/// A whole number from 0 on; `otherwise` where there is none.
int count_in(const JsonValue& json, const char* name, int otherwise) {
    const JsonValue* found = json.find(name);
    if (found == nullptr || !found->is_whole_number()) return otherwise;
    return static_cast<int>(std::clamp(found->number(), 0.0, 1e6));
}

const JsonValue::Elements& list_in(const JsonValue& json, const char* name) {
    static const JsonValue nothing;
    const JsonValue* found = json.find(name);
    return (found == nullptr ? nothing : *found).elements();
}

/// The records as the file has them; empty where there is no file.
Result<JsonValue> read_records(const UiState& state) {
    const std::string file = file_of(state);
    std::error_code failed;
    if (!fs::exists(file, failed) && !failed) return JsonValue::object();
    const Result<std::string> text = read_file(file, longest_file);
    if (const Problem* problem = problem_of(text)) return *problem;
    JsonValue read = JsonValue::parse(std::get<std::string>(text)).value_or(JsonValue());
    if (!read.is_object()) return Problem{file, "", "does not hold what Glint wrote", "JSON, or no file"};
    return read;
}

/// Writes the records, unless they could not be read again.
Result<std::monostate> write_records(const UiState& state, const JsonValue& records) {
    const std::string text = json_text(records);
    if (text.size() > longest_file) return Problem{file_of(state), "", "is full", "at most 1 MiB"};
    return write_file_at_once(file_of(state), text);
}

/// The record of the lesson goes into the file, beside all others. What cannot be read is not written over.
Result<std::monostate> keep_record(const UiState& state) {
    const LessonState& lesson = state.lesson;
    Result<JsonValue> read = read_records(state);
    if (const Problem* problem = problem_of(read)) return *problem;
    const Course& course = *lesson.course;
    auto& records = std::get<JsonValue>(read);
    JsonValue& record = records[record_key(lesson.folder, course.lesson.path)];
    const std::optional<CourseProgress> kept = read_progress(record, course);
    record =
        progress_json(course, kept ? with_changes(*kept, lesson.written, lesson.progress) : lesson.progress);
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

JsonValue progress_json(const Course& course, const CourseProgress& progress) {
    JsonValue given = JsonValue::array(), tasks = JsonValue::array();
    for (std::size_t i = 0; i < course.stations.size(); ++i) {
        JsonValue answers = JsonValue::array(), done = JsonValue::array();
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

std::optional<CourseProgress> read_progress(const JsonValue& json, const Course& course) {
    CourseProgress progress = fresh_progress(course);
    const JsonValue::Elements &given = list_in(json, "answers"), &tasks = list_in(json, "tasks_done");
    if (given.size() != course.stations.size() || tasks.size() != course.stations.size()) return {};
    for (std::size_t i = 0; i < course.stations.size(); ++i) {
        const std::vector<StationQuestion>& questions = course.stations[i].questions;
        const JsonValue::Elements &answers = given[i].elements(), &done = tasks[i].elements();
        if (answers.size() != questions.size() || done.size() != progress.tasks[i].size()) return {};
        for (std::size_t q = 0; q < questions.size(); ++q) {
            const std::optional<GivenAnswer> read = read_given(answers[q], questions[q]);
            if (!read) return {};
            progress.given[i][q] = *read;
        }
        for (std::size_t t = 0; t < done.size(); ++t) progress.tasks[i][t] = done[t] == JsonValue(true);
    }
    progress.station =
        std::min(static_cast<std::size_t>(count_in(json, "at", 0)), course.stations.size() - 1);
    return progress;
}

std::optional<LessonRecord> read_record(const JsonValue& json) {
    if (!json.is_object()) return {};
    LessonRecord record;
    record.at = static_cast<std::size_t>(count_in(json, "at", 0));
    record.stations = static_cast<std::size_t>(std::max(count_in(json, "stations", 1), 1));
    record.score = {count_in(json, "questions", 0), count_in(json, "locked", 0), count_in(json, "right", 0),
                    count_in(json, "tasks", 0), count_in(json, "done", 0)};
    return record;
}

JsonValue lesson_records(const UiState& state) {
    if (state.persistence.folder.empty()) return JsonValue::object();
    Result<JsonValue> read = read_records(state);
    return problem_of(read) == nullptr ? std::get<JsonValue>(std::move(read)) : JsonValue::object();
}

CourseProgress recall_progress(const UiState& state, const Course& course) {
    const JsonValue records = lesson_records(state);
    const JsonValue* record = records.find(record_key(state.lesson.folder, course.lesson.path));
    if (record == nullptr) return fresh_progress(course);
    return read_progress(*record, course).value_or(fresh_progress(course));
}

CourseProgress with_changes(CourseProgress kept, const CourseProgress& before, const CourseProgress& now) {
    if (now.station != before.station) kept.station = now.station;
    for (std::size_t i = 0; i < kept.given.size(); ++i)
        for (std::size_t q = 0; q < kept.given[i].size(); ++q)
            if (json_of(now.given[i][q]) != json_of(before.given[i][q])) kept.given[i][q] = now.given[i][q];
    for (std::size_t i = 0; i < kept.tasks.size(); ++i)
        for (std::size_t t = 0; t < kept.tasks[i].size(); ++t)
            if (now.tasks[i][t] != before.tasks[i][t]) kept.tasks[i][t] = now.tasks[i][t];
    return kept;
}

void keep_progress(UiState& state, double patience) {
    constexpr double ask_again = 0.02;  // seconds
    LessonState& lesson = state.lesson;
    if (!lesson.course || lesson.lecturer || lesson.progress == lesson.written) return;
    const char* const answers = "What is answered and done here";
    if (!can_keep(state, answers)) return;
    const FolderLock lock(state.persistence.folder, patience);
    if (!lock.held()) return redraw_within(ask_again);
    const Result<std::monostate> written = keep_record(state);
    if (const Problem* problem = problem_of(written)) tell_not_kept(state, answers, *problem);
    lesson.written = lesson.progress;
}

}  // namespace glint
