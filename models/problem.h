#pragma once
// What is wrong with something a user gave us, as a value: one line that says where, what, and what was
// expected. Source: docs/command_line.md, "Errors and warnings".

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
    std::string what;      // what is wrong
    std::string expected;  // what was expected, without that word; or empty
    int line = 0;          // from 1; 0 when not known
    bool operator==(const Problem&) const = default;

    /// `FILE[:LINE][: POINTER]: what is wrong; expected what was expected`, without the leading `glint:
    /// error: `. Always one line of valid UTF-8, at most 4096 bytes with that and a newline: control
    /// characters and invalid bytes are escaped (\n, \t, \x1b); what is too long is cut with an ellipsis,
    /// `what` before the others.
    [[nodiscard]] std::string text() const;
};

/// `what; expected expected`; `what` alone where nothing was expected.
[[nodiscard]] std::string with_expected(const std::string& what, const std::string& expected);

/// A value, or the problem that kept us from it.
template <class T> using Result = std::variant<T, Problem>;

/// The problem held by a result, or null.
template <class T> [[nodiscard]] const Problem* problem_of(const Result<T>& result) {
    return std::get_if<Problem>(&result);
}

// Nested readers throw; a public function returns a Result (result_of).

struct ProblemFound : std::exception {
    explicit ProblemFound(Problem found) : problem(std::move(found)) {}
    [[nodiscard]] const char* what() const noexcept override { return problem.what.c_str(); }

    Problem problem;
};

/// The value of a result; throws its problem.
template <class T> [[nodiscard]] T value_or_throw(Result<T> result) {
    if (auto* problem = std::get_if<Problem>(&result)) throw ProblemFound(std::move(*problem));
    return std::get<T>(std::move(result));
}

template <class T> struct AsResult { using Type = Result<T>; };
template <class T> struct AsResult<Result<T>> { using Type = Result<T>; };

/// Returns what `read` returns, a value or a result; or the problem that it throws, with `file` if the
/// problem names none.
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

/// Things that were tolerated, one line a kind with its count, in the order in which they were met.
using Warnings = std::vector<std::string>;

/// A name from a file, for a line of text: valid UTF-8, its control characters written as \n, \t or \x1b.
[[nodiscard]] std::string on_one_line(std::string_view raw);

/// The candidate nearest to `word` by edit distance, capitals or not, for "did you mean"; of equals the one
/// whose capitals agree, then the first. Empty when there are no candidates.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// Returns the text cut to `max` characters, with an ellipsis where it is cut: a value inside a message.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t max = 40);
/// shortened(text) in double quotes.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Line of the byte at `place` of a text, from 1.
[[nodiscard]] int line_of(std::string_view text, std::size_t place);

/// Collects warnings, of which a file may cause any number: each distinct line once, in their order. Of the
/// lines after the first hundred it keeps only the count.
class WarningList {
  public:
    static constexpr std::size_t max_lines = 100;

    void add(const std::string& line);
    /// Returns all of them and becomes empty.
    [[nodiscard]] Warnings take();

  private:
    Warnings first_;
    std::unordered_set<std::size_t> known_;  // hashes: lines may be long
};

/// Appends "COUNT one" or "COUNT many" unless the count is 0.
void warn(Warnings& warnings, std::size_t count, std::string_view one, std::string_view many);

}  // namespace glint
