#include "ui/export/export_picture.h"

#include <fmt/core.h>
#include <imgui.h>

#include <filesystem>

#include "models/io/file.h"
#include "renderer/image/image_file.h"
#include "ui/export/clipboard.h"
#include "ui/ui.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

namespace {

namespace fs = std::filesystem;

constexpr double seconds_a_look = 0.1;  // between looks whether it is done

}  // namespace

Result<std::string> picture_file(const SceneDocument& document, const ExportOptions& options,
                                 const std::string& path, int threads) {
    const Result<PictureFormat> known = picture_format(path);
    if (const Problem* problem = problem_of(known)) return *problem;
    const auto format = std::get<PictureFormat>(known);
    const MemoryShare share(memory_need(MemoryUse::Output, file_memory(format, options.size)));
    Renderer renderer(threads);
    const Picture& picture =
        renderer.render(document.scene, options.size, is_linear(format), options.samples);
    return picture_bytes(picture, format, document.scene.display.exposure,
                         carried_scene_text(document.scene, document.mesh_dir, path));
}

void begin_export(UiState& state, const ExportOptions& options, const std::string& path) {
    const int threads = state.renderer->stats().threads;
    const std::string name = fs::path(path).filename().string();
    state.exporting.since = ImGui::GetTime();
    state.exporting.job = std::make_unique<Job<std::string>>(
        name,
        [document = state.editor.document, options, path, name,
         threads](LoadProgress& progress) -> Result<std::string> {
            const Result<std::string> bytes = picture_file(document, options, path, threads);
            if (const Problem* problem = problem_of(bytes)) return *problem;
            if (progress.cancelled) return Problem{path, "", "writing was cancelled", ""};
            const auto written = write_file(path, std::get<std::string>(bytes));
            if (const Problem* problem = problem_of(written)) return *problem;
            return fmt::format("Saved {} ({} × {}, {} {} a pixel)", name, options.size.width,
                               options.size.height, options.samples,
                               options.samples == 1 ? "sample" : "samples");
        });
}

void begin_copy(UiState& state) {
    const int threads = state.renderer->stats().threads;
    const PictureSize size = state.rendered->size;
    state.exporting.since = ImGui::GetTime();
    state.exporting.job = std::make_unique<Job<std::string>>(
        "Copy",
        [document = state.editor.document, size, threads](LoadProgress& progress) -> Result<std::string> {
            const Result<std::string> bytes = picture_file(document, {size, 1}, "clipboard.png", threads);
            if (const Problem* problem = problem_of(bytes)) return *problem;
            if (progress.cancelled) return Problem{"Copy", "", "was cancelled", ""};
            const auto copied = copy_png(std::get<std::string>(bytes));
            if (const Problem* problem = problem_of(copied)) return *problem;
            return fmt::format("The picture is on the clipboard ({} × {})", size.width, size.height);
        });
}

void poll_export(UiState& state) {
    auto& job = state.exporting.job;
    if (!job) return;
    if (!job->done()) return redraw_within(seconds_a_look);
    const Result<std::string> result = job->take();
    job.reset();
    if (const Problem* problem = problem_of(result)) return state.notifications.add(*problem);
    state.notifications.add(Tone::Done, std::get<std::string>(result));
}

}  // namespace glint
