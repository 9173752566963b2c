// A library to be loaded (LD_PRELOAD) or linked before the C library. It reads these environment variables:
// GLINT_FAULT="KIND FIRST COUNT ERRNO" selects the failing calls. GLINT_FAULT_LOG=FILE receives a line for
// each file operation ("rename FROM TO", "fsync DESCRIPTOR PATH") and, at the end, one for each kind ("calls
// KIND N"). GLINT_FAULT_SOCKET=DESCRIPTOR receives faults in the format of GLINT_FAULT, one after another:
// for each fault, a copy of the process continues with its main(), and the copy's status, as returned by
// wait(), is sent back.
#include "tests/faults/failing_calls.h"

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace glint::faults {
namespace {

constexpr std::array<int, kinds> usual_errors{EACCES, EIO,    ENOSPC, EIO,   EIO,   EROFS,
                                              EACCES, ENOLCK, EPERM,  EROFS, EAGAIN};

std::array<std::atomic<long>, kinds> counts;
std::atomic<bool> is_on{false}, failed{false};
thread_local bool is_in_linker = false;  // glibc's dlopen() crashes if its own allocations fail
Fault fault;
int log_descriptor = -1;

/// The errno with which this call fails; 0 if it succeeds.
int failure(Kind kind) {
    if (!is_on || is_in_linker) return 0;
    const auto index = static_cast<std::size_t>(kind);
    const long number = counts[index]++;
    if (kind != fault.kind || number < fault.first || number - fault.first >= fault.count) return 0;
    failed = true;
    return fault.error != 0 ? fault.error : usual_errors[index];
}

/// Returns whether a call of this kind must fail. The caller then returns -1; errno is already set.
bool fails(Kind kind) {
    const int error = failure(kind);
    if (error != 0) errno = error;
    return error != 0;
}

/// Returns the library's own function of that name.
template <class Function> Function* real(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));  // NOLINT: the intended use of dlsym
}

/// Writes one line to the log with a direct system call, without allocating.
void log_line(const char* format, ...) __attribute__((format(printf, 1, 2)));
void log_line(const char* format, ...) {
    if (log_descriptor < 0 || !is_on) return;
    char line[2 * PATH_MAX];
    va_list arguments;
    va_start(arguments, format);
    // NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized): va_start() has set it
    const int length = std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    if (length > 0) (void)!::syscall(SYS_write, log_descriptor, line, std::size_t(length));
}

/// The path of a descriptor, for the log.
struct PathOf {
    char text[PATH_MAX] = "";
    explicit PathOf(int descriptor) {
        char link[64];
        std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
        const ssize_t length = ::readlink(link, text, sizeof text - 1);
        text[length < 0 ? 0 : length] = 0;
    }
};

void read_environment() {
    if (const char* const path = std::getenv("GLINT_FAULT_LOG"))
        log_descriptor =
            int(::syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600));
    const char* const text = std::getenv("GLINT_FAULT");
    char name[32] = "";
    Fault read;
    if (text == nullptr ||
        std::sscanf(text, "%31s %ld %ld %d", name, &read.first, &read.count, &read.error) != 4)
        read.first = LONG_MAX;
    for (int i = 0; i < kinds; ++i)
        if (std::strcmp(name, kind_names[std::size_t(i)]) == 0) read.kind = Kind(i);
    fault = read;
}

/// Empties the file to which standard output or standard error is redirected.
void empty(int descriptor) {
    (void)!::ftruncate(descriptor, 0);
    (void)::lseek(descriptor, 0, SEEK_SET);
}

/// Forks for each requested fault and returns in the copy of the process. This process ends when the socket
/// is closed.
void serve(int socket) {
    char asked[128];
    for (ssize_t length; (length = ::recv(socket, asked, sizeof asked - 1, 0)) > 0;) {
        asked[length] = 0;
        const pid_t copy = ::fork();
        if (copy == 0) {
            ::setenv("GLINT_FAULT", asked, 1);
            empty(STDOUT_FILENO);
            empty(STDERR_FILENO);
            (void)::close(socket);
            ::alarm(longest_run_s);
            return;
        }
        int status = 0;
        ::waitpid(copy, &status, 0);
        (void)::send(socket, &status, sizeof status, 0);
    }
    ::_exit(0);
}

int (*main_of_program)(int, char**, char**) = nullptr;

// main() may have a type other than the C library's.
__attribute__((no_sanitize("undefined"))) int counted_main(int count, char** arguments, char** environment) {
    if (const char* const socket = std::getenv("GLINT_FAULT_SOCKET"))
        serve(std::atoi(socket));  // NOLINT(cert-err34-c)
    read_environment();
    is_on = true;
    return main_of_program(count, arguments, environment);
}

__attribute__((destructor)) void log_counts() {
    for (int i = 0; i < kinds; ++i)
        log_line("calls %s %ld\n", kind_names[std::size_t(i)], counts[std::size_t(i)].load());
    is_on = false;
}

}  // namespace

void fail(const Fault& wanted) {
    is_on = false;
    fault = wanted;
    for (auto& count : counts) count = 0;
    failed = false;
    is_on = true;
}
void stop() { is_on = false; }
long calls(Kind kind) { return counts[static_cast<std::size_t>(kind)]; }
bool has_failed() { return failed; }

}  // namespace glint::faults

using glint::faults::fails;
using glint::faults::is_in_linker;
using glint::faults::Kind;
using glint::faults::log_line;
using glint::faults::PathOf;
using glint::faults::real;

// Their names and signatures are the C library's.
// NOLINTBEGIN
extern "C" {

// Only with LD_PRELOAD: a test that is linked with the library calls fail().
int __libc_start_main(int (*main)(int, char**, char**), int count, char** arguments, void (*init)(),
                      void (*fini)(), void (*linker_fini)(), void* stack_end) {
    using Start = int(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(), void (*)(), void*);
    glint::faults::main_of_program = main;
    bool asked = false;
    for (const char* const name : {"GLINT_FAULT", "GLINT_FAULT_LOG", "GLINT_FAULT_SOCKET"})
        asked |= std::getenv(name) != nullptr;
    return real<Start>("__libc_start_main")(asked ? glint::faults::counted_main : main, count, arguments,
                                            init, fini, linker_fini, stack_end);
}

#define GLINT_OPEN(name)                                                \
    int name(const char* path, int flags, ...) {                        \
        va_list arguments;                                              \
        va_start(arguments, flags);                                     \
        const mode_t mode = va_arg(arguments, mode_t);                  \
        va_end(arguments);                                              \
        log_line("open %s\n", path);                                    \
        if (fails(Kind::Open)) return -1;                               \
        return int(::syscall(SYS_openat, AT_FDCWD, path, flags, mode)); \
    }
GLINT_OPEN(open)
GLINT_OPEN(open64)

int openat(int directory, const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = va_arg(arguments, mode_t);
    va_end(arguments);
    if (fails(Kind::Open)) return -1;
    return int(::syscall(SYS_openat, directory, path, flags, mode));
}

FILE* fopen(const char* path, const char* mode) {
    static const auto next = real<FILE*(const char*, const char*)>("fopen");
    log_line("open %s\n", path);
    return fails(Kind::Open) ? nullptr : next(path, mode);
}
FILE* fopen64(const char* path, const char* mode) { return fopen(path, mode); }

DIR* opendir(const char* path) {
    static const auto next = real<DIR*(const char*)>("opendir");
    return fails(Kind::Open) ? nullptr : next(path);
}

int mkdir(const char* path, mode_t mode) {
    return fails(Kind::Open) ? -1 : int(::syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}

ssize_t read(int descriptor, void* bytes, size_t count) {
    return fails(Kind::Read) ? -1 : ::syscall(SYS_read, descriptor, bytes, count);
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
    const int error = glint::faults::failure(Kind::Write);
    const bool is_first = glint::faults::calls(Kind::Write) - 1 == glint::faults::fault.first;
    if (error == 0) return ::syscall(SYS_write, descriptor, bytes, count);
    if (is_first && glint::faults::fault.count > 1 && count > 1)
        return ::syscall(SYS_write, descriptor, bytes, count / 2);
    errno = error;
    return -1;
}

int fsync(int descriptor) {
    log_line("fsync %s\n", PathOf(descriptor).text);
    return fails(Kind::Fsync) ? -1 : int(::syscall(SYS_fsync, descriptor));
}

// As in the kernel: the descriptor is closed even on failure.
int close(int descriptor) {
    const int result = int(::syscall(SYS_close, descriptor));
    return fails(Kind::Close) ? -1 : result;
}

int rename(const char* from, const char* to) {
    log_line("rename %s %s\n", from, to);
    return fails(Kind::Rename) ? -1 : int(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int linkat(int from_directory, const char* from, int to_directory, const char* to, int flags) {
    log_line("link %s %s\n", from, to);
    return fails(Kind::Rename) ? -1
                               : int(::syscall(SYS_linkat, from_directory, from, to_directory, to, flags));
}

int unlink(const char* path) {
    log_line("unlink %s\n", path);
    return fails(Kind::Unlink) ? -1 : int(::syscall(SYS_unlinkat, AT_FDCWD, path, 0));
}

int stat(const char* path, struct stat* status) {
    return fails(Kind::Stat) ? -1 : int(::syscall(SYS_newfstatat, AT_FDCWD, path, status, 0));
}
int fstat(int descriptor, struct stat* status) {
    return fails(Kind::Stat) ? -1 : int(::syscall(SYS_newfstatat, descriptor, "", status, AT_EMPTY_PATH));
}
int access(const char* path, int mode) {
    return fails(Kind::Stat) ? -1 : int(::syscall(SYS_faccessat, AT_FDCWD, path, mode));
}

int flock(int descriptor, int operation) {
    return fails(Kind::Lock) ? -1 : int(::syscall(SYS_flock, descriptor, operation));
}

int fchmod(int descriptor, mode_t mode) {
    return fails(Kind::Mode) ? -1 : int(::syscall(SYS_fchmod, descriptor, mode));
}
int fchown(int descriptor, uid_t owner, gid_t group) {
    return fails(Kind::Mode) ? -1 : int(::syscall(SYS_fchown, descriptor, owner, group));
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                   void* argument) {
    using Create = int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto next = real<Create>("pthread_create");
    const int error = glint::faults::failure(Kind::Thread);
    return error != 0 ? error : next(thread, attributes, start, argument);
}

void* dlopen(const char* name, int flags) {
    static const auto next = real<void*(const char*, int)>("dlopen");
    is_in_linker = true;
    void* const library = next(name, flags);
    is_in_linker = false;
    return library;
}

}  // extern "C"
// NOLINTEND
