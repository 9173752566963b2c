#pragma once
// Fields of one line for text of any bytes.

#include <cstddef>
#include <string>
#include <string_view>

namespace glint {

inline constexpr std::size_t any_length = 0;
inline constexpr std::size_t longest_search = 100;  // bytes

/// A text field with `hint` where it is empty. Dear ImGui holds what is edited in 16 bits a character; what
/// does not fit (an emoji, a byte that is not UTF-8, which the name of a file may have, a zero) is one
/// character of the private use area meanwhile, shown as "?", and is itself again in `text` and on the
/// clipboard. True when the text was changed, or with EnterReturnsTrue (flags are ImGuiInputTextFlags) when
/// Enter ended the typing. `longest`: so many bytes are held, and of what is pasted as many characters as
/// fit.
[[nodiscard]] bool text_field(const char* label, const char* hint, std::string& text, int flags = 0,
                              std::size_t longest = any_length);

/// The text as the field holds it, and back.
[[nodiscard]] std::string held_in_field(std::string_view text);
[[nodiscard]] std::string taken_from_field(std::string_view held);

}  // namespace glint
