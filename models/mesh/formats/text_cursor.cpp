#include "models/mesh/formats/text_cursor.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

namespace glint {

void TextCursor::fail_at(int line, std::string what, std::string expected) const {
    throw ProblemFound({file_, "", std::move(what), std::move(expected), line});
}

void TextCursor::fail_missing(std::string_view name, const char* expected) const {
    fail(fmt::format("{} is missing", name), expected);
}

void TextCursor::fail_integer() {
    const std::string_view text = word();
    const bool digits = text.find_first_not_of("-0123456789") == std::string_view::npos;
    fail(fmt::format("{} is {}", quoted_word(text), digits ? "out of range" : "not a whole number"),
         "a whole number");
}

void TextCursor::fail_too_many(const char* expected) {
    fail(fmt::format("{} is one too many", quoted_word(word())), expected);
}

/// The position after the line end at `at`. CR LF and LF CR count as one, but the CR in LF CR LF belongs to
/// CR LF.
const char* TextCursor::after_line_end(const char* at) const {
    const auto is = [this](const char* p, char c) { return p < end_ && *p == c; };
    if (*at == '\r') return at + (is(at + 1, '\n') ? 2 : 1);
    return at + (is(at + 1, '\r') && !is(at + 2, '\n') ? 2 : 1);
}

/// Skips the rest of this line and the lines that a backslash joins to it.
void TextCursor::skip_rest() {
    while (at_ < end_) {
        const char* found = std::find_if(at_, end_, is_line_end);
        const bool joined = continued_ && found > at_ && found[-1] == '\\';
        at_ = found == end_ ? end_ : after_line_end(found);
        if (found == end_) return;
        ++line_;
        if (!joined) return;
    }
}

/// At a backslash, moves past the line end that it cancels; returns false if another character follows.
bool TextCursor::skip_continuation() {
    const char* next = at_ + 1;
    if (next < end_ && !is_line_end(*next)) return false;
    if (next < end_) ++line_;
    at_ = (next < end_ ? after_line_end(next) : end_) - 1;  // the caller moves on by one
    return true;
}

/// The slow path after from_chars(): reports the error, or returns 0 for a number too small for a float. A
/// normal becomes NaN instead of an error about a number; Microsoft's libraries write "1.#IND" and "1.#QNAN".
float TextCursor::unusual_number(bool of_normal) {
    const std::string_view text = word();
    const bool plus = text.starts_with('+') && !text.starts_with("+-");
    const std::string_view digits = text.substr(plus ? 1 : 0);
    double value = 0;
    const auto [last, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = last == digits.data() + digits.size() && error != std::errc::invalid_argument;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    if (of_normal && ((whole && std::isnan(value)) || digits.find(".#") != std::string_view::npos))
        return nan;
    if (!whole || std::isnan(value)) fail(fmt::format("{} is not a number", quoted_word(text)), "a number");
    if (error == std::errc() && std::abs(value) <= max_number) return static_cast<float>(value);
    const std::size_t exponent = std::min(digits.find_first_of("eE"), digits.size());
    const bool tiny = digits.size() < 64 && digits.substr(exponent, 2).find('-') != std::string_view::npos;
    if (error == std::errc::result_out_of_range && tiny) return 0;
    if (of_normal) return nan;
    fail(fmt::format("{} is out of range", quoted_word(text)), "-1e7 to 1e7");
}

std::string quoted_word(std::string_view word) {
    constexpr std::size_t longest = 24;  // bytes; longer numbers have superfluous digits
    if (word.size() <= longest && on_one_line(word) == word) return fmt::format("\"{}\"", word);
    return fmt::format("a word of {} byte{}", word.size(), word.size() == 1 ? "" : "s");
}

}  // namespace glint
