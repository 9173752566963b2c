// Builds a lesson from the parts of its file, and lists lesson files.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <tuple>

#include "lessons/lesson_source.h"
#include "models/io/file.h"
#include "models/json/json.h"
#include "models/problem.h"
#include "models/scene/mistakes.h"
#include "models/utf8.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

std::vector<int> read_numbers(const BlockLine& line) {
    std::vector<int> numbers;
    for (const std::string& word : words_of(line.value)) {
        const double number = read_decimal(word, line.line);
        if (number < 1 || number > 1000 || number != static_cast<int>(number))
            fail_at(line.line, in_quotes(word) + " is not the number of a row", "1, 2, 3 …");
        numbers.push_back(static_cast<int>(number));
    }
    return numbers;
}

void read_head(const SourceBlock& block, Lesson& lesson) {
    block.allow({"topic", "scene", "size", "rows", "answers", "form", "plain"}, false);
    lesson.topic = block.require("topic").value;
    lesson.scene = (fs::path(lesson.path).parent_path() / block.require("scene").value)
                       .lexically_normal()
                       .generic_string();
    if (const BlockLine* size = block.find("size")) lesson.size = read_lesson_size(size->value, size->line);
    if (const BlockLine* form = block.find("form")) lesson.form = form->value;
    if (const BlockLine* plain = block.find("plain"))
        lesson.plain = read_whole(plain->value, plain->line, 1, static_cast<int>(max_lesson_parts));
    if (const BlockLine* rows = block.find("rows")) lesson.rows = read_numbers(*rows);
    if (const BlockLine* answers = block.find("answers")) lesson.questions = read_numbers(*answers);
}

Teaching read_teaching(const SourceBlock& block) {
    block.allow({"minutes", "goal", "belief", "source", "say"}, false);
    Teaching teaching;
    constexpr int longest = 180;
    const BlockLine& minutes = block.require("minutes");
    teaching.minutes = read_whole(minutes.value, minutes.line, 1, longest);
    teaching.belief = block.require("belief").value;
    teaching.source = block.require("source").value;
    for (const BlockLine* goal : block.all("goal")) teaching.goals.push_back(goal->value);
    for (const BlockLine* say : block.all("say")) teaching.says.push_back(say->value);
    return teaching;
}

class Builder {
  public:
    explicit Builder(const std::string& path) {
        lesson_.path = path;
        lesson_.name = fs::path(path).stem().string();
        lesson_.steps.emplace_back();
    }
    void operator()(const SourceHeading& heading) {
        if (heading.level == 2) {
            require_head(heading.line);
            begin_step(heading.text);
            return;
        }
        if (!lesson_.title.empty()) fail_at(heading.line, "a second title", "one first-level heading");
        lesson_.title = heading.text;
    }
    void operator()(ProseBlock block) {
        std::vector<LessonPart>& parts = lesson_.steps.back().parts;
        if (parts.empty() || !std::holds_alternative<std::vector<ProseBlock>>(parts.back()))
            parts.emplace_back(std::vector<ProseBlock>{});
        std::get<std::vector<ProseBlock>>(parts.back()).push_back(std::move(block));
        count(0);
    }
    void operator()(const SourceBlock& block) {
        if (block.word == "lesson") {
            if (has_head_) fail_at(block.line, "a second block \"lesson\"", "one");
            read_head(block, lesson_);
            has_head_ = true;
            return;
        }
        require_head(block.line);
        if (block.word == "instructor") {
            if (lesson_.teaching.minutes != 0) fail_at(block.line, "a second block \"instructor\"", "one");
            lesson_.teaching = read_teaching(block);
            return;
        }
        if (block.word != "predict" && !block.kind.empty())
            fail_at(block.line, in_quotes(block.kind) + " does not belong there", in_quotes(block.word));
        count(block.line);
        if (block.word == "scene") {
            if (std::exchange(has_scene_, true))
                fail_at(block.line, "a second block \"scene\" in one step", "a heading ## before it");
            block.allow({"set", "picture", "shows"}, false);
            if (const BlockLine* shows = block.find("shows")) lesson_.steps.back().shows = shows->value;
            lesson_.steps.back().set = read_sets(block, "set");
            lesson_.steps.back().picture = read_sets(block, "picture");
            lesson_.steps.back().line = block.line;
            return;
        }
        lesson_.steps.back().parts.push_back(read_part(block, lesson_.size));
    }
    Lesson take() && {
        if (lesson_.title.empty()) fail_at(1, "the lesson has no title", "a line # TITLE");
        if (!has_head_) fail_at(1, "the lesson has no block \"lesson\"", "its topic and its scene");
        return std::move(lesson_);
    }

  private:
    void require_head(int line) const {
        if (!has_head_) fail_at(line, "the block \"lesson\" is missing above", "its topic and its scene");
    }
    void begin_step(const std::string& title) {
        // Keeps the part before the first heading as a step only if it is not empty.
        if (lesson_.steps.size() > 1 || !lesson_.steps[0].parts.empty() || has_scene_)
            lesson_.steps.emplace_back();
        lesson_.steps.back().title = title;
        has_scene_ = false;
    }
    void count(int line) {
        if (++parts_ > max_lesson_parts) fail_at(line, "the lesson is too long", "at most 1000 parts");
    }

    Lesson lesson_;
    bool has_head_ = false, has_scene_ = false;
    std::size_t parts_ = 0;
};

}  // namespace

Result<Lesson> parse_lesson(std::string_view text, const std::string& path) {
    text = without_byte_order_mark(text);
    return result_of(path, [&] {
        if (text.size() > max_lesson_bytes) fail_at(0, "the lesson is too long", "at most 256 KiB");
        if (const std::size_t wrong = first_invalid_utf8(text); wrong < text.size())
            fail_at(line_of(text, wrong), "the text is not UTF-8", "UTF-8");
        Builder builder(path);
        for (SourcePart& part : lesson_source(text)) std::visit(builder, part);
        return std::move(builder).take();
    });
}

Result<Lesson> read_lesson(const std::string& path) {
    const Result<std::string> text = read_file(path, max_lesson_bytes);
    if (const Problem* problem = problem_of(text)) return *problem;
    return parse_lesson(std::get<std::string>(text), path);
}

Result<std::vector<std::string>> lesson_files(const std::vector<std::string>& words) {
    std::vector<std::string> files;
    for (const std::string& word : words) {
        std::error_code error;
        if (!fs::is_directory(word, error)) {
            files.push_back(word);
            continue;
        }
        std::vector<std::string> inside;
        for (fs::directory_iterator entry(word, error), end; !error && entry != end; entry.increment(error))
            if (entry->path().extension() == ".md") inside.push_back(entry->path().generic_string());
        if (error)
            return Problem{word, "", "cannot be read: " + reason(error.value()), "a folder of lessons"};
        std::sort(inside.begin(), inside.end());
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

// Parses the blocks of a lesson.

namespace {

/// Parses two pixels separated by a space.
std::pair<glm::ivec2, glm::ivec2> read_ends(const BlockLine& line, PictureSize picture) {
    const std::vector<std::string> words = words_of(line.value);
    if (words.size() != 2)
        fail_at(line.line, in_quotes(line.value) + " is not a line", "two pixels such as 0,180 639,180");
    const glm::ivec2 from = read_place(words[0], line.line, picture),
                     to = read_place(words[1], line.line, picture);
    if (from == to) fail_at(line.line, in_quotes(line.value) + " is one pixel", "two different pixels");
    return {from, to};
}

/// Throws if the catalogue of mistakes does not contain the name.
void require_mistake(const std::string& name, int line) {
    std::vector<std::string> known;
    for (const MistakeName& mistake : mistake_names()) known.emplace_back(mistake.name);
    if (std::find(known.begin(), known.end(), name) == known.end())
        fail_at(line, in_quotes(name) + " is not a mistake", in_quotes(nearest(name, known)));
}

/// Reads a line that an option may have at most once.
void take_once(const BlockLine& line, std::string& value) {
    if (!value.empty()) fail_at(line.line, in_quotes(line.key) + " is given twice", "it only once");
    value = line.value;
}

void read_options(const SourceBlock& block, Prediction& p) {
    for (const BlockLine& line : block.lines) {
        if (line.is_run || line.key == "question") continue;
        const bool waits = !p.options.empty() && p.options.back().is_right.text().empty();
        if (line.key == "option") {
            if (waits) fail_at(line.line, "the option above has no condition", "a line if: after it");
            p.options.emplace_back();
            p.options.back().text = line.value;
            p.options.back().line = line.line;
            continue;
        }
        if (p.options.empty())
            fail_at(line.line, in_quotes(line.key) + " without an option", "option: before it");
        LessonOption& option = p.options.back();
        if (line.key == "if") {
            if (!waits) fail_at(line.line, "a second condition for one option", "option: before it");
            option.is_right = read_expression(line, p.runs);
        } else if (line.key == "mistake") {
            require_mistake(line.value, line.line);
            take_once(line, option.mistake);
        } else {
            take_once(line, option.thinks);
        }
    }
    if (p.options.size() < 2 || p.options.back().is_right.text().empty())
        fail_at(block.line, "a choice lacks options", "at least two, each with a line if: after it");
}

/// Reads wrong answers, each followed by the misconception behind it.
void read_wrong(const SourceBlock& block, Prediction& p) {
    for (const BlockLine& line : block.lines) {
        if (line.is_run || (line.key != "wrong" && line.key != "thinks")) continue;
        const bool waits = !p.wrong.empty() && p.wrong.back().thinks.empty();
        if (waits != (line.key == "thinks"))
            fail_at(line.line, in_quotes(line.key) + " is out of order", "wrong: followed by thinks:");
        if (waits)
            p.wrong.back().thinks = line.value;
        else
            p.wrong.push_back({read_expression(line, p.runs), "", line.line});
    }
    if (!p.wrong.empty() && p.wrong.back().thinks.empty())
        fail_at(p.wrong.back().line, "the wrong answer has no misconception", "a line thinks: after it");
}

std::vector<std::string> keys_of(PredictionKind kind) {
    if (kind == PredictionKind::Choice) return {"question", "option", "if", "thinks", "mistake"};
    std::vector<std::string> keys{"question", "answer", "tolerance", "term", "wrong", "thinks"};
    if (kind == PredictionKind::Number) keys.emplace_back("unit");
    if (kind == PredictionKind::Sketch) keys.emplace_back("along");
    return keys;
}

/// Throws if a line's key is not allowed in this kind of prediction.
void allow_keys(const SourceBlock& block, PredictionKind kind) {
    const auto has = [](const std::vector<std::string>& keys, const std::string& key) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    const std::vector<std::string> known = keys_of(kind);
    for (const BlockLine& line : block.lines)
        for (const PredictionKind other :
             {PredictionKind::Number, PredictionKind::Choice, PredictionKind::Sketch})  // covers every key
            if (!line.is_run && !has(known, line.key) && has(keys_of(other), line.key))
                fail_at(line.line, in_quotes(line.key) + " is not allowed in predict " + block.kind,
                        fmt::format("{}", fmt::join(known, ", ")));
    block.allow(known, true);
}

Prediction read_prediction(const SourceBlock& block, PictureSize picture) {
    const std::vector<std::string> kinds{"number", "choice", "click", "sketch", "colour"};
    const auto kind = std::find(kinds.begin(), kinds.end(), block.kind);
    if (kind == kinds.end())
        fail_at(block.line, "predict " + in_quotes(block.kind) + " is not known",
                fmt::format("{}", fmt::join(kinds, ", ")));
    Prediction p;
    p.kind = static_cast<PredictionKind>(kind - kinds.begin());
    p.line = block.line;
    allow_keys(block, p.kind);
    p.question = block.require("question").value;
    p.runs = read_runs(block.lines);
    if (p.kind == PredictionKind::Choice) {
        read_options(block, p);
        return p;
    }
    p.answer = read_expression(block.require("answer"), p.runs);
    p.tolerance = read_expression(block.require("tolerance"), p.runs);
    read_wrong(block, p);
    if (const BlockLine* unit = block.find("unit")) p.unit = unit->value;
    if (const BlockLine* term = block.find("term")) p.term = term->value;
    if (p.kind == PredictionKind::Sketch) std::tie(p.from, p.to) = read_ends(block.require("along"), picture);
    return p;
}

Reveal read_reveal(const SourceBlock& block, PictureSize picture) {
    block.allow({"set", "pick", "along", "play"}, false);
    Reveal r;
    r.line = block.line;
    r.set = read_sets(block, "set");
    if (const BlockLine* pick = block.find("pick")) r.pick = read_place(pick->value, pick->line, picture);
    if (const BlockLine* along = block.find("along")) r.along = read_ends(*along, picture);
    if (const BlockLine* play = block.find("play")) {
        const std::vector<std::string> words = words_of(play->value);
        if (words.size() != 4 || words[2] != "to" || words[0][0] != '/')
            fail_at(play->line, in_quotes(play->value) + " cannot be played", "/pointer NUMBER to NUMBER");
        r.play = words[0];
        r.play_from = read_decimal(words[1], play->line);
        r.play_to = read_decimal(words[3], play->line);
    }
    return r;
}

Task read_task(const SourceBlock& block) {
    block.allow({"drag", "control", "done", "solution"}, true);
    Task t;
    t.line = block.line;
    t.drag = block.require("drag").value;
    for (const BlockLine* line : block.all("control")) {
        if (!line->value.starts_with('/'))
            fail_at(line->line, in_quotes(line->value) + " is not a pointer", "/lights/0/position");
        t.controls.push_back(line->value);
    }
    t.runs = read_runs(block.lines);
    t.done = read_expression(block.require("done"), t.runs);
    t.solution = read_sets(block, "solution");
    return t;
}

Claim read_claim(const SourceBlock& block) {
    block.allow({"says", "check", "falls_under"}, true);
    Claim c;
    c.line = block.line;
    c.says = block.require("says").value;
    c.runs = read_runs(block.lines);
    for (const BlockLine* line : block.all("check")) c.checks.push_back(read_expression(*line, c.runs));
    if (c.checks.empty()) fail_at(block.line, "a claim checks nothing", "a line check:");
    if (const BlockLine* falls = block.find("falls_under")) c.falls_under = words_of(falls->value);
    for (const std::string& name : c.falls_under) require_mistake(name, block.find("falls_under")->line);
    return c;
}

}  // namespace

std::vector<Assignment> read_sets(const SourceBlock& block, std::string_view key) {
    std::vector<Assignment> set;
    for (const BlockLine* line : block.all(key)) set.push_back(read_set(*line));
    return set;
}

LessonPart read_part(const SourceBlock& block, PictureSize picture) {
    if (block.word == "predict") return read_prediction(block, picture);
    if (block.word == "reveal") return read_reveal(block, picture);
    if (block.word == "try") return read_task(block);
    if (block.word == "claim") return read_claim(block);
    return read_exercise(block);
}

// Exercises: blocks whose {names} are replaced by numbers for each sheet.

namespace {

constexpr std::size_t max_values = 1000;
constexpr double max_combinations = 1e9;

/// Parses `angle = 10 to 80 step 5` or `n = 5, 10, 20`.
Exercise::Variable read_variable(const BlockLine& line) {
    const std::size_t equals = std::min(line.value.find('='), line.value.size());
    Exercise::Variable variable;
    const std::vector<std::string> name = words_of(line.value.substr(0, equals));
    std::string list = equals < line.value.size() ? line.value.substr(equals + 1) : "";
    for (char& c : list)
        if (c == ',') c = ' ';
    const std::vector<std::string> words = words_of(list);
    if (name.size() != 1 || words.empty())
        fail_at(line.line, in_quotes(line.value) + " varies nothing",
                "NAME = 10 to 80 step 5, or NAME = 5, 10, 20");
    variable.name = name[0];
    if (words.size() == 5 && words[1] == "to" && words[3] == "step") {
        const double from = read_decimal(words[0], line.line), to = read_decimal(words[2], line.line),
                     step = read_decimal(words[4], line.line);
        const double steps = (to - from) / step;
        if (!(steps >= 0 && steps < static_cast<double>(max_values)))
            fail_at(line.line, in_quotes(line.value) + " gives no values, or too many", "1 to 1000");
        for (int i = 0; i <= static_cast<int>(steps + 1e-9); ++i) variable.values.push_back(from + i * step);
        return variable;
    }
    if (words.size() > max_values) fail_at(line.line, "too many values", "at most 1000");
    for (const std::string& word : words) variable.values.push_back(read_decimal(word, line.line));
    return variable;
}

/// Formats a number without rounding noise: "0.3", not 0.30000000000000004.
std::string decimal_text(double value) {
    return fmt::format("{:.10g}", std::abs(value) < 1e-12 ? 0.0 : value);
}

/// Evaluates the expression between two braces and formats the result.
std::string number_of(const std::string& text, const NamedValues& values, int line) {
    const Result<Expression> parsed = Expression::parse(text);
    if (const Problem* problem = problem_of(parsed)) fail_at(line, problem->what, problem->expected);
    const Result<double> number = std::get<Expression>(parsed).number(values);
    if (const Problem* problem = problem_of(number)) fail_at(line, problem->what, problem->expected);
    return decimal_text(std::get<double>(number));
}

/// Replaces {angle} and {sin(angle)} by numbers. Braces that contain a quotation mark are a JSON object,
/// which may contain more braces.
std::string replaced(const std::string& text, const NamedValues& values, int line) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text[at] == '{' ? text.find_first_of("{}\"", at + 1) : text.npos;
        if (end == text.npos || text[end] != '}') {
            result += text[at++];
            continue;
        }
        result += number_of(text.substr(at + 1, end - at - 1), values, line);
        at = end + 1;
    }
    return result;
}

ExerciseInstance instance_of(const Exercise& exercise, const NamedValues& values) {
    SourceBlock filled{"exercise", "", exercise.lines, exercise.line};
    for (BlockLine& line : filled.lines) line.value = replaced(line.value, values, line.line);
    ExerciseInstance instance;
    instance.values = values;
    std::vector<std::string> names;
    for (const auto& [name, unused] : values) names.push_back(name);
    instance.question = filled.require("question").value;
    instance.set = read_sets(filled, "set");
    instance.runs = read_runs(filled.lines);
    instance.answer = read_expression(filled.require("answer"), instance.runs, names);
    instance.tolerance = read_expression(filled.require("tolerance"), instance.runs, names);
    if (const BlockLine* unit = filled.find("unit")) instance.unit = unit->value;
    if (const BlockLine* closed = filled.find("closed"))
        instance.closed = read_expression(*closed, {}, names);
    return instance;
}

NamedValues values_of(const Exercise& exercise, const std::vector<double>& values) {
    NamedValues named;
    for (std::size_t i = 0; i < exercise.variables.size(); ++i)
        named[exercise.variables[i].name] = Json(values[i]);
    return named;
}

}  // namespace

Exercise read_exercise(const SourceBlock& block) {
    block.allow({"question", "vary", "set", "answer", "tolerance", "unit", "closed"}, true);
    Exercise exercise;
    exercise.line = block.line;
    std::vector<double> first;
    for (const BlockLine* line : block.all("vary")) {
        Exercise::Variable variable = read_variable(*line);
        for (const Exercise::Variable& other : exercise.variables)
            if (other.name == variable.name)
                fail_at(line->line, in_quotes(variable.name) + " is already varied", "a different name");
        exercise.variables.push_back(std::move(variable));
        first.push_back(exercise.variables.back().values.front());
    }
    double combinations = 1;
    for (const Exercise::Variable& variable : exercise.variables)
        combinations *= static_cast<double>(variable.values.size());
    if (combinations > max_combinations)
        fail_at(block.line, "the exercise varies too much", "at most 10^9 combinations");
    if (first.empty()) fail_at(block.line, "the exercise varies nothing", "a line vary:");
    std::copy_if(block.lines.begin(), block.lines.end(), std::back_inserter(exercise.lines),
                 [](const BlockLine& l) { return l.is_run || l.key != "vary"; });
    (void)instance_of(exercise, values_of(exercise, first));
    return exercise;
}

Result<ExerciseInstance> exercise_with(const Exercise& exercise, const std::vector<double>& values,
                                       const std::string& path) {
    return result_of(path, [&] { return instance_of(exercise, values_of(exercise, values)); });
}

}  // namespace glint
