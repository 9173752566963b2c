#include <cassert>
#include <set>

#include "models/memory_limit.h"
#include "models/mesh/mesh_memory.h"
#include "ui/document/editor.h"

namespace glint {
namespace {

constexpr std::size_t max_steps = 500;
// A light or an object takes about 300 bytes: this many in all steps together is about 60 MB.
constexpr std::size_t max_items = 200'000;
// Meshes that no object has any more may take this share of the memory that there is.
constexpr std::uint64_t meshes_share = 8;

}  // namespace

void History::reset(const Scene& scene) {
    steps_.assign(1, {"", scene});
    at_ = 0;
}

bool History::commit(const Scene& scene, bool join) {
    if (same_description(scene, present())) return false;
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

std::uint64_t History::bytes_of_lost_meshes() const {
    std::set<const Mesh*> counted;
    for (const Object& object : present().objects) counted.insert(object.mesh.get());
    std::uint64_t bytes = 0;
    const Scene* before = nullptr;
    for (const Step& step : steps_) {
        const std::vector<Object>& objects = step.scene.objects;
        for (std::size_t i = 0; i < objects.size(); ++i) {
            // Most steps have the meshes of the step before: those need not be looked up.
            if (before != nullptr && i < before->objects.size() && before->objects[i].mesh == objects[i].mesh)
                continue;
            const Mesh* mesh = objects[i].mesh.get();
            if (mesh != nullptr && counted.insert(mesh).second) bytes += mesh_bytes(*mesh);
        }
        before = &step.scene;
    }
    return bytes;
}

bool History::is_too_large() const {
    if (steps_.size() > max_steps) return true;
    std::size_t items = 0;
    for (const Step& step : steps_) items += step.scene.lights.size() + step.scene.objects.size();
    return items > max_items || bytes_of_lost_meshes() > memory_limit() / meshes_share;
}

void History::forget_oldest() {
    while (steps_.size() > 2 && is_too_large()) {
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
