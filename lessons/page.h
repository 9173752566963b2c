#pragma once
// Self-contained HTML pages of lessons, for a screen and for paper.

#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"

namespace glint {

/// A complete page. `body` is HTML, `title` is text.
[[nodiscard]] std::string page_html(std::string_view title, std::string_view body);

/// A line of a lesson as HTML, with indices: k_d is k with a small d.
[[nodiscard]] std::string lesson_html(std::string_view text);

/// Replaces the name before an index and the index, one letter each, such as k_d, by `form` of the two
/// letters: `{0}<sub>{1}</sub>`. `underline` is between them in the text.
[[nodiscard]] std::string with_indices(std::string_view text, std::string_view underline,
                                       const std::string& form);

/// Text of a lesson as HTML. A quote that begins with "In the window" is not printed.
[[nodiscard]] std::string prose_html(const std::vector<ProseBlock>& blocks);

}  // namespace glint
