#include "ui/history.h"

#include <cassert>

namespace glint {
namespace {

constexpr std::size_t max_steps = 500;
// A light or an object takes about 300 bytes: this many in all steps together is about 60 MB.
constexpr std::size_t max_items = 200'000;

}  // namespace

void History::reset(const Scene& scene) {
    steps_.assign(1, {"", scene});
    at_ = 0;
}

bool History::commit(const Scene& scene, bool join) {
    if (scene == present()) return false;
    std::string name = step_name(present(), scene);
    steps_.resize(at_ + 1);
    if (join && can_undo() && steps_[at_].name == name) {
        steps_[at_].scene = scene;
        return true;
    }
    steps_.push_back({std::move(name), scene});
    ++at_;
    forget_oldest();
    return true;
}

void History::forget_oldest() {
    std::size_t items = 0;
    for (const Step& step : steps_) items += step.scene.lights.size() + step.scene.objects.size();
    while (steps_.size() > 2 && (steps_.size() > max_steps || items > max_items)) {
        items -= steps_.front().scene.lights.size() + steps_.front().scene.objects.size();
        steps_.erase(steps_.begin());
        --at_;
    }
}

const Scene& History::undo() {
    assert(can_undo());
    return steps_[--at_].scene;
}

const Scene& History::redo() {
    assert(can_redo());
    return steps_[++at_].scene;
}

}  // namespace glint
