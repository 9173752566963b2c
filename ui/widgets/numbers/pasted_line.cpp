#include "ui/widgets/numbers/pasted_line.h"

#include <imgui.h>

#include <algorithm>
#include <string>

namespace glint {
namespace {

const char* (*from_clipboard)(void*) = nullptr;

const char* text_in_one_line(void* data) {
    const char* const text = from_clipboard != nullptr ? from_clipboard(data) : nullptr;
    if (text == nullptr) return nullptr;
    static std::string line;
    line = text;
    line.resize(line.find_last_not_of(" \t\r\n") + 1);  // a copied line ends with a break
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return line.c_str();
}

}  // namespace

PasteInOneLine::PasteInOneLine() {
    from_clipboard = ImGui::GetIO().GetClipboardTextFn;
    ImGui::GetIO().GetClipboardTextFn = text_in_one_line;
}

PasteInOneLine::~PasteInOneLine() { ImGui::GetIO().GetClipboardTextFn = from_clipboard; }

}  // namespace glint
