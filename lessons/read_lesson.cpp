// Builds a lesson from the parts of its file, and lists lesson files.
#include <algorithm>
#include <filesystem>

#include "lessons/lesson_source.h"
#include "models/io/file.h"
#include "models/problem.h"
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
        if (error)
            return Problem{word, "", "cannot be read: " + reason(error.value()), "a folder of lessons"};
        std::sort(inside.begin(), inside.end());
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

}  // namespace glint
