#include "ui/inspector/sensitivity_job.h"

#include <imgui.h>

#include <algorithm>
#include <exception>

#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double stillness = 0.25;   // seconds before a job starts
constexpr double look_again = 0.05;  // seconds between looks at its progress

void retire(SensitivityState& state) {
    if (!state.job) return;
    state.job->cancel();
    state.ending.push_back(std::move(state.job));
}

}  // namespace

SensitivityJob::SensitivityJob(const SceneDocument& document, PictureSize size, glm::ivec2 pixel)
    : document_(document), size_(size), pixel_(pixel) {
    thread_ = std::thread([this] {
        try {
            work();
        } catch (const std::exception& error) {
            result_ = Problem{"", "", error.what(), ""};
        }
        done_ = true;
    });
}

SensitivityJob::~SensitivityJob() {
    cancel();
    thread_.join();
}

void SensitivityJob::work() {
    const std::size_t lights = document_.scene.lights.size();
    if (lights > max_sensitivity_lights) {
        result_ = Problem{"", "/lights", std::to_string(lights) + " lights are too many for the sensitivity",
                          "at most " + std::to_string(max_sensitivity_lights)};
        return;
    }
    SensitivityRun run(document_, size_, pixel_.x, pixel_.y, 1);  // one thread: the window needs the others
    count_ = run.count();
    while (!cancelled_ && run.step()) measured_ = run.measured();
    if (!cancelled_) result_ = run.result();
}

float SensitivityJob::progress() const {
    const std::size_t count = count_;
    return count == 0 ? 0 : static_cast<float>(measured_) / static_cast<float>(count);
}

void tend_sensitivity(SensitivityState& state, const SceneDocument& document, PictureSize size,
                      glm::ivec2 pixel) {
    const double now = ImGui::GetTime();
    std::erase_if(state.ending, [](const auto& job) { return job->done(); });
    const bool same =
        state.asked_pixel == pixel && state.asked_size == size && state.asked_scene == document.scene;
    if (!same) {
        state.asked_scene = document.scene, state.asked_pixel = pixel, state.asked_size = size;
        state.asked_since = now;
        state.current = false;
        retire(state);
    }
    if (state.current) return;
    if (!state.job && state.ending.empty() && now - state.asked_since >= stillness &&
        !ImGui::IsAnyMouseDown())
        state.job = std::make_unique<SensitivityJob>(document, size, pixel);
    if (state.job && state.job->done()) {
        const auto* found = std::get_if<Sensitivities>(&state.job->result());
        state.shown = found != nullptr ? std::optional(*found) : std::nullopt;
        state.current = true;
        state.job.reset();
        return;
    }
    redraw_within(look_again);
}

}  // namespace glint
