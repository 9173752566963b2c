#pragma once
// A labelled grid of pictures over two parameters, as the lecture shows spheres over light and n_shiny.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

// Words on a picture, set with FreeType in a font of the system.

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

/// What varies along the rows or the columns: `name=a,b,c`.
struct SheetAxis {
    std::string pointer;              // RFC 6901; its last token is the heading's name
    std::vector<std::string> values;  // each a JSON value or a word, as written
};

/// "POINTER=A,B,C" split at the commas that are not inside [], {} or a string. A problem with `option` for
/// its file when there is no '=', no leading '/', or a value is empty.
[[nodiscard]] Result<SheetAxis> parse_axis(const std::string& option, const std::string& text);

/// At most this many pictures a sheet.
inline constexpr std::size_t max_sheet_cells = 1024;

/// The grid's whole size, headings included. A side can be above what a picture may have.
[[nodiscard]] PictureSize sheet_size(const SheetAxis& rows, const SheetAxis& columns, PictureSize cell,
                                     const Font& font);

/// Draws the sheet. draw(row, column) returns the picture of one cell, of size `cell`, and is called row by
/// row. Text is dark on white: each column has its name and value above it, each row at its left; text that
/// is too long ends in an ellipsis.
[[nodiscard]] Picture make_sheet(const SheetAxis& rows, const SheetAxis& columns, PictureSize cell,
                                 const Font& font,
                                 const std::function<const Picture&(std::size_t, std::size_t)>& draw);

}  // namespace glint
