#pragma once
// What the window remembers of an animation between frames.

#include <memory>
#include <string>

#include "ui/export/animation.h"
#include "ui/preferences/job.h"

namespace glint {

struct AnimateState {
    bool open = false, playing = false;
    std::optional<Scene> frame;  // while it plays: what the next picture shows
    Animation animation;
    std::string search;                     // for the number that shall move
    int frames_a_second = 25;               // 1 to 50: GIF counts hundredths of a second
    double began = 0;                       // ImGui's time at frame 0
    std::string refused;                    // why it cannot play; empty when it can
    std::unique_ptr<Job<std::string>> job;  // its result: what to say when the frames are written
};

}  // namespace glint
