#pragma once

#include <string>
#include <string_view>

#include "renderer/picture.h"

namespace glint {

/// The picture as a self-contained HTML element. `alt` is its alternative text.
[[nodiscard]] std::string html_image(const Picture& picture, std::string_view alt);

}  // namespace glint
