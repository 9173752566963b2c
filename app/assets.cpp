#include "app/assets.h"

#include <filesystem>
#include <system_error>

namespace glint {

namespace fs = std::filesystem;

std::string asset_path(const std::string& relative) {
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    const fs::path asset = fs::path("assets") / relative;
    const fs::path folder = program.parent_path();
    for (const fs::path& root : {folder, folder / "../share/glint", folder / "../../.."})
        if (fs::exists(root / asset, failed)) return (root / asset).lexically_normal().string();
    return {};
}

std::string asset_places(const std::string& relative) {
    return "assets/" + relative + " beside the program, or in ../share/glint from there";
}

}  // namespace glint
