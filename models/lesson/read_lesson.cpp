// What a lesson's parts mean.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "models/io/file.h"
#include "models/io/utf8.h"
#include "models/json/json_reader.h"
#include "models/lesson/lesson_source.h"
#include "models/scene/mistakes.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

std::vector<Assignment> read_sets(const SourceBlock& block, std::string_view key) {
    std::vector<Assignment> set;
    for (const BlockLine* line : block.all(key)) set.push_back(read_set(*line));
    return set;
}

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

/// Two pixels with a blank between them.
std::pair<glm::ivec2, glm::ivec2> read_ends(const BlockLine& line) {
    const std::vector<std::string> words = words_of(line.value);
    if (words.size() != 2)
        fail_at(line.line, in_quotes(line.value) + " is not a line", "two pixels as in 0,180 639,180");
    return {read_place(words[0], line.line), read_place(words[1], line.line)};
}

void read_head(const SourceBlock& block, Lesson& lesson) {
    block.allow({"topic", "scene", "size", "rows", "answers"}, false);
    lesson.topic = block.require("topic").value;
    lesson.scene = (fs::path(lesson.path).parent_path() / block.require("scene").value)
                       .lexically_normal()
                       .generic_string();
    if (const BlockLine* size = block.find("size")) lesson.size = read_lesson_size(size->value, size->line);
    if (const BlockLine* rows = block.find("rows")) lesson.rows = read_numbers(*rows);
    if (const BlockLine* answers = block.find("answers")) lesson.questions = read_numbers(*answers);
}

void read_options(const SourceBlock& block, Prediction& p) {
    for (const BlockLine& line : block.lines) {
        if (line.is_run) continue;
        const bool waits = !p.options.empty() && p.options.back().is_right.text().empty();
        if (line.key == "option") {
            if (waits) fail_at(line.line, "the option above has no condition", "a line if: behind it");
            p.options.push_back({line.value, {}, line.line});
        } else if (line.key == "if") {
            if (!waits) fail_at(line.line, "a condition without an option", "option: before it");
            p.options.back().is_right = read_expression(line, p.runs);
        }
    }
    if (p.options.size() < 2 || p.options.back().is_right.text().empty())
        fail_at(block.line, "a choice lacks options", "two at least, each with a line if: behind it");
}

Prediction read_prediction(const SourceBlock& block) {
    const std::vector<std::string> kinds{"number", "choice", "click", "sketch", "colour"};
    const auto kind = std::find(kinds.begin(), kinds.end(), block.kind);
    if (kind == kinds.end())
        fail_at(block.line, "predict " + in_quotes(block.kind) + " is not known",
                fmt::format("{}", fmt::join(kinds, ", ")));
    Prediction p;
    p.kind = static_cast<PredictionKind>(kind - kinds.begin());
    p.line = block.line;
    if (p.kind == PredictionKind::Choice) {
        block.allow({"question", "option", "if"}, true);
    } else {
        block.allow({"question", "answer", "tolerance", "unit", "term", "along"}, true);
    }
    p.question = block.require("question").value;
    p.runs = read_runs(block.lines);
    if (p.kind == PredictionKind::Choice) {
        read_options(block, p);
        return p;
    }
    p.answer = read_expression(block.require("answer"), p.runs);
    p.tolerance = read_expression(block.require("tolerance"), p.runs);
    if (const BlockLine* unit = block.find("unit")) p.unit = unit->value;
    if (const BlockLine* term = block.find("term")) p.term = term->value;
    if (p.kind == PredictionKind::Sketch) std::tie(p.from, p.to) = read_ends(block.require("along"));
    return p;
}

Reveal read_reveal(const SourceBlock& block) {
    block.allow({"set", "pick", "along", "play"}, false);
    Reveal r;
    r.line = block.line;
    r.set = read_sets(block, "set");
    if (const BlockLine* pick = block.find("pick")) r.pick = read_place(pick->value, pick->line);
    if (const BlockLine* along = block.find("along")) r.along = read_ends(*along);
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
    std::vector<std::string> known;
    for (const MistakeName& mistake : mistake_names()) known.emplace_back(mistake.name);
    for (const std::string& name : c.falls_under)
        if (std::find(known.begin(), known.end(), name) == known.end())
            fail_at(block.find("falls_under")->line, in_quotes(name) + " is no mistake",
                    in_quotes(nearest(name, known)));
    return c;
}

/// Puts a lesson together from the parts of its file.
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
        if (!lesson_.title.empty()) fail_at(heading.line, "a second title", "one heading of the first level");
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
        if (block.word != "predict" && !block.kind.empty())
            fail_at(block.line, in_quotes(block.kind) + " does not belong there", in_quotes(block.word));
        count(block.line);
        if (block.word == "scene") {
            if (std::exchange(has_scene_, true))
                fail_at(block.line, "a second block \"scene\" in one step", "a heading ## before it");
            block.allow({"set"}, false);
            lesson_.steps.back().set = read_sets(block, "set");
            lesson_.steps.back().line = block.line;
            return;
        }
        lesson_.steps.back().parts.push_back(part_of(block));
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
        // What stands before the first heading is a step only where there is anything.
        if (lesson_.steps.size() > 1 || !lesson_.steps[0].parts.empty() || has_scene_)
            lesson_.steps.emplace_back();
        lesson_.steps.back().title = title;
        has_scene_ = false;
    }
    void count(int line) {
        if (++parts_ > max_lesson_parts) fail_at(line, "the lesson is too long", "at most 1000 parts");
    }
    static LessonPart part_of(const SourceBlock& block) {
        if (block.word == "predict") return read_prediction(block);
        if (block.word == "reveal") return read_reveal(block);
        if (block.word == "try") return read_task(block);
        if (block.word == "claim") return read_claim(block);
        return read_exercise(block);
    }

    Lesson lesson_;
    bool has_head_ = false, has_scene_ = false;
    std::size_t parts_ = 0;
};

}  // namespace

Result<Lesson> parse_lesson(std::string_view text, const std::string& path) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    try {
        if (text.size() > max_lesson_bytes) fail_at(0, "the lesson is too long", "at most 256 KiB");
        if (const std::size_t wrong = first_invalid_utf8(text); wrong < text.size())
            fail_at(line_of(text, wrong), "the text is not UTF-8", "UTF-8");
        Builder builder(path);
        for (SourcePart& part : lesson_source(text)) std::visit(builder, part);
        return std::move(builder).take();
    } catch (ProblemFound& found) {
        found.problem.file = path;
        return std::move(found.problem);
    }
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
        if (error) return Problem{word, "", "cannot be read: " + error.message(), "a folder of lessons"};
        std::sort(inside.begin(), inside.end());
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

}  // namespace glint
