#pragma once
// Shows the progress of long work once a second, and only on a terminal.

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

#include "renderer/renderer.h"

namespace glint {

/// One line on standard error that is overwritten, "frame 12 of 400", and erased at the end.
class Progress {
  public:
    /// Counts `what` from 1 to `all`.
    Progress(std::string what, std::size_t all)
        : what_(std::move(what)), all_(all), watched_(isatty(STDERR_FILENO) == 1) {}
    ~Progress() {
        if (shown_) fmt::print(stderr, "\r\x1b[K");
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Reports that number `count` is being processed; `part` describes the progress within it.
    void at(std::size_t count, const std::string& part = {}) {
        const auto now = Clock::now();
        count_ = count;
        if (!watched_ || now - last_ < std::chrono::seconds(1)) return;
        fmt::print(stderr, "\r\x1b[K{} {} of {}{}", what_, count, all_, part);
        last_ = now;
        shown_ = true;
    }
    /// Shows the number of paths traced per point while the renderer draws. It stops when this object is
    /// destroyed.
    void show_paths(Renderer& renderer) {
        renderer.on_paths(
            [this](int done, int all) { at(count_, fmt::format(", path {} of {}", done, all)); });
    }

  private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    std::size_t all_, count_ = 1;
    bool watched_, shown_ = false;
    Clock::time_point last_ = Clock::now();
};

}  // namespace glint
