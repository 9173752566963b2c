#include "ui/widgets/text/text_field.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "models/io/utf8.h"

namespace glint {
namespace {

// The private use area of 16 bits: three bytes each in UTF-8.
constexpr unsigned first_private = 0xE000, last_private = 0xF8FF;
constexpr std::size_t private_length = 3;

std::string private_character(unsigned code) {
    return {static_cast<char>(0xE0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3F)),
            static_cast<char>(0x80 | (code & 0x3F))};
}

/// The code of a character of that area; 0 for all others. Precondition: well-formed.
unsigned private_code(std::string_view character) {
    const unsigned code = code_point(character);
    return code >= first_private && code <= last_private ? code : 0;
}

/// What stands behind each character of the area, as long as the window lives. Only the main thread edits.
std::vector<std::string>& pieces() {
    static std::vector<std::string> all;
    return all;
}

/// The character that stands for `piece`; U+FFFD when the area is full.
std::string stand_in(std::string_view piece) {
    std::vector<std::string>& all = pieces();
    const auto found = std::find(all.begin(), all.end(), piece);
    const auto index = static_cast<unsigned>(found - all.begin());
    if (first_private + index > last_private) return "\xEF\xBF\xBD";
    if (found == all.end()) all.emplace_back(piece);
    return private_character(first_private + index);
}

// The clipboard's functions under those of the field, while one is drawn.
const char* (*clipboard_text)(void*) = nullptr;
void (*set_clipboard_text)(void*, const char*) = nullptr;

const char* pasted(void* data) {
    const char* const text = clipboard_text != nullptr ? clipboard_text(data) : nullptr;
    if (text == nullptr) return nullptr;
    static std::string held;
    held = held_in_field(text);
    return held.c_str();
}

void copied(void* data, const char* held) {
    if (set_clipboard_text != nullptr) set_clipboard_text(data, taken_from_field(held).c_str());
}

class FieldsClipboard {
  public:
    FieldsClipboard() {
        ImGuiIO& io = ImGui::GetIO();
        clipboard_text = io.GetClipboardTextFn, set_clipboard_text = io.SetClipboardTextFn;
        io.GetClipboardTextFn = pasted, io.SetClipboardTextFn = copied;
    }
    ~FieldsClipboard() {
        ImGuiIO& io = ImGui::GetIO();
        io.GetClipboardTextFn = clipboard_text, io.SetClipboardTextFn = set_clipboard_text;
    }
    FieldsClipboard(const FieldsClipboard&) = delete;
    FieldsClipboard& operator=(const FieldsClipboard&) = delete;
};

}  // namespace

std::string held_in_field(std::string_view text) {
    std::string held;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text.substr(at));
        const std::string_view piece = text.substr(at, std::max<std::size_t>(length, 1));
        const bool fits = length > 0 && length <= private_length && piece != std::string_view("\0", 1) &&
                          private_code(piece) == 0;
        held += fits ? std::string(piece) : stand_in(piece);
        at += piece.size();
    }
    return held;
}

std::string taken_from_field(std::string_view held) {
    std::string text;
    for (std::size_t at = 0; at < held.size();) {
        const std::string_view piece =
            held.substr(at, std::max<std::size_t>(utf8_length(held.substr(at)), 1));
        const unsigned code = private_code(piece);
        const bool stands_in = code != 0 && code - first_private < pieces().size();
        text += stands_in ? pieces()[code - first_private] : std::string(piece);
        at += piece.size();
    }
    return text;
}

bool text_field(const char* label, const char* hint, std::string& text, int flags) {
    const FieldsClipboard clipboard;
    std::string held = held_in_field(text);
    const std::string before = held;
    const bool told = ImGui::InputTextWithHint(label, hint, &held, flags);
    if (held != before) text = taken_from_field(held);
    return told;
}

}  // namespace glint
