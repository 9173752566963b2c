// Reads PNG files written by any program.
#include <fmt/core.h>
#include <png.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/io/file.h"
#include "renderer/image/image_file.h"

namespace glint {
namespace {

// The size of an incompressible picture of maximum size with 16 bits per channel.
constexpr std::size_t max_png_bytes = std::size_t{9} * max_picture_side * max_picture_side;
// Deflate expands a byte to at most 1032 bytes, so a larger declared size is invalid (zlib, "Technical
// Details").
constexpr std::size_t max_inflation = 1032;

Problem unreadable(const std::string& path, const std::string& what) {
    return {.file = path, .pointer = {}, .what = what, .expected = "a PNG picture of 1x1 to 16384x16384"};
}

/// An error message of libpng about an invalid file.
struct PngFault {
    std::string what;
};

/// Reads a picture with libpng from `bytes`, which must outlive this object. Throws PngFault and
/// std::bad_alloc. Does not use png_image, libpng's simpler reader, which misreads interlaced files when
/// converting 16 bits to 8 (observed with Debian 12's 1.6.39).
class PngReader {
  public:
    explicit PngReader(std::string_view bytes)
        : rest_(bytes), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, give_up, ignore)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png_, &rest_, take);
        // Apart from the pixels, reads only the transparent colour (tRNS). Pictures are compared by their
        // stored bytes, regardless of the declared colour encoding.
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_AS_DEFAULT,
                                    reinterpret_cast<png_const_bytep>("tRNS"), 1);
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

    /// Reads everything before the pixels.
    void read_header() { png_read_info(png_, info_); }
    [[nodiscard]] std::size_t width() const { return png_get_image_width(png_, info_); }
    [[nodiscard]] std::size_t height() const { return png_get_image_height(png_, info_); }

    /// Converts any format to red, green, blue and alpha of 8 bits each. Requires read_header().
    void read_rows(std::vector<std::uint8_t>& rgba) {
        png_set_expand(png_);
        png_set_scale_16(png_);
        png_set_gray_to_rgb(png_);
        png_set_add_alpha(png_, 255, PNG_FILLER_AFTER);
        (void)png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        const std::size_t stride = 4 * width();
        if (png_get_rowbytes(png_, info_) != stride || rgba.size() != stride * height())
            throw PngFault{"its rows have another length"};
        std::vector<png_bytep> rows(height());
        for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = &rgba[y * stride];
        png_read_image(png_, rows.data());
    }

  private:
    [[noreturn]] static void give_up(png_structp, png_const_charp what) { throw PngFault{what}; }
    static void ignore(png_structp, png_const_charp) {}
    static void take(png_structp png, png_bytep data, std::size_t size) {
        auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
        if (size > rest.size()) throw PngFault{"read beyond end of data"};
        rest.copy(reinterpret_cast<char*>(data), size);
        rest.remove_prefix(size);
    }

    std::string_view rest_;
    png_structp png_;
    png_infop info_ = nullptr;
};

Problem unreadable(const std::string& path, const PngFault& fault) {
    return unreadable(path, "cannot be read as a PNG (" + fault.what + ")");
}

/// The problem with a file that does not begin with a PNG signature.
Problem not_a_png(std::string_view bytes, const std::string& path) {
    try {
        PngReader(bytes).read_header();
    } catch (const PngFault& fault) {
        return unreadable(path, fault);
    }
    return unreadable(path, "cannot be read as a PNG");
}

/// Checks the first block before the rest of the file is read.
std::optional<Problem> check_first_block(const FileBlock& block, const std::string& path) {
    constexpr std::size_t signature_bytes = 8;
    if (block.at > 0) return {};
    const auto* first = reinterpret_cast<png_const_bytep>(block.bytes.data());
    if (png_sig_cmp(first, 0, std::min(signature_bytes, block.bytes.size())) != 0)
        return not_a_png(block.bytes, path);
    return {};
}

}  // namespace

Result<Picture> read_png(const std::string& path) {
    const auto check = [&](const FileBlock& block) { return check_first_block(block, path); };
    const auto file = read_file(path, max_png_bytes, check);
    if (const Problem* problem = problem_of(file)) return *problem;
    const std::string& bytes = std::get<std::string>(file);
    if (bytes.empty()) return unreadable(path, "is empty");

    try {
        PngReader png(bytes);
        png.read_header();
        const std::size_t width = png.width(), height = png.height(), pixels = width * height;
        if (width > max_picture_side || height > max_picture_side)
            return unreadable(path, fmt::format("has {}x{} pixels", width, height));
        // A PNG has at least one bit per pixel.
        if (pixels / 8 > max_inflation * bytes.size())
            return unreadable(path, "claims more pixels than it can hold");
        Picture picture{{static_cast<int>(width), static_cast<int>(height)}, {}, {}};
        picture.rgba.resize(4 * pixels);
        png.read_rows(picture.rgba);
        return picture;
    } catch (const PngFault& fault) {
        return unreadable(path, fault);
    }
}

}  // namespace glint
