#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/places.h"

namespace glint::test {

/// Paths of the scenes that come with the program, in alphabetical order.
inline std::vector<std::string> asset_scenes() {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(project_file("assets/scenes")))
        if (entry.path().extension() == ".json") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace glint::test
