#include "ui/widgets/text/text_field.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string_view>
#include <utility>
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
std::size_t longest_held = any_length;  // by that field

/// As many whole characters as `room` bytes hold. Precondition: well-formed.
std::string cut_off(std::string text, std::size_t room) {
    if (text.size() <= room) return text;
    while (room > 0 && continues_character(text[room])) --room;
    text.resize(room);
    return text;
}

/// The bytes that the field in hand has left, what is selected not counted: a paste takes its place.
std::size_t room_in_hand() {
    const ImGuiInputTextState& hand = ImGui::GetCurrentContext()->InputTextState;
    const auto [first, last] = std::minmax({hand.GetSelectionStart(), hand.GetSelectionEnd()});
    const ImWchar* const letters = hand.TextW.Data;
    const int kept = hand.CurLenA - ImTextCountUtf8BytesFromStr(letters + first, letters + last);
    return longest_held - std::min(longest_held, static_cast<std::size_t>(std::max(kept, 0)));
}

const char* pasted(void* data) {
    const char* const text = clipboard_text != nullptr ? clipboard_text(data) : nullptr;
    if (text == nullptr) return nullptr;
    static std::string held;
    held = held_in_field(text);
    if (longest_held != any_length) held = cut_off(std::move(held), room_in_hand());
    return held.c_str();
}

void copied(void* data, const char* held) {
    if (set_clipboard_text != nullptr) set_clipboard_text(data, taken_from_field(held).c_str());
}

class FieldsClipboard {
  public:
    explicit FieldsClipboard(std::size_t longest) {
        ImGuiIO& io = ImGui::GetIO();
        longest_held = longest;
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

/// A field that holds no more than `longest` bytes, however much is typed or pasted.
bool short_field(const char* label, const char* hint, std::string& held, int flags, std::size_t longest) {
    held = cut_off(std::move(held), longest);
    held.resize(longest + 1);  // with the zero at the end
    const bool told = ImGui::InputTextWithHint(label, hint, held.data(), held.size(), flags);
    held.resize(std::min(held.find('\0'), longest));
    return told;
}

}  // namespace

std::string held_in_field(std::string_view text) {
    std::string held;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text.substr(at));
        const std::string_view piece = first_characters(text.substr(at), 1);
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
        const std::string_view piece = first_characters(held.substr(at), 1);
        const unsigned code = private_code(piece);
        const bool stands_in = code != 0 && code - first_private < pieces().size();
        text += stands_in ? pieces()[code - first_private] : std::string(piece);
        at += piece.size();
    }
    return text;
}

bool text_field(const char* label, const char* hint, std::string& text, int flags, std::size_t longest) {
    const FieldsClipboard clipboard(longest);
    std::string held = held_in_field(text);
    const std::string before = held;
    const bool told = longest == any_length ? ImGui::InputTextWithHint(label, hint, &held, flags)
                                            : short_field(label, hint, held, flags, longest);
    if (held != before) text = taken_from_field(held);
    return told;
}

}  // namespace glint
