#pragma once
// Work on a thread of its own, so that the window never waits for a file or a large picture.

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "models/memory_limit.h"
#include "models/problem.h"
#include "models/progress.h"
#include "models/scene_file/scene_file.h"

namespace glint {

/// Starts `work` on a thread. Returns why it cannot: as many threads run as the system allows. `about`: for
/// the screen.
template <class Do>
[[nodiscard]] std::optional<Problem> start_thread(std::thread& thread, const std::string& about, Do work) {
    try {
        thread = std::thread(std::move(work));
    } catch (const std::system_error& error) {
        return Problem{about, "", "no thread can do it: " + error.code().message(), ""};
    }
    return {};
}

template <class T> class Job {
  public:
    using Work = std::function<Result<T>(LoadProgress&)>;

    /// Starts `work`, which may touch only what it holds itself. Loads within it report to its LoadProgress,
    /// and so may it. Where no thread can start, it is done, with a Problem. `name`: what it is about, for
    /// the screen.
    Job(std::string name, Work work) : name_(std::move(name)) {
        const auto problem = start_thread(thread_, name_, [this, work = std::move(work)] { run(work); });
        if (!problem) return;
        result_ = *problem;
        done_ = true;
    }
    /// Cancels and waits.
    ~Job() {
        cancel();
        if (thread_.joinable()) thread_.join();
    }
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    void cancel() { progress_.cancelled = true; }
    [[nodiscard]] bool done() const { return done_; }
    /// Waits until it is done, but not longer than that. Returns done().
    bool wait_for(std::chrono::milliseconds longest) const {
        const auto end = std::chrono::steady_clock::now() + longest;
        while (!done_ && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return done_;
    }
    /// Returns the result, once. Precondition: done().
    [[nodiscard]] Result<T> take() { return std::move(result_); }

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const LoadProgress& progress() const { return progress_; }

  private:
    void run(const Work& work) {
        try {
            const ProgressScope scope(progress_);
            result_ = work(progress_);
        } catch (const std::exception& error) {  // a thread must not end with one
            result_ = problem_from(error, name_);
        }
        done_ = true;
    }

    std::string name_;
    LoadProgress progress_;
    Result<T> result_;
    std::atomic<bool> done_{false};
    std::thread thread_;  // last: it uses the others
};

using LoadJob = Job<SceneDocument>;

/// Jobs that were cancelled and have not ended yet.
template <class T> using LeftJobs = std::vector<std::unique_ptr<Job<T>>>;

template <class T> void drop_ended(LeftJobs<T>& left) {
    std::erase_if(left, [](const auto& job) { return job->done(); });
}

/// Cancels a job, if there is one, whose thread may go on for a while.
template <class T> void leave(std::unique_ptr<Job<T>>& job, LeftJobs<T>& left) {
    if (!job) return;
    job->cancel();
    left.push_back(std::move(job));
}

}  // namespace glint
