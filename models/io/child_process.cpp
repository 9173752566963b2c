#include "models/io/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

namespace glint {
namespace {

/// A file in memory. Unlike a pipe, it accepts any number of bytes without a reader.
class MemoryFile {
  public:
    explicit MemoryFile(const char* name) : descriptor_(memfd_create(name, MFD_CLOEXEC)) {}
    ~MemoryFile() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] int descriptor() const { return descriptor_; }
    /// Writes the bytes and rewinds, so that the next reader starts at the first byte. Returns false on
    /// failure.
    [[nodiscard]] bool fill(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
            if (n <= 0) return false;
            bytes.remove_prefix(static_cast<std::size_t>(n));
        }
        return lseek(descriptor_, 0, SEEK_SET) == 0;
    }
    [[nodiscard]] std::string bytes() const {
        const off_t size = lseek(descriptor_, 0, SEEK_END);
        std::string all(static_cast<std::size_t>(std::max<off_t>(size, 0)), '\0');
        std::size_t at = 0;
        while (at < all.size()) {
            const ssize_t n = pread(descriptor_, &all[at], all.size() - at, static_cast<off_t>(at));
            if (n <= 0) break;
            at += static_cast<std::size_t>(n);
        }
        all.resize(at);
        return all;
    }

  private:
    int descriptor_;
};

/// The status of waitpid() if the process has ended.
std::optional<int> ended(pid_t child, int options) {
    int status = 0;
    pid_t found = 0;
    do found = waitpid(child, &status, options);
    while (found < 0 && errno == EINTR);
    return found == child ? std::optional(status) : std::nullopt;
}

/// Waits until the process ends; kills it when a limit is reached.
void wait_for(pid_t child, const ChildLimits& limits, ChildEnd& end) {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::duration<double>(limits.seconds);
    std::optional<int> status;
    while (!(status = ended(child, WNOHANG))) {
        const bool is_cancelled = limits.is_cancelled && limits.is_cancelled();
        if (is_cancelled || Clock::now() >= deadline) {
            end.how = is_cancelled ? ChildEnd::How::Cancelled : ChildEnd::How::TimedOut;
            kill(child, SIGKILL);
            (void)ended(child, 0);
            return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    end.how = WIFEXITED(*status) ? ChildEnd::How::Exited : ChildEnd::How::Killed;
    end.status = WIFEXITED(*status) ? WEXITSTATUS(*status) : WTERMSIG(*status);
}

void limit_memory([[maybe_unused]] pid_t child, [[maybe_unused]] std::uint64_t bytes) {
#ifndef GLINT_SANITIZED
    const rlimit limit{bytes, bytes};
    if (bytes > 0) (void)prlimit(child, RLIMIT_AS, &limit, nullptr);
#endif
}

}  // namespace

ChildEnd run_child(const std::string& worker, const std::vector<std::string>& arguments,
                   std::string_view input, const ChildLimits& limits) {
    ChildEnd end;
    const MemoryFile in("input"), out("output"), errors("errors");
    if (!in.fill(input) || out.descriptor() < 0 || errors.descriptor() < 0) {
        end.status = errno;
        return end;
    }
    std::vector<std::string> words{worker};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, in.descriptor(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, out.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, errors.descriptor(), STDERR_FILENO);
    pid_t child = 0;
    end.status = posix_spawn(&child, limits.program.c_str(), &files, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (end.status != 0) return end;
    limit_memory(child, limits.bytes);
    wait_for(child, limits, end);
    end.output = out.bytes();
    end.errors = errors.bytes();
    return end;
}

void end_with_parent() { (void)prctl(PR_SET_PDEATHSIG, SIGKILL); }

}  // namespace glint
