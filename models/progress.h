#pragma once
// Reports the progress of a load to another thread, which may cancel the load. Loading reports to the
// LoadProgress of its own thread; without one, nothing is reported or cancelled.

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "models/problem.h"

namespace glint {

enum class LoadStage { Reading, Parsing, Building };

struct LoadProgress {
    std::atomic<LoadStage> stage{LoadStage::Reading};
    std::atomic<std::uint64_t> done{0}, total{0};  // bytes, but faces while Building; total is 0 if unknown
    std::atomic<bool> cancelled{false};
};

/// During its lifetime, loads on this thread report to `progress`, which must outlive it. Scopes do not nest.
class ProgressScope {
  public:
    explicit ProgressScope(LoadProgress& progress);
    ~ProgressScope();
    ProgressScope(const ProgressScope&) = delete;
    ProgressScope& operator=(const ProgressScope&) = delete;
};

/// During its lifetime, loads on this thread report nothing but can be cancelled: they are part of an
/// operation with its own progress, such as rendering frames. Does not nest.
class PartOfProgress {
  public:
    PartOfProgress();
    ~PartOfProgress();
    PartOfProgress(const PartOfProgress&) = delete;
    PartOfProgress& operator=(const PartOfProgress&) = delete;
};

/// Reports the progress of this thread's load. Returns false if the load was cancelled; the caller then
/// returns cancelled_words.
[[nodiscard]] bool report_progress(LoadStage stage, std::uint64_t done, std::uint64_t total = 0);

/// Problem::what of a cancelled load.
inline constexpr const char* cancelled_words = "loading was cancelled";

/// Thrown to leave a cancelled load.
struct LoadCancelled : ProblemFound {
    LoadCancelled() : ProblemFound({"", "", cancelled_words, ""}) {}
};

/// Like report_progress(), but throws LoadCancelled if the load was cancelled.
void report_or_leave(LoadStage stage, std::uint64_t done, std::uint64_t total = 0);

/// True if this thread's load was cancelled; for steps without progress of their own.
[[nodiscard]] bool load_cancelled();
/// The flag that cancels this thread's load, for other threads that take part in the load; null if this
/// thread has no load.
[[nodiscard]] const std::atomic<bool>* load_cancellation();

/// Reports the number of parsed bytes of a file after every 64 KiB: cheap enough to be called for each word.
class ParsedBytes {
  public:
    explicit ParsedBytes(std::size_t total) : total_(total) {}
    /// Throws LoadCancelled if the load was cancelled.
    void at(std::size_t done) {
        if (done >= next_) report(done);
    }

  private:
    void report(std::size_t done);

    static constexpr std::size_t between_reports = 1 << 16;
    std::size_t total_, next_ = between_reports;
};

}  // namespace glint
