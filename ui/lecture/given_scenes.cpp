#include "ui/lecture/given_scenes.h"

#include <algorithm>
#include <utility>

namespace glint {
namespace {

std::vector<std::string> given;

}  // namespace

void give_scenes(std::vector<std::string> paths) { given = std::move(paths); }

std::optional<std::string> given_scene_beside(const std::string& path, int step) {
    const auto found = std::find(given.begin(), given.end(), path);
    if (found == given.end()) return {};
    const std::ptrdiff_t at = found - given.begin() + step;
    return at >= 0 && at < std::ssize(given) ? given[static_cast<std::size_t>(at)] : "";
}

}  // namespace glint
