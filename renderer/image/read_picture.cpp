#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <fmt/core.h>
#include <openexr.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/io/file.h"
#include "renderer/image/exr_stream.h"
#include "renderer/image/image_file.h"

namespace glint {

// Reads PNG files written by any program.

namespace {

// The size of an incompressible picture of maximum size with 16 bits per channel.
constexpr std::size_t max_png_bytes = std::size_t{9} * max_picture_side * max_picture_side;
// Deflate expands a byte to at most 1032 bytes, so a larger declared size is invalid (zlib, "Technical
// Details").
constexpr std::size_t max_inflation = 1032;

Problem unreadable(const std::string& path, const std::string& what) {
    return {.file = path, .pointer = {}, .what = what, .expected = "a PNG picture of 1x1 to 16384x16384"};
}

/// An error message from libpng about an invalid file.
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
            throw PngFault{"its rows have a different length"};
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
            return unreadable(path, "claims more pixels than it can contain");
        Picture picture{{static_cast<int>(width), static_cast<int>(height)}, {}, {}};
        picture.rgba.resize(4 * pixels);
        png.read_rows(picture.rgba);
        return picture;
    } catch (const PngFault& fault) {
        return unreadable(path, fault);
    }
}

// Reads linear float pictures, PFM and OpenEXR, written by other programs.

namespace {

constexpr std::size_t max_linear_bytes = std::size_t{17} * max_picture_side * max_picture_side;

Problem unreadable(const std::string& path, const std::string& what, const char* format) {
    return {path, {}, what, std::string(format) + " picture of 1x1 to 16384x16384"};
}

bool fits(long long width, long long height) {
    return width >= 1 && height >= 1 && width <= max_picture_side && height <= max_picture_side;
}

/// A black linear picture of the given size.
Picture empty_linear(long long width, long long height) {
    Picture picture{{static_cast<int>(width), static_cast<int>(height)}, {}, {}};
    picture.linear.resize(3 * picture.size.pixels());
    return picture;
}

/// The fields of a PFM header and the offset of its pixel data.
struct PfmHeading {
    int channels = 0;
    long long width = 0, height = 0;
    float scale = 0;  // negative: little-endian
    std::size_t end = 0;
};

template <class Number> bool read_number(std::string_view word, Number& number) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc{} && end == word.data() + word.size();
}

std::optional<PfmHeading> pfm_heading(std::string_view bytes) {
    constexpr std::string_view spaces = " \t\r\n";
    std::array<std::string_view, 4> words;
    std::size_t at = 0;
    for (std::string_view& word : words) {
        at = bytes.find_first_not_of(spaces, at);
        const std::size_t end = bytes.find_first_of(spaces, at);
        if (at == bytes.npos || end == bytes.npos) return std::nullopt;
        word = bytes.substr(at, end - at);
        at = end;
    }
    PfmHeading heading;
    heading.end = at + 1;  // exactly one whitespace character follows the last word
    heading.channels = words[0] == "PF" ? 3 : words[0] == "Pf" ? 1 : 0;
    const bool numbers = read_number(words[1], heading.width) && read_number(words[2], heading.height) &&
                         read_number(words[3], heading.scale);
    if (!numbers || heading.channels == 0 || heading.scale == 0 || !std::isfinite(heading.scale))
        return std::nullopt;
    return heading;
}

float pfm_number(const char* at, bool little) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, at, sizeof bits);
    if (!little) bits = bits >> 24 | (bits >> 8 & 0xFF00u) | (bits << 8 & 0xFF0000u) | bits << 24;
    return std::bit_cast<float>(bits);
}

/// Throws if a list of channels is too long: the library's reader takes quadratic time, 17 s for 100,000
/// channels. Source of the layout: "OpenEXR File Layout", header attributes.
void require_short_channel_lists(std::string_view bytes) {
    constexpr std::size_t longest = 256 << 10;  // about 5,000 channels, which take a tenth of a second
    constexpr std::size_t begin = 8;            // after the magic number and the version
    const bool has_parts = bytes.size() > begin && (static_cast<unsigned char>(bytes[5]) & 0x10) != 0;
    for (std::size_t at = begin; at < bytes.size();) {
        const std::size_t name_end = bytes.find('\0', at);
        if (name_end == at) {  // the end of one part's header or of all headers
            if (!has_parts || bytes.substr(at + 1).starts_with('\0')) return;
            ++at;
            continue;
        }
        const std::size_t type_end = bytes.find('\0', std::min(name_end, bytes.size() - 1) + 1);
        if (type_end == bytes.npos || bytes.size() - type_end < 5) return;  // the library reports the error
        std::uint32_t size = 0;
        std::memcpy(&size, bytes.data() + type_end + 1, sizeof size);
        if (bytes.substr(name_end + 1, type_end - name_end - 1) == "chlist" && size > longest)
            throw std::runtime_error("its list of channels is larger than 256 KiB");
        at = type_end + 5 + size;
    }
}

/// Returns the number of rows that are compressed together, or 0 for a tiled file. Throws if the header is
/// invalid or declares more data than the file contains. The library's pixel reader allocates everything that
/// the header declares before it notices missing data: gigabytes for a file of 300 bytes. The part of the
/// library used here does not.
int sound_rows_of_block(const std::string& bytes) {
    exr_context_initializer_t source = EXR_DEFAULT_CONTEXT_INITIALIZER;
    source.user_data = const_cast<std::string*>(&bytes);  // not modified
    source.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {
    };  // the default handler prints messages
    source.size_fn = [](exr_const_context_t, void* file) {
        return static_cast<std::int64_t>(static_cast<const std::string*>(file)->size());
    };
    source.read_fn = [](exr_const_context_t, void* file, void* to, std::uint64_t count, std::uint64_t at,
                        exr_stream_error_func_ptr_t) {
        const auto& all = *static_cast<const std::string*>(file);
        const std::string_view rest =
            std::string_view(all).substr(std::min<std::size_t>(at, all.size()), count);
        std::memcpy(to, rest.data(), rest.size());
        return static_cast<std::int64_t>(rest.size());
    };
    source.max_image_width = source.max_image_height = max_picture_side;
    exr_context_t context = nullptr;
    const exr_result_t result = exr_start_read(&context, "picture", &source);
    std::int32_t rows = 0;
    if (result == EXR_ERR_SUCCESS && exr_get_scanlines_per_chunk(context, 0, &rows) != EXR_ERR_SUCCESS)
        rows = 0;
    exr_finish(&context);
    if (result != EXR_ERR_SUCCESS) throw std::runtime_error(exr_get_default_error_message(result));
    return rows;
}

/// Throws if a block of the picture, or a tile of its largest level, is missing at its offset. The library
/// would notice that only after it has filled the memory for all pixels.
void require_all_blocks(Imf::InputFile& file, int rows) {
    const Imath::Box2i window = file.header().dataWindow();
    const char* block = nullptr;
    int size = 0;
    if (rows > 0) {
        for (std::int64_t y = window.min.y; y <= window.max.y; y += rows) {
            int first = static_cast<int>(y);
            file.rawPixelData(first, block, size);
        }
        return;
    }
    const Imf::TileDescription& tile = file.header().tileDescription();
    const std::int64_t across = (1LL + window.max.x - window.min.x + tile.xSize - 1) / tile.xSize;
    const std::int64_t down = (1LL + window.max.y - window.min.y + tile.ySize - 1) / tile.ySize;
    for (std::int64_t i = 0; i < across * down; ++i) {
        int x = static_cast<int>(i % across), y = static_cast<int>(i / across), level_x = 0, level_y = 0;
        file.rawTileData(x, y, level_x, level_y, block, size);
    }
}

/// Crops or pads the pixels of an EXR's data window to its display window. A renderer may store only the
/// pixels that are not black, or more pixels than it displays.
Picture displayed_part(Picture stored, const Imath::Box2i& data, const Imath::Box2i& display) {
    if (data == display) return stored;
    Picture shown = empty_linear(1LL + display.max.x - display.min.x, 1LL + display.max.y - display.min.y);
    const int left = std::max(data.min.x, display.min.x), right = std::min(data.max.x, display.max.x);
    for (int y = std::max(data.min.y, display.min.y); y <= std::min(data.max.y, display.max.y); ++y) {
        if (left > right) break;
        const float* const from = &stored.linear[3 * stored.pixel(left - data.min.x, y - data.min.y)];
        std::copy_n(from, 3 * (right - left + 1),
                    &shown.linear[3 * shown.pixel(left - display.min.x, y - display.min.y)]);
    }
    return shown;
}

/// Whether the display window is so much larger than the data window that a small file would need gigabytes.
bool is_nearly_empty(const Imath::Box2i& data, const Imath::Box2i& display) {
    constexpr double harmless = 4096.0 * 4096, most = 64;  // in pixels; as a ratio to the stored pixels
    const auto pixels = [](const Imath::Box2i& box) {
        return (1.0 + box.max.x - box.min.x) * (1.0 + box.max.y - box.min.y);
    };
    return pixels(display) > std::max(harmless, most * pixels(data));
}

/// Throws the library's exception if the file is incomplete.
Result<Picture> read_exr_bytes(const std::string& bytes, const std::string& path) {
    require_short_channel_lists(bytes);
    const int rows = sound_rows_of_block(bytes);
    ExrSource source(bytes);
    Imf::InputFile file(source, 0);
    const Imath::Box2i window = file.header().dataWindow(), display = file.header().displayWindow();
    const long long width = 1LL + window.max.x - window.min.x, height = 1LL + window.max.y - window.min.y;
    if (!fits(width, height) ||
        !fits(1LL + display.max.x - display.min.x, 1LL + display.max.y - display.min.y))
        return unreadable(path, "has a size out of range", "an OpenEXR");
    if (is_nearly_empty(window, display))
        return Problem{
            path, "",
            fmt::format("shows {}x{} pixels and contains {}x{} of them", 1LL + display.max.x - display.min.x,
                        1LL + display.max.y - display.min.y, width, height),
            "at most 64 times as many, or 4096x4096"};
    const Imf::ChannelList& channels = file.header().channels();
    const bool grey = channels.findChannel("R") == nullptr;
    if (grey && channels.findChannel("Y") == nullptr)
        return unreadable(path, "has neither the channels R, G, B nor Y", "an OpenEXR");
    for (const char* const chroma : {"RY", "BY", "X", "Z"})
        if (grey && channels.findChannel(chroma) != nullptr)
            return Problem{path, "", fmt::format("has the channel {} next to Y but no R, G, B", chroma),
                           "the channels R, G, B, or Y alone for grey"};
    for (const char* const name : {"R", "G", "B", "Y"})
        if (const Imf::Channel* channel = channels.findChannel(name);
            channel != nullptr && (channel->xSampling != 1 || channel->ySampling != 1))
            return Problem{path, "", fmt::format("has a subsampled channel {}", name),
                           "every pixel in every channel"};
    require_all_blocks(file, rows);
    Picture picture = empty_linear(width, height);
    const std::size_t pixel = 3 * sizeof(float), row = pixel * static_cast<std::size_t>(width);
    const auto before =
        static_cast<std::ptrdiff_t>(pixel) * window.min.x + static_cast<std::ptrdiff_t>(row) * window.min.y;
    Imf::FrameBuffer frame;
    const char* names[] = {grey ? "Y" : "R", "G", "B"};
    for (std::size_t c = 0; c < (grey ? 1U : 3U); ++c) {
        char* const at = reinterpret_cast<char*>(picture.linear.data() + c) - before;
        frame.insert(names[c], Imf::Slice(Imf::FLOAT, at, pixel, row));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    if (grey)
        for (std::size_t i = 0; i < picture.linear.size(); i += 3)
            picture.linear[i + 1] = picture.linear[i + 2] = picture.linear[i];
    return displayed_part(std::move(picture), window, display);
}

}  // namespace

Result<Picture> read_pfm(const std::string& path) {
    const auto file = read_file(path, max_linear_bytes);
    if (const Problem* problem = problem_of(file)) return *problem;
    const std::string& bytes = std::get<std::string>(file);
    const auto heading = pfm_heading(std::string_view(bytes).substr(0, 256));
    if (!heading) return unreadable(path, "does not begin like a PFM", "a PFM");
    if (!fits(heading->width, heading->height)) return unreadable(path, "has a size out of range", "a PFM");
    const auto channels = static_cast<std::size_t>(heading->channels);
    const auto width = static_cast<std::size_t>(heading->width);
    const auto height = static_cast<std::size_t>(heading->height);
    const std::size_t pixel_bytes = 4 * channels * width * height;
    const bool has_line_end = bytes[heading->end - 1] == '\r' && bytes[heading->end] == '\n';
    // Some programs end the header with \r\n. Skips the \n, unless the file size shows that it belongs to the
    // first pixel.
    const std::size_t first =
        heading->end + (has_line_end && bytes.size() - heading->end > pixel_bytes ? 1 : 0);
    if (bytes.size() - first < pixel_bytes) return unreadable(path, "ends too early", "a PFM");
    if (const std::size_t more = bytes.size() - first - pixel_bytes; more > 0)
        return unreadable(path, fmt::format("has {} byte{} after its last pixel", more, more == 1 ? "" : "s"),
                          "a PFM");
    Picture picture = empty_linear(heading->width, heading->height);
    const bool little = heading->scale < 0;
    for (std::size_t i = 0; i < 3 * width * height; ++i) {
        const std::size_t pixel = i / 3, row = height - 1 - pixel / width;
        const std::size_t from = channels * (row * width + pixel % width) + (channels == 3 ? i % 3 : 0);
        picture.linear[i] = pfm_number(&bytes[first + 4 * from], little);
    }
    return picture;
}

Result<Picture> read_exr(const std::string& path) {
    const auto file = read_file(path, max_linear_bytes);
    if (const Problem* problem = problem_of(file)) return *problem;
    try {
        return read_exr_bytes(std::get<std::string>(file), path);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return unreadable(path, std::string("cannot be read as an OpenEXR (") + error.what() + ")",
                          "an OpenEXR");
    }
}

}  // namespace glint
