#pragma once
// What is wrong with something a user gave us, as a value: one line that says where, what, and what was
// expected. Source: docs/interface.md, "Errors and warnings".

#include <string>
#include <string_view>
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

/// Things that were tolerated, one line a kind with its count, in the order in which they were met.
using Warnings = std::vector<std::string>;

/// A name from a file, for a line of text: valid UTF-8, its control characters written as \n, \t or \x1b.
[[nodiscard]] std::string on_one_line(std::string_view raw);

/// The candidate nearest to `word` by edit distance, capitals or not, for "did you mean"; of equals the one
/// whose capitals agree, then the first. Empty when there are no candidates.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// Appends "COUNT one" or "COUNT many" unless the count is 0.
void warn(Warnings& warnings, std::size_t count, std::string_view one, std::string_view many);

}  // namespace glint
