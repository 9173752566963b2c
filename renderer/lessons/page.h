#pragma once
// Pages that lessons are printed on: HTML that needs nothing else, for a screen and for paper.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/lesson/lesson.h"
#include "models/memory_limit.h"

namespace glint {

/// The text of a page that grows, whose memory is reckoned: it repeats what a lesson says, and holds
/// pictures.
class PageText {
  public:
    /// Throws Refused.
    void operator+=(std::string_view more) {
        share_.add(memory_need(MemoryUse::Output, bytes_a_byte * more.size()));
        text_ += more;
    }
    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] std::string take() && { return std::move(text_); }

  private:
    static constexpr std::uint64_t bytes_a_byte = 3;  // room that doubles, and once more in the page
    MemoryShare share_;
    std::string text_;
};

/// A whole page. `body` is HTML, `title` is text.
[[nodiscard]] std::string page_html(std::string_view title, std::string_view body);

/// Text of a lesson as HTML.
[[nodiscard]] std::string prose_html(const std::vector<ProseBlock>& blocks);

}  // namespace glint
