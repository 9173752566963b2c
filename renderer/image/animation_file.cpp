#include "renderer/image/animation_file.h"

#include <fmt/core.h>

#include <algorithm>

#include "models/io/file.h"

namespace glint {
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
                       fmt::format("at most {} pixels a side, or a GIF", longest_webp_side)};
    return webp_writer(size, frames_a_second);
}

}  // namespace glint
