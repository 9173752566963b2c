#pragma once
// Self-contained HTML pages of lessons, for screen and print.

#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"

namespace glint {

/// A complete page. `body` is HTML, `title` is text.
[[nodiscard]] std::string page_html(std::string_view title, std::string_view body);

/// A line of a lesson as HTML, with subscripts: k_d becomes k with a subscript d.
[[nodiscard]] std::string lesson_html(std::string_view text);

/// Replaces one-letter names with a one-letter index, such as k_d, by `form`, whose arguments are the two
/// letters: `{0}<sub>{1}</sub>`. `underline` separates them in the text.
[[nodiscard]] std::string with_indices(std::string_view text, std::string_view underline,
                                       const std::string& form);

/// Text of a lesson as HTML. Omits quotes that begin with "In the window".
[[nodiscard]] std::string prose_html(const std::vector<ProseBlock>& blocks);

}  // namespace glint
