#include "ui/document/loading.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "models/fields/choices.h"
#include "models/io/file.h"
#include "models/json/json.h"
#include "ui/document/document_actions.h"
#include "ui/document/editor.h"
#include "ui/document/scene_edit.h"
#include "ui/feature.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// Opens a loaded document. It is a file, or an orphaned copy, which is unsaved and belongs to this window
/// from now on.
void take_loaded(UiState& state, SceneDocument document) {
    Loading& loading = state.loading;
    // If the new scene cannot be drawn, the current one is restored, and must not have a gesture in progress.
    (void)cancel_gesture(state.viewport, state.editor.scene());
    give_up_meshes(state);
    std::optional<Recovery> recovery = std::exchange(loading.recovery, std::nullopt);
    if (recovery) drop_autosave(state);
    take_scene(state, std::move(document));
    if (recovery) {  // before anything that may fail, because the current document is unsaved
        state.editor.saved_edited_camera = recovery->in_file->camera;
        state.editor.saved = std::move(*recovery->in_file);
        keep_orphan(state, recovery->autosave);
    }
    state.notifications.add(state.editor.document.warnings);
    tell_averaged_normals(state);
    if (const auto opened = std::exchange(loading.opened, nullptr)) opened(state);
}

/// Adds the other kinds of file that the window opens to the message about a file of an unknown kind.
Problem with_all_that_opens(Problem problem) {
    if (problem.expected == opened_files)
        problem.expected = fmt::format(
            "{}, a lesson (.md) or a picture that another program drew (.png, .pfm, .exr)", opened_files);
    return problem;
}

/// A picture from another program cannot be opened, but it can be compared with the scene.
void offer_comparison(UiState& state) {
    const std::string ending = lower_extension(state.loading.failed);
    if (ending != ".png" && ending != ".pfm" && ending != ".exr" && ending != ".glsl") return;
    Notification& note = state.notifications.list.back();
    note.button = "Compare with the open scene";
    note.press = [path = state.loading.failed](UiState& s) {
        for (const Feature* feature : features())
            if (feature->drop != nullptr && feature->drop(s, path)) return;
    };
}

void poll_document(UiState& state) {
    Loading& loading = state.loading;
    // Drops the loaded document if the user has cancelled. After "Save" the document waits until the user has
    // entered a name: read from its file again, it would lack the assignments of --set, or would not be a
    // lesson.
    if (!state.pending.then) loading.loaded.reset();
    if (!loading.document || !loading.document->done()) return;
    if (state.pending.asking) return;  // the question is about the current scene
    Result<SceneDocument> result = loading.document->take();
    loading.document.reset();
    if (const Problem* problem = problem_of(result)) {
        loading.failed = loading.path;
        state.notifications.add(with_all_that_opens(*problem));
        return offer_comparison(state);
    }
    auto& document = std::get<SceneDocument>(result);
    if (same_description(state.editor.scene(), loading.scene_then) || !state.editor.unsaved() ||
        drops_changes(state))
        return take_loaded(state, std::move(document));
    // Edits have been made during the load: ask before discarding them.
    loading.loaded = std::move(document);
    state.pending = {[](UiState& s) {
                         if (auto loaded = std::exchange(s.loading.loaded, std::nullopt))
                             take_loaded(s, *std::move(loaded));
                     },
                     true};
}

/// Starts waiting for a document, in place of the one being loaded.
void await_document(UiState& state, Opening opening, std::optional<Recovery> recovery) {
    Loading& loading = state.loading;
    leave(loading.document);
    loading.loaded.reset();
    loading.recovery = std::move(recovery);
    loading.opened = std::move(opening.opened);
    loading.path = std::move(opening.path);
    loading.failed.clear();
    loading.scene_then = state.editor.scene();
    loading.since = ImGui::GetTime();
    loading.document = state.jobs.add(std::move(opening.job));
}

}  // namespace

void begin_open(UiState& state, const std::string& path) { await_opening(state, opening_of(path)); }

void await_opening(UiState& state, Opening opening) { await_document(state, std::move(opening), {}); }

Opening opening_of(const std::string& path, const std::vector<Assignment>& assignments) {
    for (const Feature* feature : features())
        if (feature->open != nullptr)
            if (std::optional<Opening> opening = feature->open(path)) return *std::move(opening);
    const auto work = [path, assignments](LoadProgress&) { return open_document(path, assignments); };
    return {path, std::make_shared<LoadJob>(fs::path(path).filename().string(), work), nullptr};
}

void recover_autosave(UiState& state, const std::string& path) {
    const auto in_file = std::make_shared<Scene>();
    const auto work = [path, in_file](LoadProgress&) -> Result<SceneDocument> {
        Result<SceneDocument> copy = open_autosave(path);
        if (problem_of(copy) != nullptr) return copy;
        const Result<SceneDocument> file = open_document(std::get<SceneDocument>(copy).path);
        if (const auto* document = std::get_if<SceneDocument>(&file)) *in_file = document->scene;
        return copy;
    };
    await_document(state, {path, std::make_shared<LoadJob>("Copy of the unsaved work", work), nullptr},
                   Recovery{path, in_file});
}

void poll_loads(UiState& state) {
    poll_document(state);
    poll_meshes(state);
}

void cancel_loads(UiState& state) {
    give_up_meshes(state);
    leave(state.loading.document);
    state.loading.loaded.reset();
}

// Temporary panels over the picture: the progress of a load, with a cancel button, and the offer to recover a
// copy left by a crash.

namespace {

constexpr double shown_after = 0.25;      // seconds: a shorter load shows no panel
constexpr double seconds_a_frame = 0.03;  // time between frames while something loads

/// Draws a progress bar; if the completed fraction is unknown, a segment moves along the bar.
void bar(float share) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = px(5);
    ImGui::Dummy({width, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + height}, to_u32(theme().field_active), px(2));
    float from = 0, to = share;
    if (share < 0) {
        from = static_cast<float>(0.5 - 0.5 * std::cos(ImGui::GetTime() * 3)) * 0.75f;
        to = from + 0.25f;
    }
    list.AddRectFilled({low.x + from * width, low.y}, {low.x + to * width, low.y + height},
                       to_u32(theme().accent), px(2));
}

/// Begins a panel centred at the picture's upper edge, at most `widest` wide and never cut off at the
/// window's sides; end_over_picture() must follow. Returns its width.
float begin_over_picture(const char* id, float widest, const Rect& picture, ImGuiWindowFlags more = 0) {
    const float window = ImGui::GetIO().DisplaySize.x, width = std::min(widest, window - px(20));
    const float middle = std::clamp((picture.low.x + picture.high.x) / 2, width / 2, window - width / 2);
    ImGui::SetNextWindowPos({middle, picture.low.y + px(14)}, ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing | more);
    return width;
}

void end_over_picture() {
    ImGui::End();
    ImGui::PopStyleVar();
}

/// "reading 12 of 37 MB", "building the mesh: 400000 faces": the progress of a load.
std::string progress_words(const LoadProgress& progress) {
    const std::uint64_t done = progress.done, total = progress.total;
    const auto megabytes = [](std::uint64_t bytes) { return static_cast<double>(bytes) * 1e-6; };
    switch (progress.stage.load()) {
    case LoadStage::Reading:
        if (total == 0) return "reading";
        return fmt::format("reading {:.1f} of {:.1f} MB", megabytes(done), megabytes(total));
    case LoadStage::Parsing:
        return fmt::format("parsing {:.1f} of {:.1f} MB", megabytes(done), megabytes(total));
    case LoadStage::Building:
        if (total > 0) return fmt::format("building the mesh: {} of {} faces", done, total);
        return done == 0 ? "building the mesh" : fmt::format("building the mesh: {} faces", done);
    }
    return {};  // not reached
}

}  // namespace

float progress_share(const LoadProgress& progress) {
    const std::uint64_t done = progress.done, total = progress.total;
    if (total == 0) return -1;
    return static_cast<float>(std::min(1.0, static_cast<double>(done) / static_cast<double>(total)));
}

bool progress_panel(const AnyJob& job, double since, const Rect& picture) {
    redraw_within(seconds_a_frame);
    if (ImGui::GetTime() - since < shown_after) return false;
    const float width = begin_over_picture("##loading", px(400), picture, ImGuiWindowFlags_NoNav);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(file_title(job.name()).c_str());
    ImGui::SameLine(width - px(90));
    const bool cancelled = ImGui::Button("Cancel", {px(80), 0});
    tooltip("Cancel", "The scene does not change");
    ImGui::PushFont(fonts().small);
    dim_text(progress_words(job.progress()).c_str());
    ImGui::PopFont();
    bar(progress_share(job.progress()));
    end_over_picture();
    return cancelled;
}

void loading_panel(UiState& state, const Rect& picture) {
    const LoadJob* job = state.loading.document ? state.loading.document.get() : state.loading.meshes.get();
    if (job != nullptr && progress_panel(*job, state.loading.since, picture)) cancel_loads(state);
}

namespace {

/// Whether the window is being presented to an audience, so that nothing may pop up by itself.
bool is_shown_to_others(const UiState& state) {
    const auto is_presented = [&state](const Feature* feature) {
        return feature->is_presented != nullptr && feature->is_presented(state);
    };
    return state.layout.hides_columns || state.layout.hides_all ||
           std::any_of(features().begin(), features().end(), is_presented);
}

}  // namespace

void answer_copy(UiState& state, CopyAnswer answer) {
    auto& left = state.persistence.orphans;
    if (answer == CopyAnswer::Recover)
        return ask_first(state, [path = left.front().lock.path](UiState& s) { recover_autosave(s, path); });
    const std::string copy = left.front().lock.path;
    std::error_code failed;
    if (answer == CopyAnswer::Discard) std::filesystem::remove(copy, failed);
    if (failed)
        state.notifications.add(
            Problem{copy, "", "cannot be removed: " + failed.message(), "a folder of your own"});
    left.erase(left.begin());
}

void recovery_panel(UiState& state, const Rect& picture) {
    auto& left = state.persistence.orphans;
    if (left.empty() || state.pending.asking || state.loading.active() || is_shown_to_others(state)) return;
    const float width = begin_over_picture("##recovery", px(470), picture);
    ImGui::PushTextWrapPos(width - px(14));
    ImGui::TextUnformatted(fmt::format("Glint closed while {} had unsaved changes. A copy from {} was kept.",
                                       left.front().title, left.front().when)
                               .c_str());
    ImGui::PopTextWrapPos();
    const bool open = ImGui::Button("Recover", {px(110), 0});
    tooltip("Recover", "Opens the copy; the file does not change until you save");
    ImGui::SameLine();
    const bool discard = ImGui::Button("Discard", {px(110), 0});
    tooltip("Discard", "Deletes the copy");
    ImGui::SameLine();
    const bool later = ImGui::Button("Not now", {px(110), 0});
    tooltip("Not now", "Asks again at the next start");
    small_dim(fmt::format("{}: recover, discard, not now", keys_of(CommandId::Palette)));
    end_over_picture();
    if (open) return answer_copy(state, CopyAnswer::Recover);
    if (discard) return answer_copy(state, CopyAnswer::Discard);
    if (later) answer_copy(state, CopyAnswer::NotNow);
}

// Provides the meshes that an edit requires: built at once if that is quick, else loaded in the background.

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

/// Returns whether an object that was waiting for its mesh was deleted. The deletion is not yet an undo step
/// of its own.
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

/// Identifies a mesh of `scene` by name in a problem, because a new object does not have an index yet.
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

/// Assigns the new mesh to the objects that are waiting for it; if the mesh is for a new object, adds that
/// object.
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
/// before the drag, without the meshes.
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
                return false;  // the mesh was requested after the current load began
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
