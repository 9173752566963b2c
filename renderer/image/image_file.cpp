#include "renderer/image/image_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <fmt/core.h>
#include <fmt/format.h>
#include <gif_lib.h>
#include <png.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "models/io/file.h"
#include "models/scene_file/scene_file.h"
#include "models/utf8.h"
#include "renderer/image/exr_stream.h"

namespace glint {
namespace {

/// Writes a picture into `bytes` with libpng. The only possible failure is std::bad_alloc.
class PngWriter {
  public:
    explicit PngWriter(std::string& bytes)
        : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, give_up, ignore)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
        if (info_ == nullptr) {
            png_destroy_write_struct(&png_, nullptr);
            throw std::bad_alloc();
        }
        png_set_write_fn(png_, &bytes, append, nullptr);
    }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }

    void header(PictureSize size) {
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(size.width), static_cast<png_uint_32>(size.height),
                     8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        // Compared with libpng's defaults (level 6, the best of five filters for every row), these settings
        // took a quarter of the time on our pictures and produced files a tenth larger.
        png_set_compression_level(png_, 4);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    }
    void text(const char* keyword, std::string text) {  // UTF-8, not compressed: an iTXt chunk
        png_text chunk{};
        chunk.compression = PNG_ITXT_COMPRESSION_NONE;
        chunk.key = const_cast<png_charp>(keyword);  // libpng only reads it
        chunk.text = text.data();
        png_set_text(png_, info_, &chunk, 1);
    }
    void rows(const Picture& picture) {
        png_write_info(png_, info_);
        png_set_filler(png_, 0, PNG_FILLER_AFTER);  // four bytes per pixel in, three out
        const std::size_t stride = std::size_t{4} * static_cast<std::size_t>(picture.size.width);
        for (std::size_t at = 0; at < picture.rgba.size(); at += stride)
            png_write_row(png_, &picture.rgba[at]);
        png_write_end(png_, info_);
    }

  private:
    [[noreturn]] static void give_up(png_structp, png_const_charp) { throw std::bad_alloc(); }
    static void ignore(png_structp, png_const_charp) {}
    static void append(png_structp png, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
    }

    png_structp png_;
    png_infop info_ = nullptr;
};

}  // namespace

const char* extension_of(PictureFormat format) {
    switch (format) {
    case PictureFormat::Png:
        return ".png";
    case PictureFormat::Pfm:
        return ".pfm";
    case PictureFormat::Exr:
        return ".exr";
    }
    return "";  // not reached
}

Result<PictureFormat> picture_format(const std::string& path) {
    for (const auto format : {PictureFormat::Png, PictureFormat::Pfm, PictureFormat::Exr})
        if (lower_extension(path) == extension_of(format)) return format;
    return Problem{path, "", "cannot be written", "a name that ends in .png, .pfm or .exr"};
}

Result<Picture> read_picture(const std::string& path) {
    const Result<PictureFormat> format = picture_format(path);
    if (problem_of(format) != nullptr)
        return Problem{path, "", "cannot be read", "a picture whose name ends in .png, .pfm or .exr"};
    switch (std::get<PictureFormat>(format)) {
    case PictureFormat::Png:
        return read_png(path);
    case PictureFormat::Pfm:
        return read_pfm(path);
    case PictureFormat::Exr:
        return read_exr(path);
    }
    return Picture{};  // not reached
}

std::string picture_bytes(const Picture& picture, PictureFormat format, float exposure,
                          const std::string& scene_json) {
    switch (format) {
    case PictureFormat::Png:
        return png_bytes(picture, scene_json);
    case PictureFormat::Pfm:
        return pfm_bytes(picture, exposure);
    case PictureFormat::Exr:
        return exr_bytes(picture, exposure);
    }
    return {};  // not reached
}

std::string png_bytes(const Picture& picture, const std::string& scene_json) {
    std::string bytes;
    PngWriter png(bytes);
    png.header(picture.size);
    if (!scene_json.empty()) {
        png.text(std::string(png_scene_keyword).c_str(), scene_json);
        if (is_widened(picture.size))
            png.text(std::string(png_field_keyword).c_str(),
                     fmt::format("{}x{}", picture.size.width, picture.size.height));
        if (picture.samples > 1)
            png.text(std::string(png_samples_keyword).c_str(), std::to_string(picture.samples));
    }
    png.rows(picture);
    return bytes;
}

std::string pfm_bytes(const Picture& picture, float exposure) {
    static_assert(std::endian::native == std::endian::little && sizeof(float) == 4);
    const auto width = static_cast<std::size_t>(picture.size.width);
    const auto height = static_cast<std::size_t>(picture.size.height);
    std::string bytes = "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
    std::size_t at = bytes.size();
    bytes.resize(at + 12 * width * height);
    for (std::size_t row = height; row-- > 0;) {
        for (std::size_t i = 3 * width * row; i < 3 * width * (row + 1); ++i, at += 4) {
            const float value = exposed(picture.linear[i], exposure);
            std::memcpy(&bytes[at], &value, 4);
        }
    }
    return bytes;
}

std::string html_image(const Picture& picture, std::string_view alt) {
    return fmt::format("<img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">",
                       html_escaped(alt), picture.size.width, picture.size.height,
                       base64(png_bytes(picture, {})));
}

// Writes OpenEXR files with the OpenEXR library.

std::string exr_bytes(const Picture& picture, float exposure) {
    std::vector<float> numbers(picture.linear.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = exposed(picture.linear[i], exposure);

    Imf::Header header(picture.size.width, picture.size.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    const std::size_t pixel = 3 * sizeof(float), row = pixel * static_cast<std::size_t>(picture.size.width);
    const char* names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
        frame.insert(names[c],
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(numbers.data() + c), pixel, row));
    }
    ExrSink out;
    {
        Imf::OutputFile file(out, header, 0);  // the line offset table is written when the file is closed
        file.setFrameBuffer(frame);
        file.writePixels(picture.size.height);
    }
    return std::move(out.bytes);
}

namespace {

constexpr int longest_webp_side = 16383;  // the file format stores it in 14 bits

}  // namespace

std::optional<AnimationFormat> animation_format(const std::string& path) {
    const std::string extension = lower_extension(path);
    if (extension == ".gif") return AnimationFormat::Gif;
    if (extension == ".webp") return AnimationFormat::WebP;
    return {};
}

Result<std::unique_ptr<AnimationWriter>> animation_writer(AnimationFormat format, PictureSize size,
                                                          int frames_a_second) {
    if (format == AnimationFormat::Gif) return gif_writer(size, frames_a_second);
    if (std::max(size.width, size.height) > longest_webp_side)
        return Problem{"", "", fmt::format("{}x{} is too large for WebP", size.width, size.height),
                       fmt::format("at most {} pixels per side, or a GIF", longest_webp_side)};
    return webp_writer(size, frames_a_second);
}

// Animations as GIF, written by giflib. Uses its own palettes, because the library's palettes keep 5 bits of
// each channel and split at the most frequent colours, which flattens a shaded object to one colour.

namespace {

constexpr std::size_t palette_size = 256;

using Rgb = std::array<double, 3>;  // 0 to 255
using Palette = std::vector<Rgb>;

Rgb rgb_of(std::uint32_t colour) {
    return {double(colour >> 16), double(colour >> 8 & 255), double(colour & 255)};
}
Rgb difference(const Rgb& a, const Rgb& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Rgb& a, const Rgb& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// A colour of the picture and its pixel count.
struct Counted {
    Rgb rgb;
    double pixels;
};

/// Colours that share one palette entry, which is their mean.
struct Box {
    std::span<Counted> colours;
    Rgb mean{};
    double error = 0;        // the sum of the squared distances from the mean
    std::size_t widest = 0;  // the channel with the largest part of the error

    explicit Box(std::span<Counted> all) : colours(all) {
        double pixels = 0;
        Rgb sum{}, squares{};
        for (const Counted& colour : colours) {
            pixels += colour.pixels;
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] += colour.pixels * colour.rgb[c];
                squares[c] += colour.pixels * colour.rgb[c] * colour.rgb[c];
            }
        }
        Rgb errors{};
        for (std::size_t c = 0; c < 3; ++c) {
            mean[c] = sum[c] / pixels;
            errors[c] = squares[c] - sum[c] * mean[c];
            if (colours.size() > 1) error += errors[c];
        }
        widest = static_cast<std::size_t>(std::max_element(errors.begin(), errors.end()) - errors.begin());
    }
};

/// At most 256 colours, from dark to bright: the picture's own colours if it has no more. Otherwise
/// repeatedly splits the box with the largest error at its mean (after Wan, Wong and Prusinkiewicz, "An
/// algorithm for multidimensional data clustering", 1988).
Palette palette_of(std::vector<Counted> colours) {
    std::vector<Box> boxes{Box(colours)};
    while (boxes.size() < palette_size) {
        Box& worst = *std::max_element(boxes.begin(), boxes.end(),
                                       [](const Box& a, const Box& b) { return a.error < b.error; });
        if (worst.error <= 0) break;
        const std::span<Counted> all = worst.colours;
        const auto below_mean = [&](const Counted& colour) {
            return colour.rgb[worst.widest] < worst.mean[worst.widest];
        };
        const auto middle = std::partition(all.begin(), all.end(), below_mean);
        worst = Box({all.begin(), middle});
        boxes.emplace_back(std::span(middle, all.end()));
    }
    Palette palette;
    for (const Box& box : boxes) {
        Rgb& colour = palette.emplace_back(box.mean);
        for (double& channel : colour) channel = std::round(channel);
    }
    std::sort(palette.begin(), palette.end(), [](const Rgb& a, const Rgb& b) {
        return std::pair(a[0] + a[1] + a[2], a) < std::pair(b[0] + b[1] + b[2], b);
    });
    return palette;
}

/// Two palette entries, the darker one first, and the fraction of pixels that get the second.
struct Mixture {
    std::uint8_t first = 0, second = 0;
    double share = 0;
};

/// The two entries whose mixture best matches a colour: the nearest entry and one other.
Mixture mixture(const Rgb& colour, const Palette& palette) {
    // The average must match the colour. Among equally good mixtures, prefers the one with less grain.
    constexpr double grain = 0.1;
    const auto distance = [&](const Rgb& entry) {
        const Rgb away = difference(colour, entry);
        return dot(away, away);
    };
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < palette.size(); ++i)
        if (distance(palette[i]) < distance(palette[nearest])) nearest = i;
    const Rgb offset = difference(colour, palette[nearest]);
    std::size_t other = nearest;
    double share = 0, lowest_cost = dot(offset, offset);
    for (std::size_t i = 0; i < palette.size(); ++i) {
        const Rgb direction = difference(palette[i], palette[nearest]);
        const double squared = dot(direction, direction), along = dot(direction, offset);
        if (along <= 0) continue;
        const double part = std::min(along / squared, 0.5);
        const double error = dot(offset, offset) - 2 * part * along + part * part * squared;
        const double cost = error + grain * part * (1 - part) * squared;
        if (cost < lowest_cost) {
            lowest_cost = cost;
            other = i;
            share = part;
        }
    }
    const auto entry = [](std::size_t i) { return static_cast<std::uint8_t>(i); };
    if (other < nearest) return {entry(other), entry(nearest), 1 - share};
    return {entry(nearest), entry(other), share};
}

/// Bayer's 8x8 threshold matrix, values between 0 and 1. Unlike error diffusion, a fixed screen pattern does
/// not flicker in static parts of the picture.
double threshold(int x, int y) {
    int rank = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int column = x >> bit & 1, row = y >> bit & 1;
        rank = rank << 2 | (column ^ row) << 1 | row;
    }
    return (rank + 0.5) / 64;
}

/// A picture as palette indices, one per pixel.
struct Indexed {
    Palette palette;
    std::vector<GifByteType> entries;
};

Indexed indexed(const Picture& picture) {
    const auto colour_at = [&](std::size_t pixel) {
        const std::uint8_t* const rgb = &picture.rgba[4 * pixel];
        return std::uint32_t(rgb[0] << 16 | rgb[1] << 8 | rgb[2]);
    };
    struct Known {
        int pixels = 0;
        Mixture mixture;
    };
    std::unordered_map<std::uint32_t, Known> known;
    for (std::size_t i = 0; i < picture.size.pixels(); ++i) ++known[colour_at(i)].pixels;
    std::vector<Counted> counted;
    counted.reserve(known.size());
    for (const auto& [colour, of] : known) counted.push_back({rgb_of(colour), double(of.pixels)});

    Indexed out{palette_of(std::move(counted)), std::vector<GifByteType>(picture.size.pixels())};
    for (auto& [colour, of] : known) of.mixture = mixture(rgb_of(colour), out.palette);
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) {
            const std::size_t pixel = picture.pixel(x, y);
            const Mixture& mixed = known.at(colour_at(pixel)).mixture;
            out.entries[pixel] = threshold(x, y) < mixed.share ? mixed.second : mixed.first;
        }
    return out;
}

class GifWriter final : public AnimationWriter {
  public:
    GifWriter(PictureSize size, int frames_a_second) : size_(size), frames_a_second_(frames_a_second) {
        int error = 0;
        file_ = EGifOpen(&bytes_, append, &error);
        if (file_ == nullptr) return;
        EGifSetGifVersion(file_, true);
        check(EGifPutScreenDesc(file_, size.width, size.height, 8, 0, nullptr));
        loop_extension();
    }
    ~GifWriter() override {
        int error = 0;
        if (file_ != nullptr) EGifCloseFile(file_, &error);
    }
    GifWriter(const GifWriter&) = delete;
    GifWriter& operator=(const GifWriter&) = delete;

    std::optional<Problem> add(const Picture& picture) override {
        if (file_ == nullptr) return no_memory();
        Indexed frame = indexed(picture);
        std::array<GifColorType, palette_size> colours{};
        for (std::size_t i = 0; i < frame.palette.size(); ++i) {
            const auto channel = [&](std::size_t c) { return static_cast<GifByteType>(frame.palette[i][c]); };
            colours[i] = {channel(0), channel(1), channel(2)};
        }
        ColorMapObject map{static_cast<int>(palette_size), 8, false, colours.data()};
        delay();
        check(EGifPutImageDesc(file_, 0, 0, size_.width, size_.height, false, &map));
        for (int y = 0; y < size_.height && !failed_; ++y)
            check(EGifPutLine(file_, &frame.entries[size_.index(0, y)], size_.width));
        return failed_ ? std::optional(no_memory()) : std::nullopt;
    }

    Result<std::string> finish() override {
        int error = 0;
        if (file_ == nullptr || EGifCloseFile(std::exchange(file_, nullptr), &error) != GIF_OK || failed_)
            return no_memory();
        return std::move(bytes_);
    }

  private:
    static int append(GifFileType* file, const GifByteType* bytes, int count) {
        static_cast<std::string*>(file->UserData)
            ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
        return count;
    }
    static Problem no_memory() {
        return {"", "", "the GIF does not fit in memory", "fewer or smaller frames"};
    }
    void check(int result) { failed_ |= result != GIF_OK; }

    /// The Netscape extension for endless looping.
    void loop_extension() {
        static constexpr GifByteType forever[] = {1, 0, 0};
        check(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
        check(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
        check(EGifPutExtensionBlock(file_, sizeof forever, forever));
        check(EGifPutExtensionTrailer(file_));
    }

    /// The delay in integer hundredths of a second. Rounding errors do not accumulate, so the speed is
    /// preserved over many frames.
    void delay() {
        const auto begin_of = [this](int frame) {
            return (100 * frame + frames_a_second_ / 2) / frames_a_second_;
        };
        const int hundredths = begin_of(frame_ + 1) - begin_of(frame_);
        ++frame_;
        const GraphicsControlBlock control{DISPOSE_DO_NOT, false, hundredths, NO_TRANSPARENT_COLOR};
        GifByteType block[4];
        EGifGCBToExtension(&control, block);
        check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, sizeof block, block));
    }

    PictureSize size_;
    int frames_a_second_, frame_ = 0;
    std::string bytes_;
    GifFileType* file_ = nullptr;
    bool failed_ = false;
};

}  // namespace

std::unique_ptr<AnimationWriter> gif_writer(PictureSize size, int frames_a_second) {
    return std::make_unique<GifWriter>(size, frames_a_second);
}

// Writes animations as lossless WebP with libwebp and libwebpmux.

namespace {

/// 0 to 9. The next higher level reduces file size by a tenth and takes one and a half times as long.
constexpr int effort = 2;

struct DeleteEncoder {
    void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};
using Encoder = std::unique_ptr<WebPAnimEncoder, DeleteEncoder>;

/// An empty libwebp picture.
struct Frame {
    WebPPicture picture;
    Frame() { WebPPictureInit(&picture); }
    ~Frame() { WebPPictureFree(&picture); }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
};

Encoder encoder_for(PictureSize size) {
    WebPAnimEncoderOptions options;  // loops endlessly by default
    WebPAnimEncoderOptionsInit(&options);
    return Encoder(WebPAnimEncoderNew(size.width, size.height, &options));
}

class WebPWriter final : public AnimationWriter {
  public:
    WebPWriter(PictureSize size, int frames_a_second)
        : frames_a_second_(frames_a_second), encoder_(encoder_for(size)) {
        WebPConfigInit(&config_);
        WebPConfigLosslessPreset(&config_, effort);
    }

    std::optional<Problem> add(const Picture& picture) override {
        Frame frame;
        frame.picture.use_argb = 1;
        frame.picture.width = picture.size.width;
        frame.picture.height = picture.size.height;
        if (!encoder_ ||
            !WebPPictureImportRGBX(&frame.picture, picture.rgba.data(), 4 * picture.size.width) ||
            !WebPAnimEncoderAdd(encoder_.get(), &frame.picture, begin_of(frame_++), &config_))
            return no_memory();
        return {};
    }

    Result<std::string> finish() override {
        WebPData data;
        WebPDataInit(&data);
        const bool whole = encoder_ &&
                           WebPAnimEncoderAdd(encoder_.get(), nullptr, begin_of(frame_), nullptr) &&
                           WebPAnimEncoderAssemble(encoder_.get(), &data);
        const std::unique_ptr<WebPData, decltype(&WebPDataClear)> freed(&data, WebPDataClear);
        if (!whole) return no_memory();
        return std::string(reinterpret_cast<const char*>(data.bytes), data.size);
    }

  private:
    static Problem no_memory() {
        return {"", "", "the WebP does not fit in memory", "fewer or smaller frames"};
    }
    /// The frame's start time in milliseconds.
    [[nodiscard]] int begin_of(int frame) const { return 1000 * frame / frames_a_second_; }

    int frames_a_second_, frame_ = 0;
    WebPConfig config_;
    Encoder encoder_;
};

}  // namespace

std::unique_ptr<AnimationWriter> webp_writer(PictureSize size, int frames_a_second) {
    return std::make_unique<WebPWriter>(size, frames_a_second);
}

}  // namespace glint
