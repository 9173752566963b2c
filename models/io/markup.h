#pragma once
// Encodes text and bytes for use in a page (HTML) or in a paper (LaTeX).

#include <string>
#include <string_view>

namespace glint {

/// Escapes HTML's special characters, for text and for attributes in double quotes, and keeps the text on one
/// line.
[[nodiscard]] std::string html_escaped(std::string_view text);

/// Escapes LaTeX's special characters and keeps the text on one line: an empty line would end an equation.
[[nodiscard]] std::string latex_escaped(std::string_view text);

/// Encodes bytes in base64 (RFC 4648, section 4).
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace glint
