#include "ui/document/editor.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "models/fields/scene_fields.h"
#include "models/io/file.h"

namespace glint {
namespace {

/// Whether a list has one item more than before, at `index` or, if the deleted item was the last one, after
/// it. The deletion then left `index` selected, and `index` is set to the position of the deleted item.
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
/// step back selects the previous item, of which it may have been a copy.
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

}  // namespace glint
