#include "ui/features/export/export_picture.h"

#include <fmt/core.h>
#include <imgui.h>

#include <filesystem>
#include <functional>
#include <optional>

#include "models/io/file.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "ui/document/document_actions.h"
#include "ui/features/export/clipboard.h"
#include "ui/features/views/views.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/picture_notes.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_a_look = 0.1;  // between checks whether the job is done

/// The open document with the scene in the picture.
SceneDocument shown_document(const UiState& state) {
    SceneDocument document = state.editor.document;
    document.scene = as_made(state, shown_scene(state));
    // Nothing else in the file indicates that the scene is incomplete.
    if (const auto& other = state.on_screen.resting; other && other->is_partial) {
        std::string& about = document.scene.about;
        about = about.empty() ? other->note : other->note + ". " + about;
    }
    return document;
}

/// Draws the shown scene in the background into a picture file for `path` and passes the file's bytes to
/// `deliver`.
void begin_picture(UiState& state, const ExportOptions& options, const std::string& path,
                   const std::function<Result<Notification>(const std::string& bytes)>& deliver) {
    const int threads = state.renderer->stats().threads;
    state.get<ExportState>().job = state.jobs.start<Notification>(
        fs::path(path).filename().string(),
        [document = shown_document(state), options, path, threads,
         deliver](LoadProgress& progress) -> Result<Notification> {
            const Result<std::string> bytes = picture_file(document, options, path, threads);
            if (const Problem* problem = problem_of(bytes)) return *problem;
            if (progress.cancelled) return Problem{path, "", "writing was cancelled", ""};
            return deliver(std::get<std::string>(bytes));
        });
}

}  // namespace

std::string shortest_command(const UiState& state, const CommandText& text) {
    const SceneDocument document = shown_document(state);
    std::string own = text(document, state.editor.saved);
    if (!document.path.empty() || state.shipped_scenes.empty()) return own;
    const std::string first = (fs::path(state.shipped_scenes) / "default.json").string();
    const Result<std::string> read = read_file(first, std::size_t{1} << 20);
    if (problem_of(read) != nullptr) return own;
    const Result<Scene> scene = parse_scene(std::get<std::string>(read), first);
    if (problem_of(scene) != nullptr) return own;
    SceneDocument as_first = document;
    as_first.path = first;
    std::string from_first = text(as_first, std::get<Scene>(scene));
    return from_first.size() < own.size() ? from_first : own;
}

Scene as_shown(Scene scene, PictureSize size) {
    size.keeps_width = true;
    scene.camera.projection = fitted(scene.camera.projection, size);
    return scene;
}

ExportOptions export_options(const UiState& state) {
    ExportOptions options = state.get<ExportState>().options;
    if (options.size == PictureSize{0, 0}) options.size = state.full_size;
    return options;
}

Result<std::string> picture_file(const SceneDocument& document, const ExportOptions& options,
                                 const std::string& path, int threads) {
    const Result<PictureFormat> known = picture_format(path);
    if (const Problem* problem = problem_of(known)) return *problem;
    const auto format = std::get<PictureFormat>(known);
    Renderer renderer(threads);
    const PictureSize size{options.size.width, options.size.height, true};
    const Picture& picture = renderer.render(document.scene, size, is_linear(format), options.samples);
    return picture_bytes(picture, format, document.scene.display.exposure,
                         carried_scene_text(document.scene, document.mesh_dir, path));
}

const FilePurpose save_picture_purpose{.title = "Save the picture",
                                       .button = "Save",
                                       .hint = "Picture (.png) with its scene embedded",
                                       .extensions = {".png"},
                                       .saves = true,
                                       .use = [](UiState& s, const std::string& path) {
                                           begin_export(s, {s.full_size, 1}, path);
                                       }};

const FilePurpose export_purpose{
    .title = "Export the picture",
    .button = "Export",
    .hint = "Picture: .png (with its scene), .pfm, .exr (linear float)",
    .extensions = {".png", ".pfm", ".exr"},
    .saves = true,
    .use = [](UiState& s, const std::string& path) { begin_export(s, export_options(s), path); }};

void ask_for_picture(UiState& state, const FilePurpose& purpose) {
    state.files.ask(purpose, offered_name(state, ".png"));
    state.files.warning = file_warning(notes_of_shown(state));
}

void begin_export(UiState& state, const ExportOptions& options, const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    if (const auto problem = why_not_writable(path)) return state.notifications.add(*problem);
    state.get<ExportState>().last = {options, name, state.editor.document.path};
    std::error_code failed;  // a missing folder is reported on writing
    const std::string folder = fs::absolute(path, failed).lexically_normal().parent_path().string();
    begin_picture(state, options, path,
                  [path, name, folder, options,
                   notes = notes_of_shown(state)](const std::string& bytes) -> Result<Notification> {
                      const auto written = write_file_at_once(path, bytes);
                      if (const Problem* problem = problem_of(written)) return *problem;
                      return file_message(
                          fmt::format("Saved {} in {} ({} × {}, {} {} per pixel)", name, folder,
                                      options.size.width, options.size.height, options.samples,
                                      options.samples == 1 ? "sample" : "samples"),
                          notes);
                  });
}

/// Names the copied picture, which is not the one on the screen if that one is composed.
static const char* copied_words(const UiState& state) {
    return is_composed(state) ? "the scene's own picture" : "this picture";
}

void begin_copy(UiState& state) {
    const PictureSize size = state.full_size;
    begin_picture(state, {size, 1}, "clipboard.png",
                  [size, what = copied_words(state),
                   notes = notes_of_shown(state)](const std::string& bytes) -> Result<Notification> {
                      const auto copied = copy_png(bytes);
                      if (const Problem* problem = problem_of(copied)) return *problem;
                      return file_message(
                          fmt::format("Copied {} to the clipboard ({} × {})", what, size.width, size.height),
                          notes);
                  });
}

void copy_render_command(UiState& state, const ExportOptions& options, const std::string& out) {
    const std::string name = fs::path(out).filename().string();
    const std::string command = shortest_command(state, [&](const SceneDocument& of, const Scene& in_file) {
        return render_command_text(of, in_file, options.size, options.samples, name);
    });
    ImGui::SetClipboardText(command.c_str());
    state.notifications.add(
        Tone::Done, fmt::format("The command that draws {} is on the clipboard: {} × {}, {} {} per pixel, {}",
                                copied_words(state), options.size.width, options.size.height, options.samples,
                                options.samples == 1 ? "sample" : "samples", name));
}

void copy_last_command(UiState& state) {
    const std::optional<LastExport>& last = state.get<ExportState>().last;
    if (last && last->document == state.editor.document.path)
        return copy_render_command(state, last->options, last->file);
    copy_render_command(state, {state.full_size, 1}, offered_name(state, ".png"));
}

void poll_job(JobPtr<Notification>& job, Notifications& notifications) {
    if (!job) return;
    if (!job->done()) return redraw_within(seconds_a_look);
    const Result<Notification> result = job->take();
    job.reset();
    if (const Problem* problem = problem_of(result)) return notifications.add(*problem);
    const auto& done = std::get<Notification>(result);
    notifications.add(done.tone, done.text);
}

}  // namespace glint
