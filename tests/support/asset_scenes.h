#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace glint::test {

/// Paths of the scenes that come with the program, in alphabetical order.
inline std::vector<std::string> asset_scenes() {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(GLINT_SOURCE_DIR "/assets/scenes"))
        if (entry.path().extension() == ".json") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace glint::test
