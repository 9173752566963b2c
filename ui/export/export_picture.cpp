#include "ui/export/export_picture.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
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

std::string lower_extension(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension;
}

}  // namespace

Result<std::string> picture_file(const SceneDocument& document, const ExportOptions& options,
                                 const std::string& path, int threads) {
    const std::string extension = lower_extension(path);
    if (extension != ".png" && extension != ".pfm" && extension != ".exr")
        return Problem{path, "", "cannot be written", "a name that ends in .png, .pfm or .exr"};
    const std::uint64_t bytes = extension == ".pfm"   ? pfm_memory(options.size)
                                : extension == ".exr" ? exr_memory(options.size)
                                                      : png_memory(options.size);
    const MemoryShare share(memory_need(MemoryUse::Output, bytes));
    Renderer renderer(threads);
    const Picture& picture =
        renderer.render(document.scene, options.size, extension != ".png", options.samples);
    const float exposure = document.scene.display.exposure;
    if (extension == ".pfm") return pfm_bytes(picture, exposure);
    if (extension == ".exr") return exr_bytes(picture, exposure);
    return png_bytes(picture,
                     scene_text(with_mesh_paths_from(document.scene, document.mesh_dir, directory_of(path))));
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

float begin_over_picture(const char* id, float widest, const Rect& picture, int more) {
    const float width = std::min(widest, ImGui::GetIO().DisplaySize.x - px(20));
    const float middle = std::max((picture.low.x + picture.high.x) / 2, width / 2);
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

}  // namespace glint
