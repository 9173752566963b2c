// Shortens file names for display; a name may contain any characters.
#include <filesystem>

#include "models/problem.h"
#include "models/utf8.h"
#include "ui/document/editor.h"

namespace glint {

std::string file_title(const std::string& path) {
    constexpr std::size_t longest = 80;
    const std::string name = std::filesystem::path(path).filename().string();
    if (name.empty()) return "New scene";
    return shortened(on_one_line(first_characters(name, longest + 1)), longest);
}

}  // namespace glint
