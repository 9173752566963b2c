#include "ui/lecture/folder_scenes.h"

#include <algorithm>
#include <filesystem>

namespace glint {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// The digits at the front of `text`, without leading zeros; they are taken off it.
std::string_view take_number(std::string_view& text) {
    std::size_t length = 0;
    while (length < text.size() && is_digit(text[length])) ++length;
    std::string_view digits = text.substr(0, length);
    text.remove_prefix(length);
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return digits;
}

/// Below 0, 0 or above 0, as `a` comes before, with or after `b`.
int natural_order(std::string_view a, std::string_view b) {
    while (!a.empty() && !b.empty()) {
        if (is_digit(a[0]) && is_digit(b[0])) {
            const std::string_view m = take_number(a), n = take_number(b);
            if (m.size() != n.size()) return m.size() < n.size() ? -1 : 1;
            if (const int order = m.compare(n); order != 0) return order;
            continue;
        }
        if (lower(a[0]) != lower(b[0])) return lower(a[0]) < lower(b[0]) ? -1 : 1;
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    return a.empty() ? (b.empty() ? 0 : -1) : 1;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
    const int order = natural_order(a, b);
    return order != 0 ? order < 0 : a < b;  // "a1" and "a01" are in some order, always the same
}

std::vector<std::string> folder_scenes(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code failed;
    for (fs::directory_iterator it(folder.empty() ? "." : folder, failed);
         !failed && it != fs::directory_iterator(); it.increment(failed)) {
        std::error_code unknown;
        const std::string name = it->path().filename().string();
        std::string extension = it->path().extension().string();
        std::transform(extension.begin(), extension.end(), extension.begin(), lower);
        if (extension == ".json" && !name.starts_with(".") && it->is_regular_file(unknown))
            names.push_back(name);
    }
    std::sort(names.begin(), names.end(), natural_less);
    for (std::string& name : names) name = (fs::path(folder) / name).string();
    return names;
}

std::string scene_beside(const std::string& path, int step) {
    const fs::path file(path);
    const std::string name = file.filename().string();
    const std::vector<std::string> scenes = folder_scenes(file.parent_path().string());
    const auto less = [](const std::string& scene, const std::string& other) {
        return natural_less(fs::path(scene).filename().string(), other);
    };
    auto at = std::lower_bound(scenes.begin(), scenes.end(), name, less) - scenes.begin();
    const auto count = static_cast<std::ptrdiff_t>(scenes.size());
    const bool there = at < count && fs::path(scenes[static_cast<std::size_t>(at)]).filename() == name;
    if (!there && step > 0) --at;  // the one in its place is the next one
    at += step;
    return at >= 0 && at < count ? scenes[static_cast<std::size_t>(at)] : "";
}

}  // namespace glint
