#include "app/window/ending_signals.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "ui/document/job.h"

namespace glint {
namespace {

constexpr int longest_wait_ms = 5000;
constexpr char came = 's', over = 'o';  // what is written into the pipe

std::atomic<int> first_number{0}, write_end{-1};
static_assert(std::atomic<int>::is_always_lock_free);

/// Calls nothing but async-signal-safe functions. GLFW's are not: the watcher calls them.
void note_signal(int number) {
    const int error = errno;
    int none = 0;
    first_number.compare_exchange_strong(none, number);
    (void)!::write(write_end, &came, 1);
    errno = error;
}

/// Returns what comes next out of the pipe; 0 where nothing comes for so long.
char next_of(int read_end, int wait_ms) {
    pollfd asked{read_end, POLLIN, 0};
    int found = 0;
    do found = ::poll(&asked, 1, wait_ms);
    while (found < 0 && errno == EINTR);
    char what = 0;
    if (found > 0) (void)!::read(read_end, &what, 1);
    return what;
}

}  // namespace

EndingSignals::EndingSignals() {
    first_number = 0;
    if (::pipe2(pipe_.data(), O_CLOEXEC) != 0) return;
    ::fcntl(pipe_[1], F_SETFL, O_NONBLOCK);  // a handler must not wait
    if (start_thread(watcher_, "", [this] { watch(); })) return;
    write_end = pipe_[1];
    struct sigaction action {};
    action.sa_handler = note_signal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < taken.size(); ++i) {
        ::sigaction(taken[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN) ::sigaction(taken[i], &action, nullptr);
    }
}

EndingSignals::~EndingSignals() {
    if (watcher_.joinable()) {
        restore();
        (void)!::write(pipe_[1], &over, 1);
        watcher_.join();
    }
    write_end = -1;
    for (const int end : pipe_)
        if (end >= 0) ::close(end);
}

int EndingSignals::number() const { return first_number; }

void EndingSignals::restore() const {
    for (std::size_t i = 0; i < taken.size(); ++i) ::sigaction(taken[i], &before_[i], nullptr);
}

void EndingSignals::watch() const {
    if (next_of(pipe_[0], -1) != came) return;
    glfwPostEmptyEvent();
    if (next_of(pipe_[0], longest_wait_ms) == over) return;
    restore();
    ::kill(::getpid(), first_number);
}

}  // namespace glint
