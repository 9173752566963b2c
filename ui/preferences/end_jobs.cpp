#include <algorithm>
#include <chrono>
#include <thread>

#include "ui/preferences/persistence.h"
#include "ui/ui.h"

namespace glint {
namespace {

/// `action` with every job there is.
template <class Do> void for_each_job(UiState& state, Do action) {
    const auto with = [&action](const auto& job) {
        if (job) action(*job);
    };
    with(state.loading.document);
    with(state.loading.meshes);
    std::for_each(state.loading.left.begin(), state.loading.left.end(), with);
    with(state.exporting.job);
    with(state.animate.job);
    with(state.sensitivity.job);
    std::for_each(state.sensitivity.ending.begin(), state.sensitivity.ending.end(), with);
}

bool all_done(UiState& state) {
    bool done = true;
    for_each_job(state, [&done](const auto& job) { done = done && job.done(); });
    return done;
}

}  // namespace

bool end_jobs(UiState& state, double seconds) {
    using Clock = std::chrono::steady_clock;
    for_each_job(state, [](auto& job) { job.cancel(); });
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (!all_done(state) && Clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return all_done(state);
}

}  // namespace glint
