#include "models/io/file_stamp.h"

#include <fmt/core.h>
#include <sys/stat.h>

#include <sstream>

namespace glint {

FileStamp file_stamp(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    constexpr std::int64_t ns = 1'000'000'000;
    return {status.st_dev, status.st_ino, status.st_size,
            status.st_mtim.tv_sec * ns + status.st_mtim.tv_nsec};
}

std::string stamp_text(const FileStamp& stamp) {
    return fmt::format("{} {} {} {}", stamp.device, stamp.inode, stamp.size, stamp.modified_ns);
}

std::optional<FileStamp> stamp_of(const std::string& text) {
    std::istringstream numbers(text);
    FileStamp stamp;
    numbers >> stamp.device >> stamp.inode >> stamp.size >> stamp.modified_ns;
    if (numbers.fail() || stamp_text(stamp) != text) return {};
    return stamp;
}

}  // namespace glint
