#include "ui/widgets/text/text_field.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace glint {
namespace {

const char* (*from_clipboard)(void*) = nullptr;

const char* text_in_one_line(void* data) {
    const char* const text = from_clipboard != nullptr ? from_clipboard(data) : nullptr;
    if (text == nullptr) return nullptr;
    static std::string line;
    line = text;
    line.resize(line.find_last_not_of(" \t\r\n") + 1);  // a copied line ends with a line break
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return line.c_str();
}

/// Dear ImGui's output for a text that had focus without an edit: characters are replaced by others of
/// different length, but the total length is the original one.
std::string as_visited(const std::string& text) {
    std::vector<ImWchar> wide(text.size() + 1);
    ImTextStrFromUtf8(wide.data(), static_cast<int>(wide.size()), text.c_str(), nullptr);
    std::string narrow(4 * wide.size(), '\0');
    const int length = ImTextStrToUtf8(narrow.data(), static_cast<int>(narrow.size()), wide.data(), nullptr);
    narrow.resize(std::min(static_cast<std::size_t>(length), text.size()));
    return narrow;
}

}  // namespace

PasteInOneLine::PasteInOneLine() {
    from_clipboard = ImGui::GetIO().GetClipboardTextFn;
    ImGui::GetIO().GetClipboardTextFn = text_in_one_line;
}

PasteInOneLine::~PasteInOneLine() { ImGui::GetIO().GetClipboardTextFn = from_clipboard; }

bool text_field(const char* label, const char* hint, std::string& text, int flags) {
    const PasteInOneLine pasted;
    std::string edited = text;
    const bool returned = ImGui::InputTextWithHint(label, hint, &edited, flags);
    edited.resize(std::strlen(edited.c_str()));
    const bool changed = edited != text && edited != as_visited(text);
    if (changed) text = edited;
    return (flags & ImGuiInputTextFlags_EnterReturnsTrue) != 0 ? returned : changed;
}

}  // namespace glint
