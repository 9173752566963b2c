#include "diagnose/search/mistake_set.h"

#include "models/scene/mistakes.h"

namespace glint {

Scene under_mistakes(Scene scene, const MistakeSet& mistakes) {
    scene.shading.mistakes = {};
    for (const std::size_t i : mistakes) scene.shading.mistakes.*mistake_names()[i].flag = true;
    return scene;
}

std::string name_of(const MistakeSet& mistakes) {
    if (mistakes.empty()) return "right";
    std::string name;
    for (const std::size_t i : mistakes) {
        if (!name.empty()) name += " + ";
        name += mistake_names()[i].name;
    }
    return name;
}

}  // namespace glint
