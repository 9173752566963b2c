#pragma once
// Measures the sensitivity of a pixel in the background, with a separate renderer.

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/debug_views/sensitivity.h"
#include "ui/document/job.h"

namespace glint {

/// The numbers with an effect, largest effect on a channel first; excluding the w of positions.
[[nodiscard]] std::vector<Sensitivity> ranked(const Sensitivities& sensitivities);

/// The current job, the results shown until it is done, and cancelled jobs that are still running.
struct SensitivityState {
    JobPtr<Sensitivities> job;
    JobPtr<Sensitivities> ending;  // the last cancelled job
    double asked_since = 0;        // time of the last change to the scene or pixel
    Scene asked_scene;
    glm::ivec2 asked_pixel{-1, -1};
    PictureSize asked_size;
    std::optional<Sensitivities> shown;
    std::vector<Sensitivity> rank;  // `shown`, sorted by effect
    std::string why_none;           // the reason why there is no `shown`, if measuring failed
    Scene shown_scene;              // the scene of `shown`, to which its pointers refer
    bool current = false;           // `shown` belongs to the current scene and pixel

    /// Called when a different scene is opened, because its lights and objects differ.
    void forget() {
        shown.reset();
        current = false;
    }
};

}  // namespace glint
