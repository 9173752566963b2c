#pragma once
// Fields of one line.

#include <string>

namespace glint {

/// A text field that shows `hint` while it is empty. Returns true when the text was changed, or with
/// EnterReturnsTrue (flags are ImGuiInputTextFlags) when Enter ended the typing. While text is edited,
/// Dear ImGui stores it in 16 bits per character: an edit turns an emoji, or a byte that is not UTF-8, into
/// U+FFFD. A visit without an edit does not.
[[nodiscard]] bool text_field(const char* label, const char* hint, std::string& text, int flags = 0);

/// While this lives a line break within pasted text becomes a blank, and one at its end is dropped. Dear
/// ImGui would drop all: a pasted column of numbers would become one number.
class PasteInOneLine {
  public:
    PasteInOneLine();
    ~PasteInOneLine();
    PasteInOneLine(const PasteInOneLine&) = delete;
    PasteInOneLine& operator=(const PasteInOneLine&) = delete;
};

}  // namespace glint
