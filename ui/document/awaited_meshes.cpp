// Provides the meshes that an edit requires: built at once if that is quick, else loaded in the background.
#include <algorithm>
#include <utility>

#include "models/fields/choices.h"
#include "models/json/json.h"
#include "ui/document/loading.h"
#include "ui/document/scene_edit.h"
#include "ui/ui.h"

namespace glint {
namespace {

using Objects = std::vector<Object>;

bool waits(const Object& object, const AwaitedMesh& awaited) {
    return awaited.mesh_before && object.source == awaited.wanted && object.mesh == awaited.mesh_before;
}

/// Returns the source of the object's current mesh, which differs from the object's source while a mesh is
/// awaited.
MeshSource made_of(const Object& object, const std::vector<AwaitedMesh>& awaited) {
    const auto own = [&object](const AwaitedMesh& a) { return waits(object, a); };
    const auto found = std::find_if(awaited.begin(), awaited.end(), own);
    return found == awaited.end() ? object.source : found->before;
}

bool is_quick(const MeshSource& source) {
    const auto* primitive = std::get_if<PrimitiveMesh>(&source);
    return primitive != nullptr && is_quick(*primitive);
}

/// Returns objects[index] in its state before its source was edited, from `known`; nothing else in it has
/// changed. Null if unknown because objects were added or deleted at the same time.
const Object* before_edit(const Objects& known, const Objects& objects, std::size_t index) {
    const int place = place_in(objects, known, static_cast<int>(index));
    if (place < 0 || place >= std::ssize(known)) return nullptr;
    const Object& before = known[static_cast<std::size_t>(place)];
    Object edited = objects[index];
    edited.source = before.source;
    edited.mesh = before.mesh;
    return before.mesh && edited == before ? &before : nullptr;
}

/// Returns a mesh with the same source from the scene or the newest step; null if neither has one.
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

/// Records edits that left an object without its mesh: the object keeps the old mesh until the new one is
/// ready.
void note_slow_edits(UiState& state) {
    Scene& scene = state.editor.scene();
    Loading& loading = state.loading;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        Object& object = scene.objects[i];
        if (!awaits_slow_mesh(object)) continue;
        object.mesh = known_mesh(scene, state.editor.history.present(), object.source, loading.awaited);
        if (object.mesh) continue;
        const Object* before = before_edit(loading.known, scene.objects, i);
        if (before == nullptr) continue;
        object.mesh = before->mesh;
        loading.awaited.push_back({object.source, made_of(*before, loading.awaited), before->mesh});
    }
}

/// Returns whether an object was deleted while it waited. The deletion is not yet a step of its own.
bool is_deleted(const Editor& editor, const AwaitedMesh& awaited) {
    const auto has_it = [&](const Scene& scene) {
        return std::any_of(scene.objects.begin(), scene.objects.end(),
                           [&](const Object& object) { return object.mesh == awaited.mesh_before; });
    };
    return awaited.mesh_before && has_it(editor.history.present()) && !has_it(editor.scene());
}

/// Drops meshes that are no longer needed because the edit was undone, or the object deleted or changed
/// again.
void forget_unwanted(UiState& state) {
    const auto& objects = state.editor.scene().objects;
    const auto unwanted = [&objects](const AwaitedMesh& awaited) {
        const auto own = [&awaited](const Object& object) { return waits(object, awaited); };
        return awaited.mesh_before && std::none_of(objects.begin(), objects.end(), own);
    };
    auto& list = state.loading.awaited;
    if (std::any_of(list.begin(), list.end(), [&](const auto& a) { return is_deleted(state.editor, a); }))
        state.notifications.tell(
            "The object was deleted before its new mesh was ready: undo restores it with the old one");
    list.erase(std::remove_if(list.begin(), list.end(), unwanted), list.end());
    if (list.empty()) leave(state.loading.meshes);
}

/// Names the mesh in a problem with a mesh of `scene`, because a new object does not have an index yet.
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
    loading.meshes = state.jobs.start<SceneDocument>(
        short_name(loading.awaited.front().wanted),
        [wanting, path = document.path, dir = document.mesh_dir](LoadProgress&) -> Result<SceneDocument> {
            Scene scene = wanting;
            Result<Warnings> loaded = load_meshes(scene, path, dir);
            if (const Problem* problem = problem_of(loaded)) return about_its_mesh(*problem, wanting);
            return SceneDocument{std::move(scene), path, dir, std::get<Warnings>(std::move(loaded))};
        });
    loading.since = ImGui::GetTime();
}

/// Assigns the new mesh to the objects that wait for it; adds an object if there are none.
void give_mesh(UiState& state, const AwaitedMesh& awaited, const MeshPtr& mesh) {
    Editor& editor = state.editor;
    for (Object& object : editor.scene().objects)
        if (waits(object, awaited)) object.mesh = mesh;
    if (awaited.mesh_before) return;
    if (add_object(editor.scene(), editor.selection, awaited.wanted))
        editor.scene().objects.back().mesh = mesh;
}

/// Whether only the resolution of a mesh was edited. Then the panel shows the message next to the sliders,
/// since a drag causes many such edits.
bool has_other_resolution(const AwaitedMesh& awaited) {
    return awaited.mesh_before && as_given(awaited.wanted) == as_given(awaited.before);
}

/// Whether the meshes can be assigned. Not during a drag in the picture: Esc would restore the scene from
/// before the drag, without them.
bool meshes_have_come(const UiState& state) {
    const JobPtr<SceneDocument>& job = state.loading.meshes;
    return job && job->done() && state.viewport.gesture == Gesture::None;
}

}  // namespace

bool awaits_slow_mesh(const Object& object) { return !object.mesh && !is_quick(object.source); }

void poll_meshes(UiState& state) {
    note_slow_edits(state);
    forget_unwanted(state);
    Loading& loading = state.loading;
    if (meshes_have_come(state)) {
        const Result<SceneDocument> result = loading.meshes->take();
        loading.meshes.reset();
        if (const Problem* problem = problem_of(result)) {
            state.notifications.add(*problem);
            give_up_meshes(state);
        } else {
            const auto& loaded = std::get<SceneDocument>(result);
            auto& list = loading.awaited;
            if (!std::all_of(list.begin(), list.end(), has_other_resolution))
                state.notifications.add(loaded.warnings);
            const auto come = [&](const AwaitedMesh& awaited) {
                for (const Object& object : loaded.scene.objects)
                    if (object.source == awaited.wanted && object.mesh != awaited.mesh_before) {
                        give_mesh(state, awaited, object.mesh);
                        if (!has_other_resolution(awaited)) say_averaged(state, object);
                        return true;
                    }
                return false;  // needed only since the current load began
            };
            list.erase(std::remove_if(list.begin(), list.end(), come), list.end());
        }
    }
    start_meshes(state);
    if (const auto problem = settle(state.editor)) state.notifications.add(*problem);
    if (loading.known != state.editor.scene().objects) loading.known = state.editor.scene().objects;
}

void give_up_meshes(UiState& state) {
    Loading& loading = state.loading;
    Scene made = as_made(state, state.editor.scene());
    state.editor.scene() = std::move(made);
    for (Object& object : loading.known) object.source = made_of(object, loading.awaited);
    loading.awaited.clear();
    leave(loading.meshes);
}

void undo_awaiting(UiState& state) {
    give_up_meshes(state);
    if (remember_step(state.editor, false)) undo(state.editor);
}

bool is_quick(const PrimitiveMesh& mesh) {
    if (mesh.decimate > 0 || mesh.subdivide > 3) return false;
    // The number of triangles grows with the square of the detail; the largest mesh has about 8 million
    // (models/mesh/primitives/primitives.cpp).
    const int most = info_of(mesh.primitive).max_detail >> (mesh.subdivide > 0 ? mesh.subdivide + 1 : 0);
    if (mesh.primitive == Primitive::Icosphere)
        return mesh.detail + mesh.subdivide <= 6;  // an icosphere grows by powers of 4
    return most <= 8 || mesh.detail <= most / 6;
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

bool awaits_mesh(const UiState& state) {
    const auto& list = state.loading.awaited;
    const auto& objects = state.editor.scene().objects;
    return std::any_of(list.begin(), list.end(),
                       [](const AwaitedMesh& a) { return a.mesh_before != nullptr; }) ||
           std::any_of(objects.begin(), objects.end(), awaits_slow_mesh);
}

Scene as_made(const UiState& state, Scene scene) {
    const Objects& known = state.loading.known;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        Object& object = scene.objects[i];
        // An object edited in this frame waits for its mesh from the next frame on.
        if (const Object* before = awaits_slow_mesh(object) ? before_edit(known, scene.objects, i) : nullptr)
            object = *before;
        object.source = made_of(object, state.loading.awaited);
    }
    return scene;
}

SceneDocument document_as_made(const UiState& state) {
    SceneDocument document = state.editor.document;
    document.scene = as_made(state, std::move(document.scene));
    return document;
}

}  // namespace glint
