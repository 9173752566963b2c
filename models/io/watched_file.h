#pragma once
// A file that another program writes, such as an editor or a student's program.

#include <chrono>
#include <string>

#include "models/io/file.h"

namespace glint {

/// Reports each new state of the file once, when its size and time have been the same for a moment: so a file
/// that is written in place is not read half-written, and one that is replaced by renaming is not reported as
/// missing in between.
class WatchedFile {
  public:
    using Time = std::chrono::steady_clock::time_point;
    enum class Change { None, Written, Vanished };

    /// The state at `path` now is not reported.
    explicit WatchedFile(std::string path, std::chrono::milliseconds settles = std::chrono::milliseconds(100))
        : path_(std::move(path)), settles_(settles), known_(file_stamp(path_)), seen_(known_) {}

    [[nodiscard]] const std::string& path() const { return path_; }
    /// To be called several times per second, with the current time.
    [[nodiscard]] Change update(Time now) {
        const FileStamp stamp = file_stamp(path_);
        if (stamp != seen_) since_ = now;
        seen_ = stamp;
        if (stamp == known_ || now - since_ < settles_) return Change::None;
        known_ = stamp;
        return stamp.exists() ? Change::Written : Change::Vanished;
    }
    /// Whether a change has begun that has not been reported yet: call update() again soon.
    [[nodiscard]] bool is_changing() const { return seen_ != known_; }

  private:
    std::string path_;
    std::chrono::milliseconds settles_;
    FileStamp known_, seen_;  // the state that was last reported, and the current one
    Time since_;              // of `seen_`
};

}  // namespace glint
