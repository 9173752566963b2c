// Writing: beside the target and then into its place, or straight through.
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <climits>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <set>

#include "models/io/descriptor.h"
#include "models/io/file.h"
#include "models/io/temporary.h"

namespace glint {
namespace {

constexpr mode_t permission_bits = 07777;

Problem cannot_write(const std::string& path, int error) {
    return cannot("write", path == "-" ? "standard output" : path, error, "a place that can be written");
}

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

/// Returns the end of a chain of links, so that the link stays and the file that it names is replaced; the
/// end need not exist. A chain longer than the system follows is left for the system to refuse.
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

/// Where bytes for a path go.
struct Target {
    int error = 0;                   // errno of what keeps them from going anywhere
    int descriptor = -1;             // an open stream
    bool straight = false;           // it is written through, else replaced
    std::string path;                // links followed where it is replaced
    std::optional<struct stat> old;  // of the file to be replaced
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
        // Renaming would pass over a file that is write-protected.
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

/// Gives a file the owner, group and permission bits of an older one, as far as the system lets us. If the
/// group cannot be kept, the new group's members were among all others before, and the old group's members
/// now are. So the new group and others may only do what the old file let both its group and others do.
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

/// Writes the bytes into `file` and onto the disk, and gives it what is to be kept of the old one.
int fill(Temporary& file, std::string_view bytes, const std::optional<struct stat>& old) {
    if (file.error() != 0) return file.error();
    int error = write_all(file.descriptor(), bytes);
    if (error == 0 && old) error = take_after(file.descriptor(), *old);
    if (error == 0 && ::fsync(file.descriptor()) != 0) error = errno;
    const int close_error = file.close();
    return error != 0 ? error : close_error;
}

/// The mode of the temporary file of `target`: until it has the old file's permissions, only we may read it.
mode_t first_mode(const Target& target) { return target.old ? 0600 : 0666; }

/// "." where the path names none.
std::string directory_of_target(const std::string& path) {
    const std::string directory = path.substr(0, path.rfind('/') + 1);
    return directory.empty() ? "." : directory;
}

/// Puts a directory's entries on the disk, so that a new name outlives a loss of power. Where that cannot be
/// done (some file systems do not know it) the file is in its place all the same.
void sync_directory(const std::string& directory) {
    const Descriptor opened(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.number() >= 0) (void)::fsync(opened.number());
}

int put_in_place(Temporary& file, const Target& target) {
    const int error = file.put_in_place(target.path);
    if (error == 0) sync_directory(directory_of_target(target.path));
    return error;
}

int write_to(const Target& target, std::string_view bytes) {
    if (target.error != 0) return target.error;
    if (target.straight) return write_straight_through(target, bytes);
    Temporary file(target.path, first_mode(target));
    const int error = fill(file, bytes, target.old);
    return error != 0 ? error : put_in_place(file, target);
}

Result<std::monostate> written(const std::string& path, int error) {
    if (error != 0) return cannot_write(path, error);
    return std::monostate{};
}

}  // namespace

Result<std::monostate> write_file(const std::string& path, std::string_view bytes) {
    return written(path, write_to(target_of(path), bytes));
}

Result<std::monostate> write_file_at_once(const std::string& path, std::string_view bytes) {
    std::error_code ignored;
    if (std::filesystem::is_fifo(path, ignored))
        return Problem{path, "", "cannot write: is a pipe", "a file"};
    return write_file(path, bytes);
}

bool is_standard_output(const std::string& path) { return descriptor_named(path) == STDOUT_FILENO; }

/// Why a directory will not let the file be replaced: an errno, or 0.
static int why_not_replaceable(const Target& target) {
    const std::string directory = directory_of_target(target.path);
    if (::access(directory.c_str(), W_OK | X_OK) != 0) return errno;
    struct stat status {};
    if (!target.old || ::geteuid() == 0 || ::stat(directory.c_str(), &status) != 0) return 0;
    // In a sticky one, such as /tmp, only the owner of the file or of the directory may (rename(2)).
    const bool sticky = (status.st_mode & S_ISVTX) != 0;
    return sticky && target.old->st_uid != ::geteuid() && status.st_uid != ::geteuid() ? EPERM : 0;
}

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

struct FilesTogether::Staged {
    std::string path;  // as it was given
    Target target;
    std::string bytes;              // of what is written straight through
    std::optional<Temporary> file;  // of all else
};

FilesTogether::FilesTogether() = default;
FilesTogether::~FilesTogether() = default;

Result<std::monostate> FilesTogether::add(const std::string& path, std::string bytes) {
    Staged staged{path, target_of(path), {}, std::nullopt};
    if (staged.target.error != 0) return cannot_write(path, staged.target.error);
    if (staged.target.straight) {
        staged.bytes = std::move(bytes);
    } else {
        staged.file.emplace(staged.target.path, first_mode(staged.target));
        if (const int error = fill(*staged.file, bytes, staged.target.old); error != 0)
            return cannot_write(path, error);
    }
    files_.push_back(std::move(staged));
    return std::monostate{};
}

/// Puts all of them in their places and returns null; or none, and returns the one that was refused, and why
/// in `error`.
FilesTogether::Staged* FilesTogether::change_places(const std::vector<Staged*>& files, int& error) {
    const NoEndBetween no_end_between;
    for (auto at = files.begin(); at != files.end(); ++at) {
        error = (*at)->file->change_places((*at)->target.path);
        if (error == 0) continue;
        for (auto changed = at; changed != files.begin();) {
            --changed;
            (*changed)->file->take_back((*changed)->target.path);
        }
        return *at;
    }
    return nullptr;
}

Result<std::monostate> FilesTogether::put_in_place() {
    int error = 0;
    for (const Staged& staged : files_) {
        if (staged.target.straight) error = write_straight_through(staged.target, staged.bytes);
        if (error != 0) return cannot_write(staged.path, error);
    }
    std::vector<Staged*> staged;
    for (Staged& each : files_)
        if (each.file) staged.push_back(&each);
    if (staged.size() == 1)
        return written(staged[0]->path, glint::put_in_place(*staged[0]->file, staged[0]->target));
    std::set<std::string> directories;  // from here on nothing asks for memory before all are in place
    for (const Staged* each : staged) directories.insert(directory_of_target(each->target.path));
    if (const Staged* const refused = change_places(staged, error)) return cannot_write(refused->path, error);
    for (const std::string& directory : directories) sync_directory(directory);
    files_.clear();  // and what was there before
    return std::monostate{};
}

}  // namespace glint
