#pragma once

#include <string>
#include <string_view>

#include "renderer/picture.h"

namespace glint {

/// The picture as an element of a page that needs nothing else; `alt` says what it shows.
[[nodiscard]] std::string html_image(const Picture& picture, std::string_view alt);

}  // namespace glint
