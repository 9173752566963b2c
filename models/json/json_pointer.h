#pragma once
// JSON pointers, which also name a scene's numbers. Source: RFC 6901.

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace glint {

/// A reference token in the escaped form of a pointer: ~ as ~0, / as ~1.
[[nodiscard]] std::string escaped_token(std::string_view token);

/// Whether a pointer is `outer` or points into it: "/lights/0/position/1" is within "/lights/0".
[[nodiscard]] inline bool is_within(std::string_view pointer, std::string_view outer) {
    return pointer.starts_with(outer) && (pointer.size() == outer.size() || pointer[outer.size()] == '/');
}

/// An item of a list, and the remaining pointer.
struct ListItem {
    int place = 0;
    std::string_view rest;
};

/// Returns the item of `list` that a pointer names or points into: 3 and "/position" for "/lights/3/position"
/// in "/lights/"; nothing if it points elsewhere. Does not check the length of the list.
[[nodiscard]] inline std::optional<ListItem> item_in(std::string_view pointer, std::string_view list) {
    if (!pointer.starts_with(list)) return {};
    const char* const end = pointer.data() + pointer.size();
    ListItem item;
    const auto [rest, error] = std::from_chars(pointer.data() + list.size(), end, item.place);
    if (error != std::errc() || item.place < 0 || (rest != end && *rest != '/')) return {};
    item.rest = {rest, static_cast<std::size_t>(end - rest)};
    return item;
}

}  // namespace glint
