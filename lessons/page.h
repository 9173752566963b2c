#pragma once
// Self-contained HTML pages of lessons, for a screen and for paper.

#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"

namespace glint {

/// A complete page. `body` is HTML, `title` is text.
[[nodiscard]] std::string page_html(std::string_view title, std::string_view body);

/// Text of a lesson as HTML.
[[nodiscard]] std::string prose_html(const std::vector<ProseBlock>& blocks);

}  // namespace glint
