#include "ui/preferences/job.h"

#include <fmt/core.h>

#include <algorithm>

namespace glint {

std::string progress_words(const LoadProgress& progress) {
    const std::uint64_t done = progress.done, total = progress.total;
    const auto megabytes = [](std::uint64_t bytes) { return static_cast<double>(bytes) * 1e-6; };
    switch (progress.stage.load()) {
    case LoadStage::Reading:
        if (total == 0) return "reading";
        return fmt::format("reading {:.1f} of {:.1f} MB", megabytes(done), megabytes(total));
    case LoadStage::Parsing:
        return fmt::format("parsing {:.1f} of {:.1f} MB", megabytes(done), megabytes(total));
    case LoadStage::Building:
        if (total > 0) return fmt::format("building the mesh: {} of {} faces", done, total);
        return done == 0 ? "building the mesh" : fmt::format("building the mesh: {} faces", done);
    }
    return {};  // not reached
}

float progress_share(const LoadProgress& progress) {
    const std::uint64_t done = progress.done, total = progress.total;
    if (total == 0) return -1;
    return static_cast<float>(std::min(1.0, static_cast<double>(done) / static_cast<double>(total)));
}

}  // namespace glint
