#include <ft2build.h>

#include "renderer/image/sheet.h"
#include FT_FREETYPE_H

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

namespace glint {
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
        "a TrueType font, as of the package fonts-dejavu-core, or its path in GLINT_FONT";
    if (path.empty()) return Problem{"font", "", "no font was found to write labels with", expected, 0};
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
