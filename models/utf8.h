#pragma once
// Checks UTF-8 (character boundaries, well-formedness), and encodes arbitrary bytes, such as those of file
// names, as valid UTF-8. Source: The Unicode Standard, table 3-7 "Well-Formed UTF-8 Byte Sequences".

#include <cstddef>
#include <string>
#include <string_view>

namespace glint {

/// U+FEFF, which some programs write at the start of a text file.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
[[nodiscard]] inline std::string_view without_byte_order_mark(std::string_view text) {
    return text.substr(text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
}

/// Whether a byte of UTF-8 continues the character of the byte before it.
[[nodiscard]] inline bool continues_character(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80;
}

/// Bytes of the well-formed character at the start of `text`, 1 to 4; 0 if there is none (empty text, a stray
/// or missing continuation byte, an overlong form, a surrogate, a value above U+10FFFF).
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// Returns the number of characters of the text; a byte that does not begin one counts as one.
[[nodiscard]] std::size_t count_characters(std::string_view text);
/// Returns the first `count` characters of the text, or all of it if it has fewer.
[[nodiscard]] std::string_view first_characters(std::string_view text, std::size_t count);

/// True for characters that move the cursor, break the line or reverse its direction: C0, DEL, C1, the line
/// and paragraph separators (U+2028 and 2029), and the directional formatting characters (U+202A to 202E and
/// 2066 to 2069). `character`: a well-formed one.
[[nodiscard]] bool is_control(std::string_view character);

/// The code point of a well-formed character: 0xE9 for "é".
[[nodiscard]] char32_t code_point(std::string_view character);

/// The position of the first byte that is not part of a well-formed character; text.size() if there is none.
[[nodiscard]] std::size_t first_invalid_utf8(std::string_view text);

/// Returns the text with U+FFFD for each byte that is not part of a well-formed character.
[[nodiscard]] std::string with_invalid_replaced(std::string_view text);

/// Returns any bytes as UTF-8 from which unescaped_bytes() restores them. A byte b that is not part of a
/// well-formed character (so b >= 0x80) becomes the character U+EF00 + b of the private use area. Bytes of a
/// character that is already in that range (U+EF80 to U+EFFF) are replaced in the same way. Other text is
/// unchanged. Source: MirBSD's OPTU-8.
[[nodiscard]] std::string escaped_bytes(std::string_view bytes);
[[nodiscard]] std::string unescaped_bytes(std::string_view text);

// Encodes text and bytes for use in a page (HTML) or in a paper (LaTeX).

/// Escapes HTML's special characters, for text and for attributes in double quotes, and keeps the text on one
/// line.
[[nodiscard]] std::string html_escaped(std::string_view text);

/// Escapes LaTeX's special characters and keeps the text on one line: an empty line would end an equation.
[[nodiscard]] std::string latex_escaped(std::string_view text);

/// Encodes bytes in base64 (RFC 4648, section 4).
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace glint
