#pragma once
// The syntax of a lesson's file: headings, text, and fenced blocks of `key: value` lines. Only for lessons/.
// Functions here throw ProblemFound (models/problem.h) without a file.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"

namespace glint {

/// `key: value`, or `name = run`, with the indented lines after it.
struct BlockLine {
    std::string key, value;
    int line = 0;  // in the file, from 1
    bool is_run = false;
};

/// ```word kind
struct SourceBlock {
    std::string word, kind;
    std::vector<BlockLine> lines;
    int line = 0;  // of its fence

    /// Throws if a line's key is not one of these or has no value, or if there are runs and none are allowed.
    void allow(const std::vector<std::string>& keys, bool runs) const;
    /// The only line of that key, or null; throws if there are several.
    [[nodiscard]] const BlockLine* find(std::string_view key) const;
    [[nodiscard]] const BlockLine& require(std::string_view key) const;
    [[nodiscard]] std::vector<const BlockLine*> all(std::string_view key) const;
};

/// A heading of the first or second level, text, or a block.
struct SourceHeading {
    int level = 1, line = 0;
    std::string text;
};
using SourcePart = std::variant<SourceHeading, ProseBlock, SourceBlock>;

/// The parts in the order of the file. The text is valid UTF-8.
[[nodiscard]] std::vector<SourcePart> lesson_source(std::string_view text);

/// The first words of the fenced blocks that a lesson may have.
[[nodiscard]] const std::vector<std::string>& lesson_block_words();

/// Parses the lines of a block. `texts` are its lines in the file, the first one at `line`.
[[nodiscard]] std::vector<BlockLine> block_lines(const std::vector<std::string>& texts, int line);

/// Throws the problem of a line. Does not return.
[[noreturn]] void fail_at(int line, std::string what, std::string expected);

/// Two integers separated by a comma: a pixel. The second form throws if it is outside the picture.
[[nodiscard]] glm::ivec2 read_place(std::string_view text, int line);
[[nodiscard]] glm::ivec2 read_place(std::string_view text, int line, PictureSize picture);
[[nodiscard]] double read_decimal(std::string_view text, int line);
/// Decimal digits within [least, most].
[[nodiscard]] int read_whole(std::string_view text, int line, int least, int most);
/// "640x360", each side 1 to max_lesson_side.
[[nodiscard]] PictureSize read_lesson_size(std::string_view text, int line);
[[nodiscard]] Assignment read_set(const BlockLine& line);
[[nodiscard]] Expression read_expression(const BlockLine& line, const std::vector<LessonRun>& runs,
                                         const std::vector<std::string>& variables = {});
/// The words of a text, split at spaces.
[[nodiscard]] std::vector<std::string> words_of(std::string_view text);

/// Reads the runs of a block. Each has its own name; compare names earlier runs of render.
[[nodiscard]] std::vector<LessonRun> read_runs(const std::vector<BlockLine>& lines);

/// Reads all lines of that key.
[[nodiscard]] std::vector<Assignment> read_sets(const SourceBlock& block, std::string_view key);

/// Reads a block other than "lesson" and "scene". `picture`: the lesson's, for the range of pixels.
[[nodiscard]] LessonPart read_part(const SourceBlock& block, PictureSize picture);

/// Reads an exercise's block, and tries it with the first value of each variable.
[[nodiscard]] Exercise read_exercise(const SourceBlock& block);

}  // namespace glint
