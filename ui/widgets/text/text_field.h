#pragma once
// One-line text fields.

#include <string>

namespace glint {

/// A text field that shows `hint` while it is empty. Returns true when the text was changed, or with
/// EnterReturnsTrue (flags are ImGuiInputTextFlags) when Enter ended the typing. During an edit Dear ImGui
/// stores text in 16 bits per character: an edit turns an emoji, or a byte that is not UTF-8, into U+FFFD.
/// Focus without an edit does not.
[[nodiscard]] bool text_field(const char* label, const char* hint, std::string& text, int flags = 0);

/// During its lifetime a line break within pasted text becomes a space, and one at its end is dropped. Dear
/// ImGui would drop all of them: a pasted column of numbers would become one number.
class PasteInOneLine {
  public:
    PasteInOneLine();
    ~PasteInOneLine();
    PasteInOneLine(const PasteInOneLine&) = delete;
    PasteInOneLine& operator=(const PasteInOneLine&) = delete;
};

}  // namespace glint
