#pragma once
// For each mistake, two changes to the same scene: one that makes it visible, and one that leaves it without
// effect.

#include <functional>
#include <vector>

#include "models/scene/scene.h"

namespace glint::test {

/// A scene in which every mistake is visible: lights of all kinds, all with falloff and ambient, a squashed
/// ball.
[[nodiscard]] Scene telling_scene();

struct MistakeScenes {
    const char* name;
    std::function<void(Scene&)> where_it_shows, where_it_is_inert;  // changes to telling_scene()
};

/// One per mistake, in the order of the catalogue.
[[nodiscard]] const std::vector<MistakeScenes>& mistake_scenes();

}  // namespace glint::test
