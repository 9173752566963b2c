// What a file is called where a window has little room and its name may be anything.
#include <filesystem>
#include <string_view>

#include "models/io/utf8.h"
#include "models/problem.h"
#include "ui/document/editor.h"

namespace glint {

std::string file_title(const std::string& path) {
    constexpr std::size_t longest = 80;
    const std::string name = std::filesystem::path(path).filename().string();
    if (name.empty()) return "New scene";
    const std::string shown = on_one_line(first_characters(name, longest + 1));
    const std::string_view cut = first_characters(shown, longest);
    return std::string(cut) + (cut.size() < shown.size() ? "…" : "");
}

}  // namespace glint
