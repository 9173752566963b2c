#pragma once
// The sensitivity of a pixel is measured in the background, with a renderer of its own.

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/debug_views/sensitivity.h"
#include "ui/document/job.h"

namespace glint {

/// The numbers that count, the largest effect of a channel first; without the w of positions.
[[nodiscard]] std::vector<Sensitivity> ranked(const Sensitivities& sensitivities);

/// The job that is wanted now, the results shown until it is done, and jobs that are coming to their end.
struct SensitivityState {
    JobPtr<Sensitivities> job;
    JobPtr<Sensitivities> ending;  // the one cancelled last
    double asked_since = 0;        // time at which scene and pixel became what they are
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
