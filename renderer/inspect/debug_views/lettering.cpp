#include <ft2build.h>

#include "renderer/inspect/debug_views/sheet.h"
#include FT_FREETYPE_H
#include FT_MODULE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <new>
#include <vector>

#include "models/io/utf8.h"

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

/// Takes the first character off `text` and returns it.
char32_t take_character(std::string_view& text) {
    const std::string_view first = first_characters(text, 1);
    text.remove_prefix(first.size());
    return utf8_length(first) == 0 ? U'\uFFFD' : code_point(first);
}

/// Puts `grey` over the picture as far as the glyph covers each pixel.
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

/// The memory that FreeType works in. Its version 2.12 crashes or leaves letters out when it gets none. So it
/// gets from a reserve what the system refuses, and when the call is over ran_out() tells the caller to stop.
class FreeTypeMemory {
  public:
    FreeTypeMemory() : reserve_(std::size_t{256} << 10) {}
    [[nodiscard]] FT_Memory get() { return &functions_; }
    [[nodiscard]] bool ran_out() const { return used_ > 0; }

  private:
    static FreeTypeMemory& of(FT_Memory memory) { return *static_cast<FreeTypeMemory*>(memory->user); }
    static void* allocate(FT_Memory memory, long bytes) {
        const auto count = static_cast<std::size_t>(bytes);
        void* const block = std::malloc(count);  // NOLINT(cppcoreguidelines-no-malloc): as FreeType's own
        return block != nullptr ? block : of(memory).from_reserve(count);
    }
    static void release(FT_Memory memory, void* block) {
        if (!of(memory).is_in_reserve(block)) std::free(block);  // NOLINT(cppcoreguidelines-no-malloc)
    }
    static void* reallocate(FT_Memory memory, long old_bytes, long bytes, void* block) {
        void* const moved = allocate(memory, bytes);
        if (moved == nullptr) return nullptr;
        std::memcpy(moved, block, static_cast<std::size_t>(std::min(old_bytes, bytes)));
        release(memory, block);
        return moved;
    }

    void* from_reserve(std::size_t bytes) {
        constexpr std::size_t aligned = alignof(std::max_align_t);
        if (bytes > reserve_.size() - used_) return nullptr;
        void* const block = &reserve_[used_];
        used_ = std::min(reserve_.size(), (used_ + bytes + aligned - 1) / aligned * aligned);
        return block;
    }
    [[nodiscard]] bool is_in_reserve(const void* block) const {
        const std::less<const void*> before;
        return !before(block, reserve_.data()) && before(block, reserve_.data() + reserve_.size());
    }

    std::vector<std::byte> reserve_;
    std::size_t used_ = 0;
    FT_MemoryRec_ functions_{this, allocate, release, reallocate};
};

}  // namespace

struct Font::Face {
    FreeTypeMemory memory;
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    Face() = default;
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;
    ~Face() {
        if (face) FT_Done_Face(face);
        if (library) FT_Done_Library(library);
    }

    /// As FT_Init_FreeType() and FT_New_Face() do.
    [[nodiscard]] bool open(const std::string& path) {
        if (checked(FT_New_Library(memory.get(), &library)) != 0) return false;
        FT_Add_Default_Modules(library);
        FT_Set_Default_Properties(library);
        return checked(FT_New_Face(library, path.c_str(), 0, &face)) == 0 && FT_IS_SCALABLE(face);
    }

    /// Passes on the error that a call of FreeType ended with. Throws where it ran out of memory.
    [[nodiscard]] FT_Error checked(FT_Error error) const {
        if (memory.ran_out() || error == FT_Err_Out_Of_Memory) throw std::bad_alloc();
        return error;
    }

    /// Loads one character after the other and calls visit(x), x the pixels from the start; returns the
    /// width.
    int set(std::string_view text, int size, FT_Int32 flags, const std::function<void(int)>& visit) const {
        (void)checked(FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size)));
        FT_Pos x = 0;  // 1/64 pixel
        FT_UInt before = 0;
        while (!text.empty()) {
            const FT_UInt glyph = FT_Get_Char_Index(face, take_character(text));
            FT_Vector kerning{};
            if (before && glyph) FT_Get_Kerning(face, before, glyph, FT_KERNING_DEFAULT, &kerning);
            x += kerning.x;
            before = glyph;
            if (checked(FT_Load_Glyph(face, glyph, flags)) != 0) continue;
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
    // The places between characters, to cut at.
    std::vector<std::size_t> cut{0};
    for (std::string_view left = text; !left.empty(); cut.push_back(text.size() - left.size()))
        (void)take_character(left);
    std::size_t low = 0, high = cut.size() - 1;  // the first `low` characters fit, or none does
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
