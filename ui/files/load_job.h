#pragma once
// A load on a thread of its own, so that the window never waits for a file.

#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "models/progress.h"
#include "models/scene_file.h"

namespace glint {

class LoadJob {
  public:
    using Work = std::function<Result<SceneDocument>()>;

    /// Starts `work`, which may only touch what it holds itself. `name`: what is loaded, for the screen.
    LoadJob(std::string name, Work work);
    /// Cancels and waits.
    ~LoadJob();
    LoadJob(const LoadJob&) = delete;
    LoadJob& operator=(const LoadJob&) = delete;

    void cancel() { progress_.cancelled = true; }
    [[nodiscard]] bool done() const { return done_; }
    /// What came of it, once. Precondition: done().
    [[nodiscard]] Result<SceneDocument> take() { return std::move(result_); }

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const LoadProgress& progress() const { return progress_; }

  private:
    std::string name_;
    LoadProgress progress_;
    Result<SceneDocument> result_;
    std::atomic<bool> done_{false};
    std::thread thread_;  // last: it uses the others
};

/// "reading 12 of 37 MB", "400 000 faces": how far a load has come.
[[nodiscard]] std::string progress_words(const LoadProgress& progress);

/// Its share from 0 to 1, or a negative number when that is not known.
[[nodiscard]] float progress_share(const LoadProgress& progress);

}  // namespace glint
