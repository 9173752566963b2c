#include "models/io/left_files.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <ctime>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>

namespace glint {
namespace {

/// The process that made a temporary file, by its name; nothing for any other name.
std::optional<pid_t> maker_of(std::string_view name) {
    constexpr std::string_view head = ".glint-", tail = ".tmp";
    if (!name.starts_with(head) || !name.ends_with(tail) || name.size() < head.size() + tail.size())
        return {};
    const char* at = name.data() + head.size();
    const char* const end = name.data() + name.size() - tail.size();
    pid_t maker = 0;
    unsigned number = 0;
    const auto [dash, bad_maker] = std::from_chars(at, end, maker);
    if (bad_maker != std::errc{} || dash == end || *dash != '-' || maker <= 0) return {};
    const auto [rest, bad_number] = std::from_chars(dash + 1, end, number);
    if (bad_number != std::errc{} || rest != end) return {};
    return maker;
}

/// Whether the process may be gone. Our own id may be that of an earlier process, say of another container;
/// then the lock decides.
bool is_gone(pid_t maker) { return maker == ::getpid() || (::kill(maker, 0) != 0 && errno == ESRCH); }

/// Whether the file was not written for the last 60 seconds. A maker that still lives has locked it long ago,
/// and the process that has the maker's id now may be another one: the lock decides.
bool is_old(const struct stat& file) {
    constexpr time_t seconds = 60;
    return file.st_mtim.tv_sec + seconds < ::time(nullptr);
}

/// Removes a file that a process has left behind, if it is this user's and nobody holds its lock.
void remove_if_left(int directory, const char* name, pid_t maker) {
    const int file = ::openat(directory, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return;
    struct stat opened {
    }, named{};
    const bool left = ::fstat(file, &opened) == 0 && S_ISREG(opened.st_mode) &&
                      (is_gone(maker) || is_old(opened)) && opened.st_uid == ::geteuid() &&
                      ::flock(file, LOCK_EX | LOCK_NB) == 0 &&
                      ::fstatat(directory, name, &named, AT_SYMLINK_NOFOLLOW) == 0 &&
                      opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
    if (left) ::unlinkat(directory, name, 0);
    ::close(file);
}

void remove_all_left(const std::string& directory) {
    static std::mutex one_at_a_time;
    static std::set<std::string> seen;
    const std::lock_guard lock(one_at_a_time);
    if (!seen.insert(directory).second) return;
    DIR* const entries = ::opendir(directory.empty() ? "." : directory.c_str());
    if (entries == nullptr) return;
    while (const dirent* entry = ::readdir(entries)) {
        const std::optional<pid_t> maker = maker_of(entry->d_name);
        if (maker) remove_if_left(::dirfd(entries), entry->d_name, *maker);
    }
    ::closedir(entries);
}

}  // namespace

void remove_left_files(const std::string& directory) noexcept {
    try {
        remove_all_left(directory);
    } catch (const std::exception&) {
    }
}

}  // namespace glint
