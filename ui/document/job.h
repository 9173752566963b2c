#pragma once
// Work on its own thread, so that the window never waits for a file or a large picture.

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

/// Starts `work` on a thread. Returns a problem if the system's limit on threads is reached. `about`: the
/// subject of the problem's message.
template <class Do>
[[nodiscard]] std::optional<Problem> start_thread(std::thread& thread, const std::string& about, Do work) {
    try {
        thread = std::thread(std::move(work));
    } catch (const std::system_error& error) {
        return Problem{about, "", "the system allows no more threads: " + error.code().message(), ""};
    }
    return {};
}

/// A job with a result of any type.
class AnyJob {
  public:
    explicit AnyJob(std::string name) : name_(std::move(name)) {}
    virtual ~AnyJob() = default;
    AnyJob(const AnyJob&) = delete;
    AnyJob& operator=(const AnyJob&) = delete;

    void cancel() { progress_.cancelled = true; }
    [[nodiscard]] bool done() const { return done_; }
    /// Waits until the job is done, but at most `longest`. Returns done().
    bool wait_for(std::chrono::milliseconds longest) const {
        const auto end = std::chrono::steady_clock::now() + longest;
        while (!done_ && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return done_;
    }
    void wait() const {
        while (!wait_for(std::chrono::hours(1))) {
        }
    }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const LoadProgress& progress() const { return progress_; }

  protected:
    std::string name_;
    LoadProgress progress_;
    std::atomic<bool> done_{false};
};

template <class T> class Job : public AnyJob {
  public:
    using Work = std::function<Result<T>(LoadProgress&)>;

    /// Starts `work`, which may only touch its own data. `work` and the loads within it may report to the
    /// job's LoadProgress. If no thread can be started, the job is done at once and its result is a Problem.
    /// `name`: the subject, shown on the screen. `when_done`: called on the job's thread after it is done.
    Job(std::string name, Work work, std::function<void()> when_done = {}) : AnyJob(std::move(name)) {
        const auto problem =
            start_thread(thread_, name_, [this, work = std::move(work), when_done = std::move(when_done)] {
                run(work);
                if (when_done) when_done();
            });
        if (!problem) return;
        result_ = *problem;
        done_ = true;
    }
    /// Cancels the job and waits until its thread has ended.
    ~Job() override {
        cancel();
        if (thread_.joinable()) thread_.join();
    }
    /// Returns the result, once. Precondition: done().
    [[nodiscard]] Result<T> take() { return std::move(result_); }

  private:
    void run(const Work& work) {
        try {
            const ProgressScope scope(progress_);
            result_ = work(progress_);
        } catch (const std::exception& error) {  // an exception must not escape a thread
            result_ = problem_from(error, name_);
        }
        done_ = true;
    }

    Result<T> result_;
    std::thread thread_;  // declared last, because it uses the other members
};

template <class T> using JobPtr = std::shared_ptr<Job<T>>;
using LoadJob = Job<SceneDocument>;

/// All jobs of a window that have not ended, including cancelled ones whose threads still run.
class Jobs {
  public:
    std::function<void()> when_done;  // passed to each job started later; wakes the window

    ~Jobs() {
        for (const auto& job : jobs_) job->cancel();
    }
    template <class T> JobPtr<T> add(JobPtr<T> job) {
        jobs_.push_back(job);
        return job;
    }
    template <class T> JobPtr<T> start(std::string name, typename Job<T>::Work work) {
        return add(std::make_shared<Job<T>>(std::move(name), std::move(work), when_done));
    }
    void drop_ended() {
        std::erase_if(jobs_, [](const auto& job) { return job->done(); });
    }

  private:
    std::vector<std::shared_ptr<AnyJob>> jobs_;
};

/// Cancels a job, if there is one, without waiting for it. Precondition: it is among the window's Jobs.
template <class T> void leave(JobPtr<T>& job) {
    if (job) job->cancel();
    job.reset();
}
/// Cancels a job in the same way; `ending` receives the cancelled job, for work that runs one job at a time.
template <class T> void leave(JobPtr<T>& job, JobPtr<T>& ending) {
    if (job) ending = job;
    leave(job);
}
/// Whether the next job may begin, for work that runs one job at a time.
template <class T> [[nodiscard]] bool has_ended(const JobPtr<T>& ending) { return !ending || ending->done(); }

}  // namespace glint
