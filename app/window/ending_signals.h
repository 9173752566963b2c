#pragma once
// What asks the program from outside to end. The window first keeps what is not saved.

#include <array>
#include <csignal>
#include <thread>

namespace glint {

/// While it lives, SIGHUP, SIGINT and SIGTERM wake the window in place of ending the process. A second
/// signal, or five seconds in which the window has not ended, end the process as they would without it. A
/// signal that is ignored (nohup) stays ignored. Where no thread can wait for them, they end the process at
/// once. Preconditions: GLFW is initialised; there is one at a time.
class EndingSignals {
  public:
    EndingSignals();
    ~EndingSignals();
    EndingSignals(const EndingSignals&) = delete;
    EndingSignals& operator=(const EndingSignals&) = delete;

    /// Returns the signal that came; 0 if none has.
    [[nodiscard]] int number() const;

  private:
    void watch() const;
    void restore() const;

    static constexpr std::array taken{SIGHUP, SIGINT, SIGTERM};
    std::array<struct sigaction, taken.size()> before_{};
    std::array<int, 2> pipe_{-1, -1};
    std::thread watcher_;
};

}  // namespace glint
