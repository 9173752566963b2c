#include "renderer/image/image_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <fmt/core.h>
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <new>
#include <optional>
#include <string_view>

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

}  // namespace glint
