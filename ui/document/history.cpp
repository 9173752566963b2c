// Undo and redo, and the names of the steps. Names are derived from the changed rows of scene_fields.h, so
// editing code does not have to name its steps.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>
#include <string_view>
#include <type_traits>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "models/memory_limit.h"
#include "models/scene/scene.h"
#include "ui/document/editor.h"

namespace glint {
namespace {

constexpr std::size_t max_undone = 500;  // in addition to the current one
// A light or an object takes about 300 bytes, so this many in all steps together take up about 60 MB.
constexpr std::size_t max_items = 200'000;
// Meshes that no object uses any more may take up to 1 / meshes_share of memory.
constexpr std::uint64_t meshes_share = 8;

/// Returns the rows in which a and b differ.
template <class T> std::vector<Row> changed_rows(const T& a, const T& b) {
    std::vector<const void*> members;
    fields(a, [&](const Row&, const auto&, const auto& member) { members.push_back(&member); });
    std::vector<Row> changed;
    std::size_t i = 0;
    fields(b, [&]<class Kind, class Member>(const Row& row, const Kind&, const Member& member) {
        if (!(*static_cast<const Member*>(members[i++]) == member)) changed.push_back(row);
    });
    return changed;
}

/// Returns the name that all changed rows share, such as "Colour of Bulb" for two of its colours; `otherwise`
/// if their names differ.
std::string common_name(const std::vector<Row>& changed, const std::string& name,
                        std::string_view otherwise) {
    const auto is_same = [&](const Row& row) { return std::string_view(row.undo) == changed.front().undo; };
    const bool one_name = !changed.empty() && *changed.front().undo != 0 &&
                          std::all_of(changed.begin(), changed.end(), is_same);
    return fmt::format(fmt::runtime(one_name ? std::string_view(changed.front().undo) : otherwise), name);
}

/// Returns "Shading mode: Flat → Phong" if only one choice has changed; else the same as common_name().
std::string shading_step(const Shading& a, const Shading& b, std::string_view otherwise) {
    const std::vector<Row> changed = changed_rows(a, b);
    std::vector<std::string> labels;  // of the changed choice, before and after
    for (const Shading* each : {&a, &b})
        fields(*each, [&]<class Kind, class Member>(const Row& row, const Kind&, const Member& member) {
            if constexpr (std::is_enum_v<Member>)
                if (changed.size() == 1 && row.key == changed.front().key)
                    labels.emplace_back(choice_of(member).label);
        });
    const std::string name = common_name(changed, "", otherwise);
    return labels.empty() ? name : fmt::format("{}: {} → {}", name, labels[0], labels[1]);
}

/// Whether the light was only moved, with its shape turned accordingly.
bool is_carried(const Light& a, const Light& b) {
    Light same = a;
    same.position = b.position;
    same.spot.direction = b.spot.direction;
    same.area.edge_u = b.area.edge_u;
    same.area.edge_v = b.area.edge_v;
    return same == b && a.position != b.position;
}

std::string light_step(const Light& a, const Light& b) {
    const std::vector<Row> changed = changed_rows(a, b);
    const auto only = [&](std::string_view key) { return changed.size() == 1 && changed.front().key == key; };
    if (only("name")) return fmt::format("Rename {}", a.name);
    if (only("position")) return fmt::format("{} {}", b.position.w == 0 ? "Turn" : "Move", b.name);
    if (is_carried(a, b)) return fmt::format("Move {}", b.name);
    if (only("enabled")) return fmt::format("Switch {} {}", b.name, b.enabled ? "on" : "off");
    if (a.space != b.space) return fmt::format("{} to {} coordinates", b.name, name_of(b.space));
    if (a.kind != b.kind) return fmt::format("Type of {}", b.name);
    return common_name(changed, b.name, "Edit {}");
}

std::string object_step(const Object& a, const Object& b) {
    const std::vector<Row> changed = changed_rows(a, b);
    if (changed.size() != 1) return fmt::format("Edit {}", b.name);
    if (changed.front().key == "name") return fmt::format("Rename {}", a.name);
    if (changed.front().key == "visible") return fmt::format("{} {}", b.visible ? "Show" : "Hide", b.name);
    if (changed.front().key != "transform") return common_name(changed, b.name, "Edit {}");
    const std::vector<Row> moved = changed_rows(a.transform, b.transform);
    // Turning or scaling an object about a point other than its origin also moves it.
    const bool turned = a.transform.rotate_deg != b.transform.rotate_deg;
    const bool scaled = a.transform.scale != b.transform.scale;
    if (turned != scaled) return fmt::format("{} {}", turned ? "Rotate" : "Scale", b.name);
    return common_name(moved, b.name, changed.front().undo);
}

/// Returns "Add X", "Delete X", the name of the only changed item's step, or `otherwise`.
template <class Item, class ItemStep>
std::string list_step(const std::vector<Item>& a, const std::vector<Item>& b, ItemStep item_step,
                      const char* otherwise) {
    const auto shorter = static_cast<std::ptrdiff_t>(std::min(a.size(), b.size()));
    const auto first = std::mismatch(a.begin(), a.begin() + shorter, b.begin()).first - a.begin();
    const auto at = static_cast<std::size_t>(first);
    if (b.size() == a.size() + 1 && std::equal(a.begin() + first, a.end(), b.begin() + first + 1))
        return fmt::format("Add {}", b[at].name);
    if (a.size() == b.size() + 1 && std::equal(b.begin() + first, b.end(), a.begin() + first + 1))
        return fmt::format("Delete {}", a[at].name);
    if (a.size() == b.size() && std::equal(a.begin() + first + 1, a.end(), b.begin() + first + 1))
        return item_step(a[at], b[at]);
    return otherwise;
}

/// Removes the meshes, because reloading a mesh is not a change that has a name.
Scene without_meshes(Scene scene) {
    for (Object& object : scene.objects) object.mesh = nullptr;
    return scene;
}

}  // namespace

void History::reset(const Scene& scene) {
    steps_.assign(1, {"", scene, scene.camera});
    at_ = 0;
}

bool History::commit(const Scene& scene) {
    if (same_description(scene, present())) return false;
    std::string name = step_name(present(), scene);
    const bool edits_camera = scene.camera != present().camera;
    const Camera edited_camera = edits_camera ? scene.camera : steps_[at_].edited_camera;
    steps_.resize(at_ + 1);
    steps_.push_back({std::move(name), scene, edited_camera, edits_camera});
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
            // Most steps share the meshes of the previous step; these need no lookup.
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
    if (steps_.size() > max_undone + 1) return true;
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
    const Step& from = steps_[at_--];
    if (!from.edits_camera) look(from.scene.camera);
    return present();
}

const Scene& History::redo() {
    assert(can_redo());
    const Step& from = steps_[at_++];
    if (!steps_[at_].edits_camera) look(from.scene.camera);
    return present();
}

namespace {

constexpr std::size_t max_views_back = 200;

/// Goes from `now` to the nearest view in `from`.
Camera step_view(std::vector<Camera>& from, std::vector<Camera>& to, const Camera& now) {
    assert(!from.empty());
    Camera camera = from.back();
    from.pop_back();
    to.push_back(now);
    return camera;
}

}  // namespace

void ViewHistory::leave(const Camera& camera) {
    after_.clear();
    before_.push_back(camera);
    if (before_.size() > max_views_back) before_.erase(before_.begin());
}

Camera ViewHistory::back(const Camera& now) { return step_view(before_, after_, now); }
Camera ViewHistory::forward(const Camera& now) { return step_view(after_, before_, now); }

std::string step_name(const Scene& scene_before, const Scene& scene_after) {
    const Scene before = without_meshes(scene_before), after = without_meshes(scene_after);
    const std::vector<Row> changed = changed_rows(before, after);
    if (changed.empty()) return {};
    if (changed.size() > 1) return "Edit scene";
    const Row& row = changed.front();
    if (row.key == "lights") return list_step(before.lights, after.lights, light_step, row.undo);
    if (row.key == "objects") return list_step(before.objects, after.objects, object_step, row.undo);
    if (row.key == "shading") return shading_step(before.shading, after.shading, row.undo);
    return row.undo;
}

}  // namespace glint
