#pragma once
// For each mistake two changes to one scene: one under which it is visible, and one under which it has no
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
    std::function<void(Scene&)> where_it_shows, where_it_is_inert;  // changes of telling_scene()
};

/// One per mistake, in the order of the catalogue.
[[nodiscard]] const std::vector<MistakeScenes>& mistake_scenes();

}  // namespace glint::test
