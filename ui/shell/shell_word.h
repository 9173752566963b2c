#pragma once
// Text as one word of a POSIX shell, for commands to copy.

#include <string>

namespace glint {

/// Returns the text as it is when that is safe, else in single quotes.
[[nodiscard]] inline std::string shell_word(const std::string& text) {
    constexpr const char* safe = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,:=+@%-";
    if (!text.empty() && text.find_first_not_of(safe) == std::string::npos) return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

}  // namespace glint
