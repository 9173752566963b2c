#include "models/io/temporary.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <pthread.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include "models/io/left_files.h"

namespace glint {
namespace {

constexpr std::array ending_signals{SIGHUP, SIGINT, SIGQUIT, SIGTERM};

/// A file or a directory that a signal handler may have to remove. Only the thread that claims a slot writes
/// its path.
enum class Slot { Free, Opening, There };
struct Known {
    std::atomic<Slot> slot{Slot::Free};
    std::array<char, PATH_MAX> path{};
};
std::array<Known, 64> known;  // as many as are written at once; more are not known to the handler
std::atomic<bool> ending{false};
std::atomic<int> between{0};  // NoEndBetween that live
static_assert(std::atomic<Slot>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
              std::atomic<int>::is_always_lock_free);

[[noreturn]] void wait_for_the_end() {
    for (;;) ::pause();
}

/// Blocks the ending signals on this thread: a handler that waits for what this thread does would wait for
/// ever. Returns the signals that were blocked before.
sigset_t keep_signals_off() {
    sigset_t signals, before;
    sigemptyset(&signals);
    for (const int number : ending_signals) sigaddset(&signals, number);
    pthread_sigmask(SIG_BLOCK, &signals, &before);
    return before;
}

class NoEndHere {
  public:
    NoEndHere() : before_(keep_signals_off()) {}
    ~NoEndHere() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    NoEndHere(const NoEndHere&) = delete;
    NoEndHere& operator=(const NoEndHere&) = delete;

  private:
    sigset_t before_;
};

/// Claims a slot for this path, with the state Opening; -1 when none is left or the path is too long.
int claim_slot(const std::string& path) {
    if (path.size() >= PATH_MAX) return -1;
    for (std::size_t i = 0; i < known.size(); ++i) {
        Slot expected = Slot::Free;
        if (!known[i].slot.compare_exchange_strong(expected, Slot::Opening)) continue;
        std::memcpy(known[i].path.data(), path.c_str(), path.size() + 1);
        return static_cast<int>(i);
    }
    return -1;
}

void set_slot(int slot, Slot to) {
    if (slot >= 0) known[static_cast<std::size_t>(slot)].slot = to;
}

bool any_opening() {
    for (const Known& k : known)
        if (k.slot == Slot::Opening) return true;
    return false;
}

void end_by(int number) {
    remove_temporaries();
    ::signal(number, SIG_DFL);
    sigset_t signal;
    sigemptyset(&signal);
    sigaddset(&signal, number);
    pthread_sigmask(SIG_UNBLOCK, &signal, nullptr);
    ::raise(number);
}

}  // namespace

Temporary::Temporary(const std::string& target, mode_t mode) {
    static std::atomic<unsigned> counter = 0;
    const std::string directory = target.substr(0, target.rfind('/') + 1);
    for (int attempt = 0; attempt < 100; ++attempt) {
        if (make(fmt::format("{}.glint-{}-{}.tmp", directory, ::getpid(), counter++), mode)) break;
        if (error_ != EEXIST) return;
    }
    if (is_there_) remove_left_files(directory);
}

/// Makes the file; returns false with error_ set, EEXIST where another name should be tried.
bool Temporary::make(const std::string& path, mode_t mode) {
    const NoEndHere no_end_here;
    path_ = path;  // from here on nothing asks for memory
    slot_ = claim_slot(path);
    if (ending) {
        set_slot(slot_, Slot::Free);
        wait_for_the_end();
    }
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    error_ = descriptor_ < 0 ? errno : 0;
    struct stat status {};
    // A process that looks for left files may have found this one before it was locked. Where the file system
    // has no locks, nobody can take one, and nothing is removed.
    const bool taken =
        descriptor_ >= 0 && ((::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) ||
                             (::fstat(descriptor_, &status) == 0 && status.st_nlink == 0));
    if (taken) {
        ::close(std::exchange(descriptor_, -1));
        error_ = EEXIST;
    }
    is_there_ = error_ == 0;
    set_slot(slot_, is_there_ ? Slot::There : Slot::Free);
    if (!is_there_) slot_ = -1;
    return is_there_;
}

Temporary::Temporary(Temporary&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      lock_(std::exchange(other.lock_, -1)),
      error_(other.error_),
      slot_(std::exchange(other.slot_, -1)),
      is_there_(std::exchange(other.is_there_, false)),
      change_(other.change_) {}

Temporary::~Temporary() {
    if (is_there_) ::unlink(path_.c_str());
    set_slot(slot_, Slot::Free);
    if (descriptor_ >= 0) ::close(descriptor_);
    if (lock_ >= 0) ::close(lock_);
}

int Temporary::close() {
    lock_ = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);  // holds the lock on
    return ::close(std::exchange(descriptor_, -1)) != 0 ? errno : 0;
}

int Temporary::put_in_place(const std::string& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) {
        const int error = errno;
        if (ending) wait_for_the_end();  // it was removed under our hands
        return error;
    }
    is_there_ = false;
    set_slot(std::exchange(slot_, -1), Slot::Free);
    return 0;
}

int Temporary::change_places(const std::string& target) {
    struct stat status {};
    const int refused = ::lstat(target.c_str(), &status) == 0 ? 0 : errno;
    if (refused == 0 && S_ISREG(status.st_mode)) {
        if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) {
            change_ = Change::Exchanged;
            return 0;
        }
        if (errno != EINVAL && errno != ENOSYS) return errno;
    }
    const int error = put_in_place(target);
    if (error == 0 && refused == ENOENT) change_ = Change::Alone;
    return error;
}

void Temporary::take_back(const std::string& target) {
    if (change_ == Change::Exchanged)
        (void)::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE);
    if (change_ == Change::Alone) ::unlink(target.c_str());
    change_ = Change::None;
}

NewDirectory::NewDirectory(const std::string& path) : path_(path) {
    constexpr mode_t all_permissions = 0777;  // the umask is taken off
    const NoEndHere no_end;
    slot_ = claim_slot(path);
    error_ = ::mkdir(path.c_str(), all_permissions) == 0 ? 0 : errno;
    goes_ = error_ == 0;
    set_slot(slot_, goes_ ? Slot::There : Slot::Free);
}

NewDirectory::~NewDirectory() {
    if (!goes_) return;
    const NoEndHere no_end;
    ::rmdir(path_.c_str());
    set_slot(slot_, Slot::Free);
}

void NewDirectory::keep() {
    if (!goes_) return;
    set_slot(slot_, Slot::Free);
    goes_ = false;
}

FolderLock::FolderLock(const std::string& folder, double patience)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0) return;
    const auto taken_by_other = [this] {
        return ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    };
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
    while (!(held_ = !taken_by_other()) && std::chrono::steady_clock::now() < until)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

NoEndBetween::NoEndBetween() : before_(keep_signals_off()) {
    ++between;
    if (ending) {
        --between;
        wait_for_the_end();
    }
}

NoEndBetween::~NoEndBetween() {
    --between;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void remove_temporaries() {
    ending = true;
    constexpr int tries = 200, wait_ms = 5;  // a file system that hangs must not keep a process from ending
    for (int i = 0; i < tries && (any_opening() || between > 0); ++i) ::poll(nullptr, 0, wait_ms);
    for (const Known& k : known)
        if (k.slot == Slot::There) ::unlink(k.path.data());
    for (const Known& k : known)  // where it is an empty directory
        if (k.slot == Slot::There) ::rmdir(k.path.data());
}

void remove_temporaries_on_signals() {
    struct sigaction action {};
    action.sa_handler = end_by;
    sigemptyset(&action.sa_mask);
    for (const int number : ending_signals) sigaddset(&action.sa_mask, number);
    for (const int number : ending_signals) {
        struct sigaction before {};
        if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
            ::sigaction(number, &action, nullptr);
    }
}

}  // namespace glint
