#include "renderer/image/html_image.h"

#include <fmt/format.h>

#include "models/io/markup.h"
#include "renderer/image/image_file.h"

namespace glint {

std::string html_image(const Picture& picture, std::string_view alt) {
    return fmt::format("<img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">",
                       html_escaped(alt), picture.size.width, picture.size.height,
                       base64(png_bytes(picture, {})));
}

}  // namespace glint
