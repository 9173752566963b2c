// Parses the blocks of a lesson.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

#include "lessons/lesson_source.h"
#include "models/problem.h"
#include "models/scene/mistakes.h"

namespace glint {
namespace {

/// Parses two pixels separated by a space.
std::pair<glm::ivec2, glm::ivec2> read_ends(const BlockLine& line, PictureSize picture) {
    const std::vector<std::string> words = words_of(line.value);
    if (words.size() != 2)
        fail_at(line.line, in_quotes(line.value) + " is not a line", "two pixels as in 0,180 639,180");
    const glm::ivec2 from = read_place(words[0], line.line, picture),
                     to = read_place(words[1], line.line, picture);
    if (from == to) fail_at(line.line, in_quotes(line.value) + " is one pixel", "two that differ");
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
    if (!value.empty()) fail_at(line.line, in_quotes(line.key) + " stands twice", "one line of it");
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
            if (!waits) fail_at(line.line, "a second condition of one option", "option: before it");
            option.is_right = read_expression(line, p.runs);
        } else if (line.key == "mistake") {
            require_mistake(line.value, line.line);
            take_once(line, option.mistake);
        } else {
            take_once(line, option.thinks);
        }
    }
    if (p.options.size() < 2 || p.options.back().is_right.text().empty())
        fail_at(block.line, "a choice lacks options", "two at least, each with a line if: after it");
}

/// Reads wrong answers, each followed by the misconception behind it.
void read_wrong(const SourceBlock& block, Prediction& p) {
    for (const BlockLine& line : block.lines) {
        if (line.is_run || (line.key != "wrong" && line.key != "thinks")) continue;
        const bool waits = !p.wrong.empty() && p.wrong.back().thinks.empty();
        if (waits != (line.key == "thinks"))
            fail_at(line.line, in_quotes(line.key) + " is out of order", "wrong: and after it thinks:");
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
                fail_at(line.line, in_quotes(line.key) + " has no part in predict " + block.kind,
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

}  // namespace glint
