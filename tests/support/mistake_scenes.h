#pragma once
// For each mistake two changes to one scene: one under which it shows, and one under which it has no part.

#include <functional>
#include <vector>

#include "models/scene/scene.h"

namespace glint::test {

/// A scene in which every mistake shows: lights of all kinds, all with falloff and ambient, a squashed ball.
[[nodiscard]] Scene telling_scene();

struct MistakeScenes {
    const char* name;
    std::function<void(Scene&)> where_it_shows, where_it_is_inert;  // changes of telling_scene()
};

/// One a mistake, in the order of the catalogue.
[[nodiscard]] const std::vector<MistakeScenes>& mistake_scenes();

}  // namespace glint::test
