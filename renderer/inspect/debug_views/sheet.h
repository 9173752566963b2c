#pragma once
// A labelled grid of pictures over two parameters, as the lecture shows spheres over light and n_shiny.

#include <functional>
#include <string>
#include <vector>

#include "models/problem.h"
#include "renderer/inspect/debug_views/lettering.h"
#include "renderer/picture.h"

namespace glint {

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

/// draw(row, column) gives the picture of one cell, of size `cell`; it is asked row by row. Dark words on
/// white: each column has its name and value above it, each row at its left; what is too long ends in an
/// ellipsis.
[[nodiscard]] Picture make_sheet(const SheetAxis& rows, const SheetAxis& columns, PictureSize cell,
                                 const Font& font,
                                 const std::function<const Picture&(std::size_t, std::size_t)>& draw);

}  // namespace glint
