#pragma once
// A problem with user input, as a value: one line with the location, the error, and the expected text.
// Source: docs/command_line.md, "Errors and warnings".

#include <exception>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace glint {

struct Problem {
    std::string file;      // the file as the user named it, an option such as "--pixel", or empty
    std::string pointer;   // JSON pointer (RFC 6901) into a scene, or empty
    std::string what;      // the error
    std::string expected;  // the expected input, without the word "expected"; or empty
    int line = 0;          // counted from 1; 0 if unknown
    bool operator==(const Problem&) const = default;

    /// `FILE[:LINE][: POINTER]: WHAT; expected EXPECTED`, without the leading `glint: error: `. Always one
    /// line of valid UTF-8, at most 4096 bytes with that prefix and a newline: control characters and invalid
    /// bytes are escaped (\n, \t, \x1b); long text is truncated with an ellipsis, `what` before the others.
    [[nodiscard]] std::string text() const;
};

/// `what; expected expected`; `what` alone if `expected` is empty.
[[nodiscard]] std::string with_expected(const std::string& what, const std::string& expected);

/// A value, or the problem that prevented it.
template <class T> using Result = std::variant<T, Problem>;

/// The problem of a result, or null.
template <class T> [[nodiscard]] const Problem* problem_of(const Result<T>& result) {
    return std::get_if<Problem>(&result);
}

// Nested readers throw; a public function returns a Result (result_of).

struct ProblemFound : std::exception {
    explicit ProblemFound(Problem found) : problem(std::move(found)) {}
    [[nodiscard]] const char* what() const noexcept override { return problem.what.c_str(); }

    Problem problem;
};

/// Returns the value of a result, or throws its problem.
template <class T> [[nodiscard]] T value_or_throw(Result<T> result) {
    if (auto* problem = std::get_if<Problem>(&result)) throw ProblemFound(std::move(*problem));
    return std::get<T>(std::move(result));
}

template <class T> struct AsResult { using Type = Result<T>; };
template <class T> struct AsResult<Result<T>> { using Type = Result<T>; };

/// Returns the value or the Result that `read` returns, or the problem that `read` throws, with `file` added
/// if the problem names no file.
template <class Read>
[[nodiscard]] auto result_of(const std::string& file, const Read& read) ->
    typename AsResult<std::invoke_result_t<Read>>::Type {
    try {
        return read();
    } catch (ProblemFound& found) {
        if (found.problem.file.empty()) found.problem.file = file;
        return std::move(found.problem);
    }
}

/// Warnings about tolerated input, one line per kind with its count, in the order of first occurrence.
using Warnings = std::vector<std::string>;

/// A name from a file, for use in a line of text: valid UTF-8, with control characters written as \n, \t or
/// \x1b.
[[nodiscard]] std::string on_one_line(std::string_view raw);

/// The candidate nearest to `word` by edit distance, ignoring case, for "did you mean". Ties are decided by
/// matching case, then by order. Empty if there are no candidates.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// Returns the text truncated to `max` characters, with an ellipsis if it is truncated: for a value within a
/// message.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t max = 40);
/// shortened(text) in double quotes.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The line of the byte at `place` in a text, from 1.
[[nodiscard]] int line_of(std::string_view text, std::size_t place);

/// Collects warnings, each distinct line once, in order. A file may cause any number of warnings. Counts the
/// lines after the first hundred without storing them.
class WarningList {
  public:
    static constexpr std::size_t max_lines = 100;

    void add(const std::string& line);
    /// Returns all warnings and clears the list.
    [[nodiscard]] Warnings take();

  private:
    Warnings first_;
    std::unordered_set<std::size_t> known_;  // hashes: lines may be long
};

/// Appends "COUNT one" or "COUNT many" unless the count is 0.
void warn(Warnings& warnings, std::size_t count, std::string_view one, std::string_view many);

}  // namespace glint
