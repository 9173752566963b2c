#pragma once
// JSON pointers, as those of a scene's numbers. Source: RFC 6901.

#include <string_view>

namespace glint {

/// Whether a pointer is `outer` or leads to something within it: "/lights/0/position/1" within "/lights/0".
[[nodiscard]] inline bool is_within(std::string_view pointer, std::string_view outer) {
    return pointer.starts_with(outer) && (pointer.size() == outer.size() || pointer[outer.size()] == '/');
}

}  // namespace glint
