#include "renderer/image/sheet.h"

#include <ft2build.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <new>
#include <vector>

#include "models/utf8.h"
#include FT_FREETYPE_H

namespace glint {
namespace {

constexpr std::uint8_t ink = 25, pale_ink = 110, paper = 255;

/// The last token of a pointer, or the last two if the last one is a list index: "shininess", "position 0".
std::string name_of(const std::string& pointer) {
    const std::size_t last = pointer.rfind('/');
    std::string token = pointer.substr(last + 1);
    const bool number = !token.empty() && token.find_first_not_of("0123456789") == std::string::npos;
    if (!number || last == 0) return token;
    const std::size_t before = pointer.rfind('/', last - 1);
    return pointer.substr(before + 1, last - before - 1) + " " + token;
}

/// The dimensions of a sheet in pixels, computed from the size of its cells.
struct Layout {
    int value_size, name_size;          // font sizes
    int margin, gap;                    // around the sheet; between cells
    int heading_height, heading_width;  // for the column and row headings
    PictureSize cell;

    [[nodiscard]] int left(std::size_t column) const {
        return margin + heading_width + static_cast<int>(column) * (cell.width + gap);
    }
    [[nodiscard]] int top(std::size_t row) const {
        return margin + heading_height + static_cast<int>(row) * (cell.height + gap);
    }
    /// Baselines of the two lines of a heading whose lower line ends at y.
    [[nodiscard]] int name_baseline(int value_baseline) const { return value_baseline - value_size * 5 / 4; }
};

int widest_heading(const SheetAxis& axis, const Layout& l, const Font& font) {
    int widest = font.width(name_of(axis.pointer), l.name_size);
    for (const std::string& value : axis.values) widest = std::max(widest, font.width(value, l.value_size));
    return widest;
}

Layout layout_of(const SheetAxis& rows, PictureSize cell, const Font& font) {
    Layout l{};
    l.cell = cell;
    l.value_size = std::clamp(std::min(cell.width, cell.height) / 10, 14, 40);
    l.name_size = l.value_size * 3 / 4;
    l.margin = l.value_size;
    l.gap = std::max(4, l.value_size / 2);
    l.heading_height = l.value_size * 11 / 4;
    l.heading_width = std::min(widest_heading(rows, l, font), 14 * l.value_size) + l.value_size * 3 / 4;
    return l;
}

void draw_column_heading(Picture& sheet, const Layout& l, const Font& font, const SheetAxis& axis,
                         std::size_t column) {
    const auto centred = [&](const std::string& text, int size, int baseline, std::uint8_t grey) {
        const std::string shown = font.fitted(text, size, l.cell.width);
        const int x = l.left(column) + (l.cell.width - font.width(shown, size)) / 2;
        font.draw(sheet, shown, size, x, baseline, grey);
    };
    const int baseline = l.top(0) - l.value_size * 2 / 3;
    centred(name_of(axis.pointer), l.name_size, l.name_baseline(baseline), pale_ink);
    centred(axis.values[column], l.value_size, baseline, ink);
}

void draw_row_heading(Picture& sheet, const Layout& l, const Font& font, const SheetAxis& axis,
                      std::size_t row) {
    const int right = l.left(0) - l.value_size * 3 / 4;
    const auto against_right = [&](const std::string& text, int size, int baseline, std::uint8_t grey) {
        const std::string shown = font.fitted(text, size, right - l.margin);
        font.draw(sheet, shown, size, right - font.width(shown, size), baseline, grey);
    };
    const int baseline = l.top(row) + l.cell.height / 2 + l.value_size;
    against_right(name_of(axis.pointer), l.name_size, l.name_baseline(baseline), pale_ink);
    against_right(axis.values[row], l.value_size, baseline, ink);
}

void put_cell(Picture& sheet, const Picture& cell, int left, int top) {
    for (int y = 0; y < cell.size.height; ++y)
        std::memcpy(&sheet.rgba[4 * sheet.pixel(left, top + y)], &cell.rgba[4 * cell.pixel(0, y)],
                    4 * static_cast<std::size_t>(cell.size.width));
}

PictureSize size_of(const Layout& l, const SheetAxis& rows, const SheetAxis& columns) {
    return {l.left(columns.values.size()) - l.gap + l.margin, l.top(rows.values.size()) - l.gap + l.margin};
}

}  // namespace

Result<SheetAxis> parse_axis(const std::string& option, const std::string& text) {
    const std::string expected = "POINTER=A,B,C, such as /objects/0/material/shininess=8,32,128";
    const std::size_t equals = text.find('=');
    if (text.empty() || text[0] != '/' || equals == std::string::npos)
        return Problem{option, "", "\"" + text + "\" does not give values for a pointer", expected, 0};
    SheetAxis axis{text.substr(0, equals), {""}};
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = equals + 1; i < text.size(); ++i) {
        const char c = text[i];
        if (c == ',' && depth == 0 && !in_string) {
            axis.values.emplace_back();
            continue;
        }
        axis.values.back() += c;
        if (in_string && c == '\\' && i + 1 < text.size()) axis.values.back() += text[++i];
        if (c == '"') in_string = !in_string;
        if (!in_string) depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    }
    for (const std::string& value : axis.values)
        if (value.find_first_not_of(' ') == std::string::npos)
            return Problem{option, axis.pointer, "a value is empty", expected, 0};
    return axis;
}

PictureSize sheet_size(const SheetAxis& rows, const SheetAxis& columns, PictureSize cell, const Font& font) {
    return size_of(layout_of(rows, cell, font), rows, columns);
}

Picture make_sheet(const SheetAxis& rows, const SheetAxis& columns, PictureSize cell, const Font& font,
                   const std::function<const Picture&(std::size_t, std::size_t)>& draw) {
    const Layout l = layout_of(rows, cell, font);
    Picture sheet;
    sheet.size = size_of(l, rows, columns);
    sheet.rgba.assign(4 * sheet.size.pixels(), paper);
    for (std::size_t c = 0; c < columns.values.size(); ++c) draw_column_heading(sheet, l, font, columns, c);
    for (std::size_t r = 0; r < rows.values.size(); ++r) {
        draw_row_heading(sheet, l, font, rows, r);
        for (std::size_t c = 0; c < columns.values.size(); ++c)
            put_cell(sheet, draw(r, c), l.left(c), l.top(r));
    }
    return sheet;
}

namespace {

constexpr std::array<const char*, 7> usual_fonts{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/freefont/FreeSans.ttf",
};

std::string font_path() {
    if (const char* named = std::getenv("GLINT_FONT")) return named;
    std::error_code ignored;
    for (const char* path : usual_fonts)
        if (std::filesystem::exists(path, ignored)) return path;
    return {};
}

/// Removes the first character from `text` and returns it.
char32_t take_character(std::string_view& text) {
    const std::string_view first = first_characters(text, 1);
    text.remove_prefix(first.size());
    return utf8_length(first) == 0 ? U'\uFFFD' : code_point(first);
}

/// Blends `grey` over the picture, weighted by the glyph's coverage of each pixel.
void put_glyph(Picture& picture, const FT_GlyphSlot glyph, int x, int y, std::uint8_t grey) {
    const FT_Bitmap& bitmap = glyph->bitmap;
    for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
        for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
            const int px = x + glyph->bitmap_left + column, py = y - glyph->bitmap_top + row;
            if (px < 0 || py < 0 || px >= picture.size.width || py >= picture.size.height) continue;
            const int cover = bitmap.buffer[row * bitmap.pitch + column];
            std::uint8_t* to = &picture.rgba[4 * picture.pixel(px, py)];
            for (int c = 0; c < 3; ++c)
                to[c] = static_cast<std::uint8_t>((to[c] * (255 - cover) + grey * cover + 127) / 255);
        }
    }
}

}  // namespace

struct Font::Face {
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    Face() = default;
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;
    ~Face() {
        if (face) FT_Done_Face(face);
        if (library) FT_Done_FreeType(library);
    }

    [[nodiscard]] bool open(const std::string& path) {
        return FT_Init_FreeType(&library) == 0 && FT_New_Face(library, path.c_str(), 0, &face) == 0 &&
               FT_IS_SCALABLE(face);
    }

    /// Loads each character in turn and calls visit(x), with x in pixels from the start. Returns the width.
    int set(std::string_view text, int size, FT_Int32 flags, const std::function<void(int)>& visit) const {
        FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size));
        FT_Pos x = 0;  // 1/64 pixel
        FT_UInt before = 0;
        while (!text.empty()) {
            const FT_UInt glyph = FT_Get_Char_Index(face, take_character(text));
            FT_Vector kerning{};
            if (before && glyph) FT_Get_Kerning(face, before, glyph, FT_KERNING_DEFAULT, &kerning);
            x += kerning.x;
            before = glyph;
            if (FT_Load_Glyph(face, glyph, flags) != 0) continue;
            visit(static_cast<int>(x / 64));
            x += face->glyph->advance.x;
        }
        return static_cast<int>((x + 63) / 64);
    }
};

Font::Font(std::unique_ptr<Face> face) : face_(std::move(face)) {}
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;
Font::~Font() = default;

Result<Font> Font::find() {
    const std::string path = font_path();
    const std::string expected =
        "a TrueType font, such as that of the package fonts-dejavu-core, or the path of one in GLINT_FONT";
    if (path.empty()) return Problem{"font", "", "no font was found for labels", expected, 0};
    auto face = std::make_unique<Face>();
    if (!face->open(path)) return Problem{path, "", "cannot be read as a scalable font", expected, 0};
    return Font(std::move(face));
}

int Font::width(std::string_view text, int size) const {
    return face_->set(text, size, FT_LOAD_DEFAULT, [](int) {});
}

std::string Font::fitted(std::string_view text, int size, int most) const {
    if (width(text, size) <= most) return std::string(text);
    // The positions between characters where the text may be truncated.
    std::vector<std::size_t> cut{0};
    for (std::string_view left = text; !left.empty(); cut.push_back(text.size() - left.size()))
        (void)take_character(left);
    std::size_t low = 0, high = cut.size() - 1;  // the first `low` characters fit, or no text fits
    while (low + 1 < high) {
        const std::size_t middle = (low + high) / 2;
        const bool fits = width(std::string(text.substr(0, cut[middle])) + "…", size) <= most;
        (fits ? low : high) = middle;
    }
    return std::string(text.substr(0, cut[low])) + "…";
}

void Font::draw(Picture& picture, std::string_view text, int size, int x, int y, std::uint8_t grey) const {
    face_->set(text, size, FT_LOAD_RENDER,
               [&](int at) { put_glyph(picture, face_->face->glyph, x + at, y, grey); });
}

}  // namespace glint
