#include "models/io/file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <new>
#include <sstream>
#include <system_error>

#include "models/io/descriptor.h"
#include "models/io/files_read.h"
#include "models/memory_limit.h"
#include "models/progress.h"

namespace glint {
namespace {

Problem cannot_read(const std::string& path, int error) {
    return cannot("read", path, error, "a regular file that can be read");
}

/// Asks for the file, links followed; returns 0 or the errno.
int ask_status(const std::string& path, struct stat& status) {
    if (path.find('\0') != std::string::npos) return ENOENT;
    return ::stat(path.c_str(), &status) == 0 ? 0 : errno;
}

std::optional<Problem> why_not_readable(const std::string& path, const struct stat& status) {
    const auto problem = [&](const char* what) { return Problem{path, "", what, "a regular file"}; };
    if (S_ISDIR(status.st_mode)) return problem("is a directory");
    if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) return problem("is a device");
    if (!S_ISREG(status.st_mode)) return problem("is a pipe or a socket");
    return std::nullopt;
}

Problem too_long(const std::string& path, std::size_t max_bytes) {
    return {path, "", "is too long", fmt::format("at most {} bytes", max_bytes)};
}

/// `guess`: the size that the system tells, which the file may pass while it is read.
Result<std::string> read_all(int descriptor, const std::string& path, std::size_t max_bytes,
                             std::size_t guess, const CheckBlock& check, MemoryShare& share) {
    if (guess > max_bytes) return too_long(path, max_bytes);
    std::string bytes;
    std::array<char, 1 << 16> block;  // NOLINT: filled by read
    for (;;) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count == 0) return bytes;
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return cannot_read(path, errno);
        const std::string_view read(block.data(), static_cast<std::size_t>(count));
        if (read.size() > max_bytes - bytes.size()) return too_long(path, max_bytes);
        if (check)
            if (auto problem = check({read, bytes.size(), guess})) return *problem;
        if (read.size() > bytes.capacity() - bytes.size()) {
            const std::size_t room = std::max({guess, bytes.size() + read.size(), 2 * bytes.size()});
            share.set(memory_need(MemoryUse::Files, room));
            bytes.reserve(room);
        }
        bytes.append(read);
        if (!report_progress(LoadStage::Reading, bytes.size(), guess))
            return Problem{path, "", cancelled_words, ""};
    }
}

Result<std::string> read_regular(const std::string& path, std::size_t max_bytes, const CheckBlock& check,
                                 MemoryShare& share) {
    struct stat status {};
    if (const int error = ask_status(path, status)) return cannot_read(path, error);
    // Asked before opening, which would wait at a pipe and may do things to a device; and again after.
    if (auto problem = why_not_readable(path, status)) return *problem;
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number() < 0 || ::fstat(file.number(), &status) != 0) return cannot_read(path, errno);
    if (auto problem = why_not_readable(path, status)) return *problem;
    note_read(path);
    return read_all(file.number(), path, max_bytes, static_cast<std::size_t>(status.st_size), check, share);
}

Result<std::string> read_standard_input(std::size_t max_bytes, const CheckBlock& check, MemoryShare& share) {
    static std::atomic<bool> was_read = false;
    if (was_read.exchange(true)) return Problem{"-", "", "standard input was read already", "it once"};
    return read_all(STDIN_FILENO, "-", max_bytes, 0, check, share);
}

}  // namespace

std::string reason(int error) {
    switch (error) {
    case ELOOP:
        return "a loop of symbolic links";
    case ENOSPC:
        return "no space left on the device";
    case EPIPE:
        return "the reader of the pipe has gone";
    default:
        break;
    }
    std::string words = std::generic_category().message(error);
    const bool is_acronym = words.size() > 1 && words[1] >= 'A' && words[1] <= 'Z';  // as RPC and NFS
    if (!words.empty() && words[0] >= 'A' && words[0] <= 'Z' && !is_acronym)
        words[0] = static_cast<char>(words[0] - 'A' + 'a');
    return words;
}

std::string lower_extension(const std::string& path) {
    const std::filesystem::path name = std::filesystem::path(path).filename();
    std::string extension = name.extension().string();
    if (extension.empty() && name.string().starts_with('.'))
        extension = name.string();  // ".png" ends so, too
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

std::optional<Problem> why_not_there(const std::string& path, const char* expected) {
    struct stat status {};
    if (const int error = ask_status(path, status)) return cannot("read", path, error, expected);
    return std::nullopt;
}

Result<std::string> read_file(const std::string& path, std::size_t max_bytes, const CheckBlock& check,
                              MemoryShare* share) {
    MemoryShare own;
    MemoryShare& taken = share == nullptr ? own : *share;
    try {
        if (path == "-") return read_standard_input(max_bytes, check, taken);
        return read_regular(path, max_bytes, check, taken);
    } catch (const Refused& refused) {
        return memory_problem(refused, path);
    } catch (const std::bad_alloc&) {
        return cannot_read(path, ENOMEM);
    }
}

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
