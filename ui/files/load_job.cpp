#include "ui/files/load_job.h"

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace glint {

LoadJob::LoadJob(std::string name, Work work) : name_(std::move(name)) {
    thread_ = std::thread([this, work = std::move(work)] {
        try {
            const ProgressScope scope(progress_);
            result_ = work();
        } catch (const std::bad_alloc&) {
            result_ = Problem{name_, "", "does not fit in memory", "a smaller one"};
        } catch (const std::exception& error) {
            result_ = Problem{name_, "", error.what(), ""};
        }
        done_ = true;
    });
}

LoadJob::~LoadJob() {
    cancel();
    thread_.join();
}

std::string progress_words(const LoadProgress& progress) {
    const std::uint64_t done = progress.done, total = progress.total;
    const auto megabytes = [](std::uint64_t bytes) { return static_cast<double>(bytes) * 1e-6; };
    switch (progress.stage.load()) {
    case LoadStage::Reading:
        if (total == 0) return "reading";
        return fmt::format("reading {:.1f} of {:.1f} MB", megabytes(done), megabytes(total));
    case LoadStage::Building:
        return done == 0 ? "building the mesh" : fmt::format("building the mesh: {} faces", done);
    }
    return {};  // not reached
}

float progress_share(const LoadProgress& progress) {
    const std::uint64_t done = progress.done, total = progress.total;
    if (progress.stage != LoadStage::Reading || total == 0) return -1;
    return static_cast<float>(std::min(1.0, static_cast<double>(done) / static_cast<double>(total)));
}

}  // namespace glint
