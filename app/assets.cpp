#include "app/assets.h"

#include <filesystem>
#include <system_error>

namespace glint {

namespace fs = std::filesystem;

std::string asset_path(const std::string& relative) {
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    const fs::path asset = fs::path("assets") / relative;
    for (const fs::path& root : {program.parent_path(), program.parent_path() / ".." / "share" / "glint",
                                 fs::path(GLINT_SOURCE_DIR)})
        if (fs::exists(root / asset, failed)) return (root / asset).string();
    return {};
}

}  // namespace glint
