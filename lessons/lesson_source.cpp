#include "lessons/lesson_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>

#include "models/problem.h"

namespace glint {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// The length in bytes of a leading name: a lower-case letter, then lower-case letters, digits and
/// underscores.
std::size_t name_length(std::string_view text) {
    const auto inside = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    std::size_t size = 0;
    while (size < text.size() && inside(text[size])) ++size;
    return size > 0 && text[0] >= 'a' ? size : 0;
}

BlockLine block_line(std::string_view text, int line) {
    const std::size_t name = name_length(text);
    const std::string_view rest = trimmed(text.substr(name));
    if (name == 0 || rest.empty() || (rest[0] != ':' && rest[0] != '='))
        fail_at(line, in_quotes(trimmed(text)) + " is not a line of a block", "key: value, or name = run");
    return {std::string(text.substr(0, name)), std::string(trimmed(rest.substr(1))), line, rest[0] == '='};
}

/// Parses the entire text as a number.
template <class Number> bool read_all(std::string_view text, Number& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

bool read_pair(std::string_view text, char separator, glm::ivec2& pair) {
    const std::size_t at = text.find(separator);
    return at != text.npos && read_all(text.substr(0, at), pair.x) && read_all(text.substr(at + 1), pair.y);
}

}  // namespace

void fail_at(int line, std::string what, std::string expected) {
    throw ProblemFound({"", "", std::move(what), std::move(expected), line});
}

std::vector<BlockLine> block_lines(const std::vector<std::string>& texts, int line) {
    std::vector<BlockLine> lines;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const std::string_view text = texts[i];
        const int number = line + static_cast<int>(i);
        if (trimmed(text).empty()) continue;
        if (is_blank(text.front()) && !lines.empty()) {
            std::string& value = lines.back().value;
            if (!value.empty()) value += ' ';
            value += trimmed(text);
        } else {
            lines.push_back(block_line(trimmed(text), number));
        }
    }
    return lines;
}

const std::vector<std::string>& lesson_block_words() {
    static const std::vector<std::string> words{"lesson", "scene", "predict",  "reveal",
                                                "try",    "claim", "exercise", "instructor"};
    return words;
}

void SourceBlock::allow(const std::vector<std::string>& keys, bool runs) const {
    for (const BlockLine& l : lines) {
        if (l.is_run && !runs) fail_at(l.line, "a run in the block " + in_quotes(word), "lines key: value");
        if (!l.is_run && std::find(keys.begin(), keys.end(), l.key) == keys.end())
            fail_at(l.line, "unknown key " + in_quotes(l.key), in_quotes(nearest(l.key, keys)));
        if (!l.is_run && l.value.empty()) fail_at(l.line, in_quotes(l.key) + " is empty", "a value after it");
    }
}

std::vector<const BlockLine*> SourceBlock::all(std::string_view key) const {
    std::vector<const BlockLine*> found;
    for (const BlockLine& l : lines)
        if (!l.is_run && l.key == key) found.push_back(&l);
    return found;
}

const BlockLine* SourceBlock::find(std::string_view key) const {
    const std::vector<const BlockLine*> found = all(key);
    if (found.size() > 1) fail_at(found[1]->line, in_quotes(key) + " is given twice", "it only once");
    return found.empty() ? nullptr : found[0];
}

const BlockLine& SourceBlock::require(std::string_view key) const {
    const BlockLine* found = find(key);
    if (found == nullptr) fail_at(line, "the block has no line " + in_quotes(std::string(key) + ":"), "one");
    return *found;
}

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream in{std::string(text)};
    return {std::istream_iterator<std::string>(in), {}};
}

glm::ivec2 read_place(std::string_view text, int line) {
    glm::ivec2 place{0};
    if (!read_pair(text, ',', place)) fail_at(line, in_quotes(text) + " is not a pixel", "X,Y as in 640,360");
    return place;
}

glm::ivec2 read_place(std::string_view text, int line, PictureSize picture) {
    const glm::ivec2 place = read_place(text, line);
    if (place.x < 0 || place.y < 0 || place.x >= picture.width || place.y >= picture.height)
        fail_at(line, in_quotes(text) + " is outside the picture",
                fmt::format("0 to {}, 0 to {}", picture.width - 1, picture.height - 1));
    return place;
}

double read_decimal(std::string_view text, int line) {
    double value = 0;
    if (!read_all(text, value) || !std::isfinite(value))
        fail_at(line, in_quotes(text) + " is not a number", "a number");
    return value;
}

int read_whole(std::string_view text, int line, int least, int most) {
    int value = 0;
    if (read_all(text, value) && value >= least && value <= most) return value;
    const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
    const bool whole = !digits.empty() && digits.find_first_not_of("0123456789") == digits.npos;
    fail_at(line, in_quotes(text) + (whole ? " is out of range" : " is not a whole number"),
            fmt::format("{} to {}", least, most));
}

PictureSize read_lesson_size(std::string_view text, int line) {
    glm::ivec2 size{0};
    const bool read = read_pair(text, 'x', size);
    const auto fits = [](int side) { return side >= 1 && side <= max_lesson_side; };
    if (!read || !fits(size.x) || !fits(size.y))
        fail_at(line, in_quotes(text) + " is not a size",
                fmt::format("WIDTHxHEIGHT as in 640x360, at most {0}x{0}", max_lesson_side));
    return {size.x, size.y};
}

Assignment read_set(const BlockLine& line) {
    Result<Assignment> read = parse_assignment(line.value);
    if (const Problem* problem = problem_of(read)) fail_at(line.line, problem->what, problem->expected);
    return std::get<Assignment>(std::move(read));
}

Expression read_expression(const BlockLine& line, const std::vector<LessonRun>& runs,
                           const std::vector<std::string>& variables) {
    Result<Expression> read = Expression::parse(line.value);
    if (const Problem* problem = problem_of(read)) fail_at(line.line, problem->what, problem->expected);
    Expression expression = std::get<Expression>(std::move(read));
    std::vector<std::string> known = variables;
    for (const LessonRun& run : runs) known.push_back(run.name);
    for (const std::string& name : expression.names())
        if (std::find(known.begin(), known.end(), name) == known.end())
            fail_at(line.line, in_quotes(name) + " is not known",
                    known.empty() ? "a run above it, as in e = explain --pixel 640,360"
                                  : in_quotes(nearest(name, known)));
    return expression;
}

}  // namespace glint
