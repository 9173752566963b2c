#pragma once
// The one thing we need to know of UTF-8: where a character ends, and whether it is one.
// Source: The Unicode Standard, table 3-7 "Well-Formed UTF-8 Byte Sequences".

#include <cstddef>
#include <string_view>

namespace glint {

/// Bytes of the well-formed character at the start of `text`, 1 to 4; 0 when there is none (empty text, a
/// stray or missing continuation byte, an overlong form, a surrogate, a value above U+10FFFF).
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// Place of the first byte that is no part of a well-formed character; text.size() when all are.
[[nodiscard]] std::size_t first_invalid_utf8(std::string_view text);

}  // namespace glint
