#pragma once
// How far a load has come, for whoever watches from another thread, and the wish to end it early. Loading
// reports to the LoadProgress of its own thread, if that has one; without one nothing is said and nothing
// ends.

#include <atomic>
#include <cstdint>

namespace glint {

enum class LoadStage { Reading, Building };

struct LoadProgress {
    std::atomic<LoadStage> stage{LoadStage::Reading};
    std::atomic<std::uint64_t> done{0}, total{0};  // Reading: bytes; Building: faces, total not known (0)
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

/// Tells how far this thread's load has come. False when it shall end: then give up with cancelled_words.
[[nodiscard]] bool report_progress(LoadStage stage, std::uint64_t done, std::uint64_t total = 0);

/// Problem::what of a load that was ended early.
inline constexpr const char* cancelled_words = "loading was cancelled";

}  // namespace glint
