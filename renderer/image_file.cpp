#include "renderer/image_file.h"

#include <png.h>
#include <zlib.h>

#include <array>
#include <bit>
#include <cstring>

#include "models/file.h"
#include "models/scene_file.h"

namespace glint {
namespace {

// A picture of the largest size, 16 bits a channel, that cannot be compressed at all.
constexpr std::size_t max_png_bytes = std::size_t{9} * max_picture_side * max_picture_side;
// Deflate never makes more than 1032 bytes of one, so a larger claim is a lie (zlib, "Technical Details").
constexpr std::size_t max_inflation = 1032;

void append_be32(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>((value >> shift) & 0xFFu));
}

/// One chunk: length, type, data, CRC over the last two.
std::string chunk(std::string_view type, std::string_view data) {
    std::string out;
    append_be32(out, static_cast<std::uint32_t>(data.size()));
    out.append(type).append(data);
    const auto* checked = reinterpret_cast<const Bytef*>(out.data() + 4);
    append_be32(out, static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), checked, out.size() - 4)));
    return out;
}

/// Keyword, then four fields that are empty or zero (compression flag and method, language, translated
/// keyword).
std::string scene_chunk(const std::string& scene_json) {
    std::string data(png_scene_keyword);
    data.append(5, '\0').append(scene_json);
    return chunk("iTXt", data);
}

std::string rgb_of(const Picture& picture) {
    const std::size_t pixels = picture.rgba.size() / 4;
    std::string rgb(3 * pixels, '\0');
    for (std::size_t i = 0; i < pixels; ++i) std::memcpy(&rgb[3 * i], &picture.rgba[4 * i], 3);
    return rgb;
}

Problem unreadable(const std::string& path, const std::string& what) {
    return {.file = path, .pointer = {}, .what = what, .expected = "a PNG picture of 1x1 to 16384x16384"};
}

}  // namespace

std::string png_bytes(const Picture& picture, const std::string& scene_json) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.size.width);
    image.height = static_cast<png_uint_32>(picture.size.height);
    image.format = PNG_FORMAT_RGB;
    image.flags = PNG_IMAGE_FLAG_COLORSPACE_NOT_sRGB;  // `transfer` may be none; no viewer needs the claim
    const std::string rgb = rgb_of(picture);
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = bytes.size();
    // Nothing but memory can fail here: the buffer has the size that libpng itself asks for.
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0) {
        throw std::bad_alloc();
    }
    bytes.resize(size);
    constexpr std::size_t after_header = 8 + 25;  // signature and IHDR
    if (!scene_json.empty()) bytes.insert(after_header, scene_chunk(scene_json));
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
            const float value = picture.linear[i] * exposure;
            std::memcpy(&bytes[at], &value, 4);
        }
    }
    return bytes;
}

Result<Picture> read_png(const std::string& path) {
    auto file = read_file(path, max_png_bytes);
    if (const Problem* problem = problem_of(file)) return *problem;
    const std::string& bytes = std::get<std::string>(file);
    if (bytes.empty()) return unreadable(path, "is empty");

    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
        return unreadable(path, std::string("cannot be read as a PNG (") + image.message + ")");
    }
    const struct Freed {
        png_image* image;
        ~Freed() { png_image_free(image); }
    } freed{&image};
    const std::size_t pixels = std::size_t{image.width} * image.height;
    if (image.width > max_picture_side || image.height > max_picture_side) {
        return unreadable(
            path, "has " + std::to_string(image.width) + "x" + std::to_string(image.height) + " pixels");
    }
    // One bit a pixel is the least that a PNG can hold.
    if (pixels / 8 > max_inflation * bytes.size())
        return unreadable(path, "claims more pixels than it can hold");

    image.format = PNG_FORMAT_RGBA;
    image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // else 16-bit samples would be taken as linear light
    Picture picture{{static_cast<int>(image.width), static_cast<int>(image.height)}, {}, {}};
    picture.rgba.resize(4 * pixels);
    if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) == 0) {
        return unreadable(path, std::string("cannot be read as a PNG (") + image.message + ")");
    }
    return picture;
}

}  // namespace glint
