#include "models/io/file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <climits>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <mutex>
#include <new>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "models/memory_limit.h"
#include "models/progress.h"

namespace glint {
namespace {

/// Closes its file descriptor on destruction, unless it is a standard stream.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int number() const { return number_; }
    /// Returns 0 or an errno: some file systems report a full disk only when a file is closed.
    int close() {
        const int number = std::exchange(number_, -1);
        return number > STDERR_FILENO && ::close(number) != 0 ? errno : 0;
    }

  private:
    int number_;
};

/// "PATH: cannot VERB: the reason; expected ...".
Problem cannot(const char* verb, const std::string& path, int error, const char* expected) {
    return {path, "", fmt::format("cannot {}: {}", verb, reason(error)), expected};
}

Problem cannot_read(const std::string& path, int error) {
    return cannot("read", path, error, "a readable regular file");
}

/// Calls stat(), following links; returns 0 or the errno.
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

/// `guess`: the size reported by the system; the file may grow while it is read.
Result<std::string> read_all(int descriptor, const std::string& path, std::size_t max_bytes,
                             std::size_t guess, const CheckBlock& check) {
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
        if (read.size() > bytes.capacity() - bytes.size())
            bytes.reserve(std::max({guess, bytes.size() + read.size(), 2 * bytes.size()}));
        bytes.append(read);
        if (!report_progress(LoadStage::Reading, bytes.size(), guess))
            return Problem{path, "", cancelled_words, ""};
    }
}

/// The files that this process has read, by their names from replaced_file().
struct FilesRead {
    std::mutex mutex;
    std::set<std::string> files;
};
FilesRead& files_read() {
    static FilesRead all;
    return all;
}

void note_read(const std::string& path) {
    const std::string replaced = replaced_file(path);
    const std::lock_guard lock(files_read().mutex);
    files_read().files.insert(replaced);
}

Result<std::string> read_regular(const std::string& path, std::size_t max_bytes, const CheckBlock& check) {
    struct stat status {};
    if (const int error = ask_status(path, status)) return cannot_read(path, error);
    // Check before opening, because opening blocks on a pipe and may have side effects on a device; check
    // again afterwards.
    if (auto problem = why_not_readable(path, status)) return *problem;
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number() < 0 || ::fstat(file.number(), &status) != 0) return cannot_read(path, errno);
    if (auto problem = why_not_readable(path, status)) return *problem;
    note_read(path);
    return read_all(file.number(), path, max_bytes, static_cast<std::size_t>(status.st_size), check);
}

Result<std::string> read_standard_input(std::size_t max_bytes, const CheckBlock& check) {
    static std::atomic<bool> was_read = false;
    if (was_read.exchange(true))
        return Problem{"-", "", "standard input has already been read", "only one use of it"};
    return read_all(STDIN_FILENO, "-", max_bytes, 0, check);
}

constexpr mode_t permission_bits = 07777;

Problem cannot_write(const std::string& path, int error) {
    return cannot("write", path == "-" ? "standard output" : path, error, "a writable file");
}

/// Writing to a pipe without a reader sends SIGPIPE, which by default ends the process silently. During the
/// lifetime of this object the thread gets EPIPE instead.
class NoSigpipe {
  public:
    NoSigpipe() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    }
    ~NoSigpipe() {
        if (sigismember(&before_, SIGPIPE) == 1) return;
        const timespec now{};
        while (sigtimedwait(&pipe_, nullptr, &now) == SIGPIPE) {  // remove the signal that we caused
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    NoSigpipe(const NoSigpipe&) = delete;
    NoSigpipe& operator=(const NoSigpipe&) = delete;

  private:
    sigset_t pipe_{}, before_{};
};

/// 0 or the errno of the failure.
int write_all(int descriptor, std::string_view bytes) {
    const NoSigpipe no_sigpipe;
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 30));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

/// Resolves a chain of links, so that writing keeps the links and replaces the file at their end. That file
/// need not exist. The system rejects a chain that is too long.
std::string follow_links(std::string path) {
    std::array<char, PATH_MAX> target;  // NOLINT: filled by readlink
    for (int i = 0; i < 40; ++i) {
        const ssize_t length = ::readlink(path.c_str(), target.data(), target.size());
        if (length < 0) return path;
        const std::string next(target.data(), static_cast<std::size_t>(length));
        path.erase(next.starts_with('/') ? 0 : path.rfind('/') + 1);
        path += next;
    }
    return path;
}

/// The open descriptor that a name such as /dev/stdout denotes, or -1. The file behind it must not be
/// replaced: another process has it open.
int descriptor_named(const std::string& path) {
    if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view directory : {"/dev/fd/", "/proc/self/fd/"}) {
        int number = -1;
        if (!path.starts_with(directory)) continue;
        const char* const end = path.data() + path.size();
        const auto [rest, error] = std::from_chars(path.data() + directory.size(), end, number);
        if (error == std::errc{} && rest == end) return number;
    }
    return -1;
}

/// Where the bytes for a path are written.
struct Target {
    int error = 0;                   // errno if nothing can be written
    int descriptor = -1;             // an open stream
    bool straight = false;           // written in place; false: replaced
    std::string path;                // links followed if the file is replaced
    std::optional<struct stat> old;  // the status of the file to be replaced
};

Target target_of(const std::string& path) {
    Target target;
    target.path = path;
    target.descriptor = descriptor_named(path);
    target.straight = target.descriptor >= 0;
    if (target.straight) return target;
    struct stat status {};
    if (path.empty() || path.find('\0') != std::string::npos) {
        target.error = ENOENT;
    } else if (::stat(path.c_str(), &status) != 0) {
        target.error = errno != ENOENT ? errno : path.ends_with('/') ? EISDIR : 0;
        target.path = follow_links(path);
    } else if (S_ISDIR(status.st_mode)) {
        target.error = EISDIR;
    } else {
        target.straight = !S_ISREG(status.st_mode);
        // Checked because renaming ignores write protection.
        if (::access(path.c_str(), W_OK) != 0) target.error = errno;
        if (!target.straight) target.old = status;
        if (!target.straight) target.path = follow_links(path);
    }
    return target;
}

int write_straight_through(const Target& target, std::string_view bytes) {
    if (target.descriptor >= 0) return write_all(target.descriptor, bytes);
    Descriptor file(::open(target.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    if (file.number() < 0) return errno;
    const int error = write_all(file.number(), bytes);
    const int close_error = file.close();
    return error != 0 ? error : close_error;
}

/// Gives a file the owner, group and permission bits of an older one, if the system allows it. If the group
/// cannot be kept, members of the new group were "others" before, and members of the old group are "others"
/// now. So the new group and others get only the rights that the old file gave to both its group and others.
int take_after(int descriptor, const struct stat& old) {
    struct stat now {};
    if (::fstat(descriptor, &now) != 0) return errno;
    if (now.st_uid != old.st_uid || now.st_gid != old.st_gid) {
        if (::fchown(descriptor, old.st_uid, old.st_gid) != 0)
            (void)!::fchown(descriptor, static_cast<uid_t>(-1), old.st_gid);
        if (::fstat(descriptor, &now) != 0) return errno;
    }
    mode_t mode = old.st_mode & permission_bits;
    if (now.st_uid != old.st_uid) mode &= ~mode_t{S_ISUID};
    if (now.st_gid != old.st_gid) {
        const mode_t both = mode >> 3 & mode & mode_t{S_IRWXO};
        mode = (mode & ~mode_t{S_ISGID | S_IRWXG | S_IRWXO}) | both << 3 | both;
    }
    return ::fchmod(descriptor, mode) != 0 ? errno : 0;
}

/// Returns the directory of a path; "." if the path names none.
std::string directory_of_target(const std::string& path) {
    const std::string directory = path.substr(0, path.rfind('/') + 1);
    return directory.empty() ? "." : directory;
}

/// Syncs a directory's entries to the disk, so that a new name survives a power failure. Some file systems
/// cannot do that. This is not an error: the file is complete.
void sync_directory(const std::string& directory) {
    const Descriptor opened(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.number() >= 0) (void)::fsync(opened.number());
}

/// Calls `make` with names for a temporary file next to `target` until it does not fail with EEXIST. Returns
/// the name of the created file; on failure it is empty and `error` is set.
template <class Make> std::string new_name(const std::string& target, int& error, const Make& make) {
    static std::atomic<unsigned> counter = 0;
    const std::string directory = target.substr(0, target.rfind('/') + 1);
    error = EEXIST;
    for (int attempt = 0; error == EEXIST && attempt < 100; ++attempt) {
        std::string name = fmt::format("{}.glint-{}-{}.tmp", directory, ::getpid(), counter++);
        error = make(name.c_str()) >= 0 ? 0 : errno;
        if (error == 0) return name;
    }
    return {};
}

/// Writes a new file next to the target, then renames it over the target. Returns 0 or an errno. A file
/// opened with O_TMPFILE gets its name only once it is complete, so a killed process leaves no file behind.
int replace(const Target& target, std::string_view bytes, bool unnamed) {
    const mode_t mode = target.old ? 0600 : 0666;  // until it has the old file's permissions
    int error = 0, number = -1;
    std::string name;
    if (unnamed) {
        number = ::open(directory_of_target(target.path).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
        if (number < 0) return errno;
    } else {
        name = new_name(target.path, error, [&](const char* path) {
            return number = ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        });
        if (error != 0) return error;
    }
    Descriptor file(number);
    error = write_all(number, bytes);
    if (error == 0 && target.old) error = take_after(number, *target.old);
    if (error == 0 && ::fsync(number) != 0) error = errno;
    if (error == 0 && unnamed)
        name = new_name(target.path, error, [link = fmt::format("/proc/self/fd/{}", number)](auto path) {
            return ::linkat(AT_FDCWD, link.c_str(), AT_FDCWD, path, AT_SYMLINK_FOLLOW);
        });
    const int close_error = file.close();
    if (error == 0) error = close_error;
    if (error == 0 && ::rename(name.c_str(), target.path.c_str()) != 0) error = errno;
    if (error == 0) sync_directory(directory_of_target(target.path));
    if (error != 0 && !name.empty()) ::unlink(name.c_str());
    return error;
}

int write_to(const Target& target, std::string_view bytes) {
    if (target.error != 0) return target.error;
    if (target.straight) return write_straight_through(target, bytes);
    if (replace(target, bytes, true) == 0) return 0;
    return replace(target, bytes, false);  // as on file systems without O_TMPFILE
}

/// Returns the errno that prevents replacing the target, or 0.
int why_not_replaceable(const Target& target) {
    const std::string directory = directory_of_target(target.path);
    if (::access(directory.c_str(), W_OK | X_OK) != 0) return errno;
    struct stat status {};
    if (!target.old || ::geteuid() == 0 || ::stat(directory.c_str(), &status) != 0) return 0;
    // In a sticky directory such as /tmp, only the owner of the file or of the directory may rename it
    // (rename(2)).
    const bool sticky = (status.st_mode & S_ISVTX) != 0;
    return sticky && target.old->st_uid != ::geteuid() && status.st_uid != ::geteuid() ? EPERM : 0;
}

}  // namespace

std::string reason(int error) {
    switch (error) {
    case ELOOP:
        return "a loop of symbolic links";
    case ENOSPC:
        return "no space left on the device";
    case EPIPE:
        return "the pipe no longer has a reader";
    default:
        break;
    }
    std::string words = std::generic_category().message(error);
    const bool is_acronym = words.size() > 1 && words[1] >= 'A' && words[1] <= 'Z';  // such as RPC and NFS
    if (!words.empty() && words[0] >= 'A' && words[0] <= 'Z' && !is_acronym)
        words[0] = static_cast<char>(words[0] - 'A' + 'a');
    return words;
}

std::string lower_extension(const std::string& path) {
    const std::filesystem::path name = std::filesystem::path(path).filename();
    std::string extension = name.extension().string();
    if (extension.empty() && name.string().starts_with('.'))
        extension = name.string();  // a file named ".png" counts as having this extension
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

std::optional<Problem> why_not_there(const std::string& path, const char* expected) {
    struct stat status {};
    if (const int error = ask_status(path, status)) return cannot("read", path, error, expected);
    return std::nullopt;
}

Result<std::string> read_file(const std::string& path, std::size_t max_bytes, const CheckBlock& check) {
    if (path == "-") return read_standard_input(max_bytes, check);
    return read_regular(path, max_bytes, check);
}

Result<std::monostate> write_file(const std::string& path, std::string_view bytes) {
    if (const int error = write_to(target_of(path), bytes); error != 0) return cannot_write(path, error);
    return std::monostate{};
}

Result<std::monostate> write_file_at_once(const std::string& path, std::string_view bytes) {
    std::error_code ignored;
    if (std::filesystem::is_fifo(path, ignored))
        return Problem{path, "", "cannot write: is a pipe", "a file"};
    return write_file(path, bytes);
}

bool is_standard_output(const std::string& path) { return descriptor_named(path) == STDOUT_FILENO; }

std::optional<Problem> why_not_writable(const std::string& path) {
    const Target target = target_of(path);
    int error = target.error;
    if (error == 0 && !target.straight) error = why_not_replaceable(target);
    if (error != 0) return cannot_write(path, error);
    return std::nullopt;
}

std::string replaced_file(const std::string& path) {
    const Target target = target_of(path);
    if (target.error != 0 || target.straight) return {};
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(target.path, ignored), ignored);
}

bool was_read(const std::string& path) {
    const std::string replaced = replaced_file(path);
    const std::lock_guard lock(files_read().mutex);
    return !replaced.empty() && files_read().files.count(replaced) > 0;
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
