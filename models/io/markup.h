#pragma once
// Text and bytes as they may stand in a page (HTML) or in a paper (LaTeX).

#include <string>
#include <string_view>

namespace glint {

/// One line of text, in which HTML's special characters stand for themselves, in attributes too.
[[nodiscard]] std::string html_escaped(std::string_view text);

/// LaTeX's special characters stand for themselves, and the text stays on its line: an empty one would end
/// an equation.
[[nodiscard]] std::string latex_escaped(std::string_view text);

/// RFC 4648, section 4.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace glint
