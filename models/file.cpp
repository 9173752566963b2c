#include "models/file.h"

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
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "models/progress.h"

namespace glint {
namespace {

constexpr mode_t permission_bits = 07777;

/// The reason in lower case, as it stands inside a line.
std::string reason(int error) {
    switch (error) {
    case ENOENT:
        return "no such file or directory";
    case EACCES:
        return "permission denied";
    case EISDIR:
        return "is a directory";
    case ENOSPC:
        return "no space left on the device";
    case EPIPE:
        return "the reader of the pipe has gone";
    default:
        return std::generic_category().message(error);
    }
}

Problem cannot(const char* verb, const std::string& path, int error, const char* expected) {
    return {path, "", fmt::format("cannot {}: {}", verb, reason(error)), expected};
}
Problem cannot_read(const std::string& path, int error) {
    return cannot("read", path, error, "a regular file that can be read");
}
Problem cannot_write(const std::string& path, int error) {
    return cannot("write", path, error, "a place that can be written");
}

/// A file descriptor that is closed at the end, unless it is a standard stream.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int number() const { return number_; }
    /// 0, or the errno of closing: some file systems report a full disk only here.
    int close() {
        const int number = std::exchange(number_, -1);
        return number > STDERR_FILENO && ::close(number) != 0 ? errno : 0;
    }

  private:
    int number_;
};

/// Writing to a pipe that nobody reads sends SIGPIPE, whose default is to end the process without a word.
/// While this lives, this thread gets EPIPE instead.
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
        while (sigtimedwait(&pipe_, nullptr, &now) == SIGPIPE) {  // take back what we caused
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    NoSigpipe(const NoSigpipe&) = delete;
    NoSigpipe& operator=(const NoSigpipe&) = delete;

  private:
    sigset_t pipe_{}, before_{};
};

std::optional<Problem> why_not_readable(const std::string& path, const struct stat& status) {
    const auto problem = [&](const char* what) { return Problem{path, "", what, "a regular file"}; };
    if (S_ISDIR(status.st_mode)) return problem("is a directory");
    if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) return problem("is a device");
    if (!S_ISREG(status.st_mode)) return problem("is a pipe or a socket");
    return std::nullopt;
}

Result<std::string> read_all(int descriptor, const std::string& path, std::size_t max_bytes,
                             std::size_t guess) {
    std::string bytes;
    bytes.reserve(std::min(guess, max_bytes));
    std::array<char, 1 << 16> block;  // NOLINT: filled by read
    for (;;) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count == 0) return bytes;
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return cannot_read(path, errno);
        if (static_cast<std::size_t>(count) > max_bytes - bytes.size())
            return Problem{path, "", "is too long", fmt::format("at most {} bytes", max_bytes)};
        bytes.append(block.data(), static_cast<std::size_t>(count));
        if (!report_progress(LoadStage::Reading, bytes.size(), guess))
            return Problem{path, "", cancelled_words, ""};
    }
}

Result<std::string> read_regular(const std::string& path, std::size_t max_bytes) {
    struct stat status {};
    if (path.find('\0') != std::string::npos) return cannot_read(path, ENOENT);
    if (::stat(path.c_str(), &status) != 0) return cannot_read(path, errno);
    // Asked before opening, which would wait at a pipe and may do things to a device; and again after.
    if (auto problem = why_not_readable(path, status)) return *problem;
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number() < 0 || ::fstat(file.number(), &status) != 0) return cannot_read(path, errno);
    if (auto problem = why_not_readable(path, status)) return *problem;
    return read_all(file.number(), path, max_bytes, static_cast<std::size_t>(status.st_size));
}

/// 0, or the errno of what went wrong.
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

/// What a chain of links ends at, so that the link stays and what it names is replaced; the end need not
/// exist. More links than the system follows are left to it to refuse.
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

int write_straight_through(const std::string& path, std::string_view bytes) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    if (file.number() < 0) return errno;
    const int error = write_all(file.number(), bytes);
    const int close_error = file.close();
    return error != 0 ? error : close_error;
}

struct Temporary {
    std::string path;
    int descriptor = -1;
};

/// A new, empty file in the directory of `target`. Its permission bits follow the umask, as any new file's
/// do.
Temporary make_beside(const std::string& target) {
    static std::atomic<unsigned> counter = 0;
    const std::string directory = target.substr(0, target.rfind('/') + 1);
    for (int attempt = 0; attempt < 100; ++attempt) {  // names left by a crash are passed over
        std::string path = fmt::format("{}.glint-{}-{}.tmp", directory, ::getpid(), counter++);
        const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0 || errno != EEXIST) return {std::move(path), descriptor};
    }
    return {};
}

/// Writes a new file and puts it in the place of `target`. `old_mode` is 0 when there is no old file.
int replace(const std::string& target, std::string_view bytes, mode_t old_mode) {
    const Temporary temporary = make_beside(target);
    if (temporary.descriptor < 0) return errno;
    Descriptor file(temporary.descriptor);
    int error = write_all(file.number(), bytes);
    if (error == 0 && old_mode != 0 && ::fchmod(file.number(), old_mode & permission_bits) != 0)
        error = errno;
    if (error == 0 && ::fsync(file.number()) != 0) error = errno;
    const int close_error = file.close();
    if (error == 0) error = close_error;
    if (error == 0 && ::rename(temporary.path.c_str(), target.c_str()) != 0) error = errno;
    if (error != 0) ::unlink(temporary.path.c_str());
    return error;
}

/// The open descriptor that a name such as /dev/stdout stands for, or -1. The file behind it is not to be
/// replaced: whoever opened it for us still holds it.
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

int write_to(const std::string& path, std::string_view bytes) {
    if (const int descriptor = descriptor_named(path); descriptor >= 0) return write_all(descriptor, bytes);
    struct stat status {};
    if (path.empty() || path.find('\0') != std::string::npos) return ENOENT;
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (!exists && errno != ENOENT) return errno;
    if (!exists && path.ends_with('/')) return EISDIR;
    if (!exists) return replace(follow_links(path), bytes, 0);
    if (S_ISDIR(status.st_mode)) return EISDIR;
    if (!S_ISREG(status.st_mode)) return write_straight_through(path, bytes);
    if (::access(path.c_str(), W_OK) != 0)
        return errno;  // renaming would pass over a file that is write-protected
    return replace(follow_links(path), bytes, status.st_mode);
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::size_t max_bytes) {
    try {
        if (path == "-") return read_all(STDIN_FILENO, path, max_bytes, 0);
        return read_regular(path, max_bytes);
    } catch (const std::bad_alloc&) {
        return cannot_read(path, ENOMEM);
    }
}

Result<std::monostate> write_file(const std::string& path, std::string_view bytes) {
    if (const int error = write_to(path, bytes); error != 0) return cannot_write(path, error);
    return std::monostate{};
}

}  // namespace glint
