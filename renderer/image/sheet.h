#pragma once
// A labelled grid of pictures over two parameters, such as the lecture's spheres over light and n_shiny.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

// Text on pictures, rendered by FreeType with a system font.

/// A scalable font. Text is UTF-8; invalid bytes are shown as U+FFFD.
class Font {
  public:
    /// Loads the file given by the environment variable GLINT_FONT, or else the first installed font among
    /// DejaVu Sans, Liberation Sans, Noto Sans and FreeSans. Returns a problem if there is none.
    [[nodiscard]] static Result<Font> find();

    Font(Font&&) noexcept;
    Font& operator=(Font&&) noexcept;
    ~Font();

    /// The advance width of the text in pixels, with kerning. `size`: pixels per em.
    [[nodiscard]] int width(std::string_view text, int size) const;
    /// The text, or its longest prefix that fits in `most` pixels followed by an ellipsis.
    [[nodiscard]] std::string fitted(std::string_view text, int size, int most) const;
    /// Draws over `picture.rgba`, with the left end of the text's baseline at (x, y). Clips at the picture's
    /// borders.
    void draw(Picture& picture, std::string_view text, int size, int x, int y, std::uint8_t grey) const;

  private:
    struct Face;
    explicit Font(std::unique_ptr<Face> face);
    std::unique_ptr<Face> face_;
};

/// The parameter that varies over the rows or columns: `name=a,b,c`.
struct SheetAxis {
    std::string pointer;              // RFC 6901; its last token is the heading's name
    std::vector<std::string> values;  // each a JSON value or a word, unparsed
};

/// Parses "POINTER=A,B,C", split at commas outside [], {} and strings. Returns a problem, with `option` as
/// its file, if the '=' or the leading '/' is missing or a value is empty.
[[nodiscard]] Result<SheetAxis> parse_axis(const std::string& option, const std::string& text);

/// The maximum number of pictures in a sheet.
inline constexpr std::size_t max_sheet_cells = 1024;

/// The total size of the grid including headings. A side may exceed the maximum side of a picture.
[[nodiscard]] PictureSize sheet_size(const SheetAxis& rows, const SheetAxis& columns, PictureSize cell,
                                     const Font& font);

/// Draws the sheet. draw(row, column) is called row by row and returns the picture of one cell, of size
/// `cell`. Text is dark on white: the name and value of a column are above it, those of a row are to its
/// left. Long text is truncated with an ellipsis.
[[nodiscard]] Picture make_sheet(const SheetAxis& rows, const SheetAxis& columns, PictureSize cell,
                                 const Font& font,
                                 const std::function<const Picture&(std::size_t, std::size_t)>& draw);

}  // namespace glint
