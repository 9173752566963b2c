#pragma once
// Words on a picture, set with FreeType in a font of the system.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

/// A scalable font. Text is UTF-8; what is not UTF-8 shows as U+FFFD.
class Font {
  public:
    /// The file that the environment variable GLINT_FONT names, or the first of DejaVu Sans, Liberation Sans,
    /// Noto Sans and FreeSans that is installed. A problem when there is none.
    [[nodiscard]] static Result<Font> find();

    Font(Font&&) noexcept;
    Font& operator=(Font&&) noexcept;
    ~Font();

    /// Pixels from the start of the text to where the next character would stand; kerned. `size`: pixels to
    /// the em.
    [[nodiscard]] int width(std::string_view text, int size) const;
    /// The text, or as much of its beginning as fits in `most` pixels with an ellipsis behind it.
    [[nodiscard]] std::string fitted(std::string_view text, int size, int most) const;
    /// Draws over `picture.rgba`, the text's left end on the baseline at (x, y); what lies outside is cut
    /// off.
    void draw(Picture& picture, std::string_view text, int size, int x, int y, std::uint8_t grey) const;

  private:
    struct Face;
    explicit Font(std::unique_ptr<Face> face);
    std::unique_ptr<Face> face_;
};

}  // namespace glint
