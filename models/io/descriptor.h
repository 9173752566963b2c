#pragma once
// An open file, and the words for what goes wrong with one. Inside models/ only.

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

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

/// The reason in lower case, as it stands inside a line.
inline std::string reason(int error) {
    switch (error) {
    case ENOENT:
        return "no such file or directory";
    case EACCES:
        return "permission denied";
    case ELOOP:
        return "a loop of symbolic links";
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

/// "PATH: cannot VERB: the reason; expected ...".
inline Problem cannot(const char* verb, const std::string& path, int error, const char* expected) {
    return {path, "", fmt::format("cannot {}: {}", verb, reason(error)), expected};
}

}  // namespace glint
