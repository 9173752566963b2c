#pragma once
// Reports the progress of a load to another thread, which may ask for the load to end early. Loading reports
// to the LoadProgress of its own thread, if that has one; without one nothing is said and nothing ends.

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "models/problem.h"

namespace glint {

enum class LoadStage { Reading, Parsing, Building };

struct LoadProgress {
    std::atomic<LoadStage> stage{LoadStage::Reading};
    std::atomic<std::uint64_t> done{0}, total{0};  // bytes; Building: faces; total is 0 when not known
    std::atomic<bool> cancelled{false};
};

/// While it lives, loads on this thread report to `progress`, which must outlive it. Scopes do not nest.
class ProgressScope {
  public:
    explicit ProgressScope(LoadProgress& progress);
    ~ProgressScope();
    ProgressScope(const ProgressScope&) = delete;
    ProgressScope& operator=(const ProgressScope&) = delete;
};

/// While it lives, loads on this thread tell nothing, but end when they shall: they are parts of what counts
/// something else, such as frames. They do not nest.
class PartOfProgress {
  public:
    PartOfProgress();
    ~PartOfProgress();
    PartOfProgress(const PartOfProgress&) = delete;
    PartOfProgress& operator=(const PartOfProgress&) = delete;
};

/// Tells how far this thread's load has come. False when it shall end: then give up with cancelled_words.
[[nodiscard]] bool report_progress(LoadStage stage, std::uint64_t done, std::uint64_t total = 0);

/// Problem::what of a load that was ended early.
inline constexpr const char* cancelled_words = "loading was cancelled";

/// Ends a load early from deep inside.
struct LoadCancelled : ProblemFound {
    LoadCancelled() : ProblemFound({"", "", cancelled_words, ""}) {}
};

/// report_progress(), but throws LoadCancelled when the load shall end.
void report_or_leave(LoadStage stage, std::uint64_t done, std::uint64_t total = 0);

/// True when this thread's load shall end; for steps that have nothing to tell.
[[nodiscard]] bool load_cancelled();

/// Reports how many bytes of a file have been parsed, after every 64 KiB: cheap enough to be told of each
/// word.
class ParsedBytes {
  public:
    explicit ParsedBytes(std::size_t total) : total_(total) {}
    /// Throws LoadCancelled when the load shall end.
    void at(std::size_t done) {
        if (done >= next_) report(done);
    }

  private:
    void report(std::size_t done);

    static constexpr std::size_t between_reports = 1 << 16;
    std::size_t total_, next_ = between_reports;
};

}  // namespace glint
