#pragma once
// Fields of one line for text of any bytes.

#include <cstddef>
#include <string>
#include <string_view>

namespace glint {

inline constexpr std::size_t any_length = 0;
inline constexpr std::size_t longest_search = 100;  // bytes

/// A text field that shows `hint` while it is empty. While text is edited, Dear ImGui stores it in 16 bits
/// per character. What does not fit (an emoji, a zero, a byte that is not UTF-8, as a file name may have) is
/// replaced by one character of the private use area and shown as "?"; in `text` and on the clipboard it is
/// itself again. Returns true when the text was changed, or with EnterReturnsTrue (flags are
/// ImGuiInputTextFlags) when Enter ended the typing. `longest`: how many bytes the field holds; of a paste it
/// takes as many characters as fit.
[[nodiscard]] bool text_field(const char* label, const char* hint, std::string& text, int flags = 0,
                              std::size_t longest = any_length);

/// The text as the field holds it, and back.
[[nodiscard]] std::string held_in_field(std::string_view text);
[[nodiscard]] std::string taken_from_field(std::string_view held);

}  // namespace glint
