#pragma once
// The syntax of a lesson file: headings, text, and fenced blocks of `key: value` lines. Internal to lessons/.
// Functions here throw ProblemFound (models/problem.h) without a file name.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"

namespace glint {

/// A fenced block, which begins with ```word kind.
struct SourceBlock {
    std::string word, kind;
    std::vector<BlockLine> lines;
    int line = 0;  // of its opening fence

    /// Throws if a line has an unknown key or no value, or if the block contains runs although `runs` is
    /// false.
    void allow(const std::vector<std::string>& keys, bool runs) const;
    /// The only line with that key, or null. Throws if there are several.
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

/// Splits a file into its parts, in file order. The text is valid UTF-8.
[[nodiscard]] std::vector<SourcePart> lesson_source(std::string_view text);

/// The block words that a lesson may use.
[[nodiscard]] const std::vector<std::string>& lesson_block_words();

/// Parses the lines of a block. `texts` are consecutive lines of the file, the first of them at `line`.
[[nodiscard]] std::vector<BlockLine> block_lines(const std::vector<std::string>& texts, int line);

/// Throws a problem at that line.
[[noreturn]] void fail_at(int line, std::string what, std::string expected);

/// Parses a pixel: two integers separated by a comma. The second overload throws if the pixel is outside the
/// picture.
[[nodiscard]] glm::ivec2 read_place(std::string_view text, int line);
[[nodiscard]] glm::ivec2 read_place(std::string_view text, int line, PictureSize picture);
[[nodiscard]] double read_decimal(std::string_view text, int line);
/// Parses a decimal integer within [least, most].
[[nodiscard]] int read_whole(std::string_view text, int line, int least, int most);
/// Parses "640x360", each side 1 to max_lesson_side.
[[nodiscard]] PictureSize read_lesson_size(std::string_view text, int line);
[[nodiscard]] Assignment read_set(const BlockLine& line);
[[nodiscard]] Expression read_expression(const BlockLine& line, const std::vector<LessonRun>& runs,
                                         const std::vector<std::string>& variables = {});
/// Splits a text into words at white space.
[[nodiscard]] std::vector<std::string> words_of(std::string_view text);

/// Reads the runs of a block. Names must be unique; compare refers to earlier render runs.
[[nodiscard]] std::vector<LessonRun> read_runs(const std::vector<BlockLine>& lines);

/// Reads all lines with that key.
[[nodiscard]] std::vector<Assignment> read_sets(const SourceBlock& block, std::string_view key);

/// Reads any block except "lesson" and "scene". `picture`: the lesson's size, for checking pixels.
[[nodiscard]] LessonPart read_part(const SourceBlock& block, PictureSize picture);

/// Reads an exercise block and checks it with the first value of each variable.
[[nodiscard]] Exercise read_exercise(const SourceBlock& block);

}  // namespace glint
