#pragma once
// An open file, and the words for what goes wrong with one. Inside models/ only.

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <utility>

#include "models/io/file.h"
#include "models/problem.h"

namespace glint {

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

/// "PATH: cannot VERB: the reason; expected ...".
inline Problem cannot(const char* verb, const std::string& path, int error, const char* expected) {
    return {path, "", fmt::format("cannot {}: {}", verb, reason(error)), expected};
}

}  // namespace glint
