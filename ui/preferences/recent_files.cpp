#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "models/io/utf8.h"
#include "models/json/json_value.h"
#include "ui/preferences/persistence.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_path = 4096;  // PATH_MAX

bool can_be_shown(const std::string& path) {
    const auto control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    return path.size() <= longest_path && fs::path(path).is_absolute() &&
           std::none_of(path.begin(), path.end(), control);
}

void add(std::vector<std::string>& paths, std::string path) {
    if (paths.size() >= max_recent_files || !can_be_shown(path)) return;
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(std::move(path));
}

}  // namespace

std::vector<std::string> read_recent_files(const std::string& text) {
    std::vector<std::string> paths;
    const JsonValue json = JsonValue::parse(text).value_or(JsonValue());
    for (const JsonValue& item : json.elements())
        if (item.is_string()) add(paths, unescaped_bytes(item.string()));
    return paths;
}

std::string recent_files_text(const std::vector<std::string>& paths) {
    JsonValue::Elements escaped;  // a path need not be UTF-8
    for (const std::string& path : paths) escaped.emplace_back(escaped_bytes(path));
    return json_text(JsonValue(escaped));
}

std::vector<std::string> with_recent_file(std::vector<std::string> paths, const std::string& path) {
    if (path.empty() || path == "-") return paths;
    std::error_code failed;
    std::string whole = fs::absolute(path, failed).lexically_normal().string();
    if (failed || !can_be_shown(whole)) return paths;
    std::vector<std::string> list{std::move(whole)};
    for (std::string& other : paths) add(list, std::move(other));
    return list;
}

}  // namespace glint
