#pragma once
// The sensitivity of a pixel is measured beside the window, on a thread and with a renderer of its own.

#include <atomic>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "renderer/inspect/debug_views/sensitivity.h"

namespace glint {

/// Measures one pixel of one scene.
class SensitivityJob {
  public:
    /// Starts; the document's meshes are shared, nothing else. Where no thread can start, it is done, with a
    /// Problem.
    SensitivityJob(const SceneDocument& document, PictureSize size, glm::ivec2 pixel);
    /// Stops after the step it is at, and waits for that.
    ~SensitivityJob();
    SensitivityJob(const SensitivityJob&) = delete;
    SensitivityJob& operator=(const SensitivityJob&) = delete;

    void cancel() { cancelled_ = true; }
    [[nodiscard]] bool done() const { return done_; }
    /// 0 to 1.
    [[nodiscard]] float progress() const;
    /// Precondition: done(), and not cancelled.
    [[nodiscard]] const Result<Sensitivities>& result() const { return result_; }

  private:
    void work();

    SceneDocument document_;
    PictureSize size_;
    glm::ivec2 pixel_;
    Result<Sensitivities> result_;
    std::atomic<bool> cancelled_{false}, done_{false};
    std::atomic<std::size_t> measured_{0}, count_{0};
    std::thread thread_;  // last: it uses the others
};

/// The numbers that count, the largest effect of a channel first; without the w of positions.
[[nodiscard]] std::vector<Sensitivity> ranked(const Sensitivities& sensitivities);

/// The job that is wanted now, the results shown until it is done, and jobs that are coming to their end.
struct SensitivityState {
    std::unique_ptr<SensitivityJob> job;
    std::vector<std::unique_ptr<SensitivityJob>> ending;
    double asked_since = 0;  // time at which scene and pixel became what they are
    Scene asked_scene;
    glm::ivec2 asked_pixel{-1, -1};
    PictureSize asked_size;
    std::optional<Sensitivities> shown;
    std::vector<Sensitivity> rank;  // of `shown`
    std::string why_none;           // in place of `shown`, where measuring failed
    Scene shown_scene;              // that `shown` is of: its pointers are of this scene
    bool current = false;           // `shown` is of the scene and pixel as they are

    /// Another scene is in hand: its lights and objects are others.
    void forget() {
        shown.reset();
        current = false;
    }
};

}  // namespace glint
