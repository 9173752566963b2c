#include "ui/document/loading.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "models/fields/choices.h"
#include "models/json/json_pointer.h"
#include "renderer/renderer.h"
#include "ui/document/averaged_normals.h"
#include "ui/document/document_actions.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

bool waits(const Object& object, const AwaitedMesh& awaited) {
    return awaited.mesh_before && object.source == awaited.wanted && object.mesh == awaited.mesh_before;
}

bool is_quick(const MeshSource& source) {
    const auto* primitive = std::get_if<PrimitiveMesh>(&source);
    return primitive != nullptr && is_quick(*primitive);
}

void leave(Loading& loading, std::unique_ptr<LoadJob>& job) {
    if (!job) return;
    job->cancel();
    loading.left.push_back(std::move(job));
}

/// The mesh of the same source in the scene or in the newest step; null when there is none.
MeshPtr known_mesh(const Scene& scene, const Scene& present, const MeshSource& source,
                   const std::vector<AwaitedMesh>& awaited) {
    for (const Scene* known : {&scene, &present})
        for (const Object& object : known->objects) {
            const auto own = [&object](const AwaitedMesh& a) { return waits(object, a); };
            if (object.mesh && object.source == source && std::none_of(awaited.begin(), awaited.end(), own))
                return object.mesh;
        }
    return nullptr;
}

/// Edits that left an object without its mesh: the object keeps the old one until the new one is there.
void note_slow_edits(UiState& state) {
    Scene& scene = state.editor.scene();
    const Scene& present = state.editor.history.present();
    Loading& loading = state.loading;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        Object& object = scene.objects[i];
        if (object.mesh || is_quick(object.source) || i >= present.objects.size()) continue;
        object.mesh = known_mesh(scene, present, object.source, loading.awaited);
        const Object& before = present.objects[i];
        if (object.mesh || !before.mesh) continue;
        object.mesh = before.mesh;
        loading.awaited.push_back({object.source, before.source, before.mesh});
    }
}

/// Returns whether an object was deleted while it waited, which is not a step of its own yet.
bool is_deleted(const Editor& editor, const AwaitedMesh& awaited) {
    const auto has_it = [&](const Scene& scene) {
        return std::any_of(scene.objects.begin(), scene.objects.end(),
                           [&](const Object& object) { return object.mesh == awaited.mesh_before; });
    };
    return awaited.mesh_before && has_it(editor.history.present()) && !has_it(editor.scene());
}

/// What nobody waits for any more (undone, deleted, changed again) is forgotten.
void forget_unwanted(UiState& state) {
    const auto& objects = state.editor.scene().objects;
    const auto unwanted = [&objects](const AwaitedMesh& awaited) {
        const auto own = [&awaited](const Object& object) { return waits(object, awaited); };
        return awaited.mesh_before && std::none_of(objects.begin(), objects.end(), own);
    };
    auto& list = state.loading.awaited;
    if (std::any_of(list.begin(), list.end(), [&](const auto& a) { return is_deleted(state.editor, a); }))
        state.notifications.tell(
            "It was deleted before its new mesh was there: undo brings it back with the old one");
    list.erase(std::remove_if(list.begin(), list.end(), unwanted), list.end());
    if (list.empty()) leave(state.loading, state.loading.meshes);
}

/// A problem with a mesh of `scene` by the mesh's name: an object that is only to come has no place yet.
Problem about_its_mesh(Problem problem, const Scene& scene) {
    if (const std::optional<ListItem> object = item_in(problem.pointer, "/objects/")) {
        problem.file = short_name(scene.objects[static_cast<std::size_t>(object->place)].source);
        problem.pointer.clear();
    }
    return problem;
}

void start_meshes(UiState& state) {
    Loading& loading = state.loading;
    if (loading.meshes || loading.awaited.empty()) return;
    Scene wanting = state.editor.scene();
    for (const AwaitedMesh& awaited : loading.awaited) {
        for (Object& object : wanting.objects)
            if (waits(object, awaited)) object.mesh = nullptr;
        if (awaited.mesh_before) continue;
        Object fresh;
        fresh.source = awaited.wanted;
        wanting.objects.push_back(fresh);
    }
    const SceneDocument& document = state.editor.document;
    loading.meshes = std::make_unique<LoadJob>(
        short_name(loading.awaited.front().wanted),
        [wanting, path = document.path, dir = document.mesh_dir](LoadProgress&) -> Result<SceneDocument> {
            Scene scene = wanting;
            Result<Warnings> loaded = load_meshes(scene, path, dir);
            if (const Problem* problem = problem_of(loaded)) return about_its_mesh(*problem, wanting);
            return SceneDocument{std::move(scene), path, dir, std::get<Warnings>(std::move(loaded))};
        });
    loading.since = ImGui::GetTime();
}

/// The new mesh for the objects that wait for it; a new object where none does.
void give_mesh(UiState& state, const AwaitedMesh& awaited, const MeshPtr& mesh) {
    Editor& editor = state.editor;
    for (Object& object : editor.scene().objects)
        if (waits(object, awaited)) object.mesh = mesh;
    if (awaited.mesh_before) return;
    if (const auto index = add_object(editor.scene(), awaited.wanted)) {
        editor.scene().objects[static_cast<std::size_t>(*index)].mesh = mesh;
        editor.selection = {Selection::Kind::Object, *index};
    }
}

void give_up_meshes(UiState& state) {
    for (const AwaitedMesh& awaited : state.loading.awaited)
        for (Object& object : state.editor.scene().objects)
            if (waits(object, awaited)) object.source = awaited.before;
    state.loading.awaited.clear();
}

/// Whether only the fineness of a mesh was edited: its panel has words of its own beside the sliders, and a
/// drag brings many such edits.
bool is_another_fineness(const AwaitedMesh& awaited) {
    return awaited.mesh_before && as_given(awaited.wanted) == as_given(awaited.before);
}

void poll_meshes(UiState& state) {
    note_slow_edits(state);
    forget_unwanted(state);
    Loading& loading = state.loading;
    if (loading.meshes && loading.meshes->done()) {
        const Result<SceneDocument> result = loading.meshes->take();
        loading.meshes.reset();
        if (const Problem* problem = problem_of(result)) {
            state.notifications.add(*problem);
            give_up_meshes(state);
        } else {
            const auto& loaded = std::get<SceneDocument>(result);
            auto& list = loading.awaited;
            if (!std::all_of(list.begin(), list.end(), is_another_fineness))
                state.notifications.add(loaded.warnings);
            const auto come = [&](const AwaitedMesh& awaited) {
                for (const Object& object : loaded.scene.objects)
                    if (object.source == awaited.wanted && object.mesh != awaited.mesh_before) {
                        give_mesh(state, awaited, object.mesh);
                        if (!is_another_fineness(awaited)) say_averaged(state, object);
                        return true;
                    }
                return false;  // wanted only since the load began
            };
            list.erase(std::remove_if(list.begin(), list.end(), come), list.end());
        }
    }
    start_meshes(state);
}

/// Puts a loaded document in hand: a file's, or the copy that a window left behind, which is not saved and
/// from now on is this window's own.
void take_loaded(UiState& state, SceneDocument document) {
    Loading& loading = state.loading;
    leave(loading, loading.meshes);
    loading.awaited.clear();
    std::optional<Recovery> recovery = std::exchange(loading.recovery, std::nullopt);
    if (recovery) drop_autosave(state);
    take_scene(state, std::move(document));
    if (recovery) {  // before anything that may fail: what is in hand is not saved
        state.editor.saved = std::move(*recovery->in_file);
        keep_orphan(state, recovery->autosave);
    }
    state.notifications.add(state.editor.document.warnings);
    tell_averaged_normals(state);
    if (const auto course = std::exchange(loading.course, nullptr)) begin_lesson(state, *course);
}

void poll_document(UiState& state) {
    Loading& loading = state.loading;
    if (!state.pending.asking) loading.loaded.reset();  // the answer was no
    if (!loading.document || !loading.document->done()) return;
    if (state.pending.asking) return;  // the question is about the scene in hand
    Result<SceneDocument> result = loading.document->take();
    loading.document.reset();
    if (const Problem* problem = problem_of(result)) return state.notifications.add(*problem);
    auto& document = std::get<SceneDocument>(result);
    if (same_description(state.editor.scene(), loading.scene_then) || !state.editor.unsaved())
        return take_loaded(state, std::move(document));
    // Work went on while it was loading: it is not thrown away unasked.
    state.pending =
        loading.recovery
            ? Pending{.what = Pending::What::Recover, .path = loading.recovery->autosave, .asking = true}
            : Pending{.what = Pending::What::Open, .path = loading.path, .asking = true};
    loading.loaded = std::move(document);
}

/// Opens a scene or a mesh. What else a window takes is named where it is neither.
Result<SceneDocument> opened(const std::string& path) {
    Result<SceneDocument> result = open_document(path);
    if (auto* problem = std::get_if<Problem>(&result);
        problem != nullptr && problem->expected == opened_files)
        problem->expected = fmt::format(
            "{}, a lesson (.md) or a picture that another program drew (.png, .pfm, .exr)", opened_files);
    return result;
}

/// Begins to load a document, in place of the one that was being loaded.
void begin_document(UiState& state, const std::string& path, const std::string& name, LoadJob::Work work,
                    std::optional<Recovery> recovery) {
    Loading& loading = state.loading;
    leave(loading, loading.document);
    loading.loaded.reset();
    loading.recovery = std::move(recovery);
    loading.course.reset();
    loading.path = path;
    loading.scene_then = state.editor.scene();
    loading.since = ImGui::GetTime();
    loading.document = std::make_unique<LoadJob>(name, std::move(work));
}

}  // namespace

bool is_quick(const PrimitiveMesh& mesh) {
    if (mesh.decimate > 0 || mesh.subdivide > 3) return false;
    // Triangles go with the square of the detail; a largest one has about 8 million
    // (models/primitives/primitives.cpp).
    const int most = info_of(mesh.primitive).max_detail >> (mesh.subdivide > 0 ? mesh.subdivide + 1 : 0);
    if (mesh.primitive == Primitive::Icosphere)
        return mesh.detail + mesh.subdivide <= 6;  // there with its power of 4
    return most <= 8 || mesh.detail <= most / 6;
}

void begin_open(UiState& state, const std::string& path) {
    Loading& loading = state.loading;
    if (loading.loaded && !loading.recovery && loading.path == path)
        return take_loaded(state, *std::exchange(loading.loaded, std::nullopt));
    const std::string name = fs::path(path).filename().string();
    if (!is_lesson_file(path))
        return begin_document(state, path, name, [path](LoadProgress&) { return opened(path); }, {});
    const auto course = std::make_shared<std::shared_ptr<const Course>>();
    const auto work = [path, course](LoadProgress&) -> Result<SceneDocument> {
        Result<std::shared_ptr<const Course>> opened = open_course(path);
        if (const Problem* problem = problem_of(opened)) return *problem;
        *course = std::get<std::shared_ptr<const Course>>(std::move(opened));
        return (*course)->document;
    };
    begin_document(state, path, name, work, {});
    state.loading.course = course;
}

void recover_autosave(UiState& state, const std::string& path) {
    Loading& loading = state.loading;
    if (loading.loaded && loading.recovery && loading.recovery->autosave == path)
        return take_loaded(state, *std::exchange(loading.loaded, std::nullopt));
    const auto in_file = std::make_shared<Scene>();
    const auto work = [path, in_file](LoadProgress&) -> Result<SceneDocument> {
        Result<SceneDocument> copy = open_autosave(path);
        if (problem_of(copy) != nullptr) return copy;
        const Result<SceneDocument> file = open_document(std::get<SceneDocument>(copy).path);
        if (const auto* document = std::get_if<SceneDocument>(&file)) *in_file = document->scene;
        return copy;
    };
    begin_document(state, path, "Copy of the unsaved work", work, Recovery{path, in_file});
}

void begin_mesh(UiState& state, const MeshSource& source, int index) {
    auto& objects = state.editor.scene().objects;
    if (index >= 0 && static_cast<std::size_t>(index) < objects.size()) {
        Object& object = objects[static_cast<std::size_t>(index)];
        object.source = source;
        object.mesh = nullptr;
    } else {
        state.loading.awaited.push_back({source, source, nullptr});
    }
}

void poll_loads(UiState& state) {
    Loading& loading = state.loading;
    poll_document(state);
    poll_meshes(state);
    const auto ended = [](const std::unique_ptr<LoadJob>& job) { return job->done(); };
    loading.left.erase(std::remove_if(loading.left.begin(), loading.left.end(), ended), loading.left.end());
}

bool awaits_mesh(const UiState& state) {
    const auto& list = state.loading.awaited;
    return std::any_of(list.begin(), list.end(),
                       [](const AwaitedMesh& a) { return a.mesh_before != nullptr; });
}

Scene as_made(const UiState& state, Scene scene) {
    const Scene& present = state.editor.history.present();
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        Object& object = scene.objects[i];
        for (const AwaitedMesh& awaited : state.loading.awaited)
            if (waits(object, awaited)) object.source = awaited.before;
        // Edited in this very frame: it will be awaited in the next.
        if (object.mesh || is_quick(object.source) || i >= present.objects.size()) continue;
        object.source = present.objects[i].source;
        object.mesh = present.objects[i].mesh;
    }
    return scene;
}

SceneDocument document_as_made(const UiState& state) {
    SceneDocument document = state.editor.document;
    document.scene = as_made(state, std::move(document.scene));
    return document;
}

void cancel_loads(UiState& state) {
    give_up_meshes(state);
    leave(state.loading, state.loading.meshes);
    leave(state.loading, state.loading.document);
    state.loading.loaded.reset();
}

}  // namespace glint
