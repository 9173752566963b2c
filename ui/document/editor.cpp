#include "ui/document/editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "models/io/file.h"
#include "models/memory_limit.h"
#include "models/scene/scene.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"

namespace glint {
namespace {

/// Whether undo has restored an item whose deletion selected its neighbour, which is now at `index`. The
/// restored item is at `index` or, if it was the last one, after it. Sets `index` to its position.
template <class Item>
bool has_back(const std::vector<Item>& before, const std::vector<Item>& after, int& index) {
    if (after.size() != before.size() + 1) return false;
    const auto place = std::mismatch(before.begin(), before.end(), after.begin()).first - before.begin();
    const bool was_last = place == std::ssize(before) && index + 1 == place;
    if (place != index && !was_last) return false;
    index = static_cast<int>(place);
    return true;
}

/// Makes a step's scene the edited one. If an item next to the selected one is restored, it is selected
/// again. If the selected item no longer exists, a step forward selects the next item, as its deletion did; a
/// step back selects the previous item, of which the selected item may have been a copy.
void take_step(Editor& editor, const Scene& scene, bool forward = false) {
    const Scene before = std::exchange(editor.document.scene, scene);
    Selection& selection = editor.selection;
    if (selection.kind == Selection::Kind::Light && has_back(before.lights, scene.lights, selection.index))
        return;
    if (selection.kind == Selection::Kind::Object && has_back(before.objects, scene.objects, selection.index))
        return;
    int place = selection.index;
    if (selection.kind == Selection::Kind::Light) place = place_in(before.lights, scene.lights, place);
    if (selection.kind == Selection::Kind::Object) place = place_in(before.objects, scene.objects, place);
    if (place < 0) place = forward ? selection.index : std::max(selection.index - 1, 0);
    selection.index = place;
    selection = valid_selection(selection, scene);
}

}  // namespace

std::string Editor::title() const { return file_title(document.path); }

bool Editor::has_scene_file() const { return lower_extension(document.path) == ".json"; }

void take_document(Editor& editor, SceneDocument document) {
    Editor next;
    next.document = std::move(document);
    next.saved = next.document.scene;
    next.saved_edited_camera = next.saved.camera;
    next.history.reset(next.document.scene);
    if (!next.scene().lights.empty()) next.selection = {Selection::Kind::Light, 0};
    // A document that has never been drawn is dropped; the previous document, which has been drawn, is kept.
    next.before = editor.before ? std::move(editor.before) : std::make_unique<Editor>(std::move(editor));
    editor = std::move(next);
}

std::optional<Problem> save_file(Editor& editor, std::string path, const Scene& scene) {
    if (lower_extension(path) != ".json") path += ".json";
    // The open document keeps its mesh paths: they and those in the history are relative to the folder it was
    // opened from.
    SceneDocument saved = editor.document;
    saved.scene = scene;
    Result<SceneDocument> written = save_document(saved, path);
    if (const Problem* problem = problem_of(written)) return *problem;
    editor.document.path = path;
    editor.document.stamp = std::get<SceneDocument>(written).stamp;
    editor.document.fitted_to.reset();  // the file is no longer the picture that was opened
    editor.document.assignments.clear();
    editor.saved = std::move(saved.scene);
    editor.saved_edited_camera = editor.history.edited_camera();
    return {};
}

bool changed_by_another(const Editor& editor) {
    const FileStamp now = file_stamp(editor.document.path);
    return now.exists() && now != editor.document.stamp;
}

std::optional<Problem> take_back_invalid(Editor& editor) {
    if (editor.valid == editor.scene()) return {};
    if (editor.valid)
        if (auto found = violation_since(*editor.valid, editor.scene())) {
            take_step(editor, *editor.valid);
            return found;
        }
    editor.valid = editor.scene();
    return {};
}

std::optional<Problem> settle(Editor& editor) {
    Scene& scene = editor.scene();
    const bool missing =
        std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& o) { return !o.mesh; });
    if (!missing) return {};
    Result<Warnings> loaded = load_meshes(scene, editor.document.path, editor.document.mesh_dir);
    const Problem* problem = problem_of(loaded);
    if (!problem) return {};
    take_step(editor, editor.history.present());
    return *problem;
}

bool remember_step(Editor& editor, bool join) {
    const Camera &now = editor.scene().camera, before = editor.history.present().camera;
    if (!std::exchange(editor.edits_camera, false) && now != before) {
        if (!join) editor.views.leave(before);
        editor.history.look(now);
    }
    return editor.history.commit(editor.scene());
}

bool undo(Editor& editor) {
    if (!editor.history.can_undo()) return false;
    take_step(editor, editor.history.undo());
    return true;
}

bool redo(Editor& editor) {
    if (!editor.history.can_redo()) return false;
    take_step(editor, editor.history.redo(), true);
    return true;
}

SceneDocument first_scene() {
    SceneDocument document;
    Scene& scene = document.scene;
    scene.camera.eye = {0, 0.8f, 4};
    Light sun, bulb;
    sun.name = "Sun";
    sun.kind = LightKind::Directional;
    sun.position = {1, 1.2f, 1, 0};
    sun.diffuse = sun.specular = {1, 0.95f, 0.85f};
    bulb.name = "Bulb";
    bulb.position = {-1.6f, 0.4f, 1.2f, 1};
    bulb.diffuse = bulb.specular = {0.35f, 0.55f, 1};
    scene.lights = {sun, bulb};
    Object ball;
    ball.name = "Ball";
    const PrimitiveMesh sphere = default_mesh(Primitive::Sphere);
    ball.source = sphere;
    ball.mesh = std::make_shared<const Mesh>(make_primitive(sphere.primitive, sphere.detail));
    ball.material.diffuse = {0.8f, 0.35f, 0.25f};
    scene.objects = {ball};
    return document;
}

namespace {

constexpr std::size_t most = 12;

}  // namespace

bool drops_changes(const UiState& state) {
    const std::string& path = state.editor.document.path;
    return !path.empty() && is_among_shipped(state, path);
}

void keep_changes(UiState& state, const std::string& title) {
    std::vector<ChangedScene>& list = state.get<RecentlyChanged>().list;
    std::erase_if(list, [&](const ChangedScene& other) { return other.title == title; });
    ChangedScene changed{title, document_as_made(state), {}};
    changed.changed = std::exchange(changed.document.scene, state.editor.saved);
    list.insert(list.begin(), std::move(changed));
    if (list.size() > most) list.pop_back();
}

void reopen_changed(UiState& state, const ChangedScene& changed) {
    ask_first(state, [changed](UiState& s) {
        cancel_loads(s);
        take_scene(s, changed.document);
        s.editor.scene() = changed.changed;
        s.editor.edits_camera = true;
        std::erase_if(s.get<RecentlyChanged>().list,
                      [&](const ChangedScene& other) { return other.title == changed.title; });
    });
}

extern const Feature recently_changed_feature;
const Feature recently_changed_feature{
    .palette =
        [](std::vector<PaletteEntry>& entries, UiState& state) {
            for (const ChangedScene& changed : state.get<RecentlyChanged>().list)
                entries.push_back({"Changed: " + changed.title, "Recently changed", "", "",
                                   [changed](UiState& s) { reopen_changed(s, changed); }});
        },
    .leave_document =
        [](UiState& state, const SceneDocument&) {
            if (state.editor.unsaved() && drops_changes(state)) keep_changes(state, state.editor.title());
        }};

// Undo and redo, and the names of the steps. Names are derived from the changed rows of scene_fields.h, so
// editing code does not have to name its steps.

namespace {

constexpr std::size_t max_undone = 500;  // undo steps in addition to the current one
// A light or an object takes about 300 bytes, so this many across all steps take up about 60 MB.
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
    std::vector<std::string> labels;  // labels of the changed choice, before and after
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

/// Removes the meshes, because reloading a mesh does not count when a step is named after its changes.
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
            // Most steps share the meshes of the previous step; shared meshes need no lookup.
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
