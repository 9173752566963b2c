// Frames of an animation as files.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "models/io/file.h"
#include "renderer/image/image_file.h"
#include "ui/document/file_dialog.h"
#include "ui/export/animation.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

struct FrameJob {
    SceneDocument document;
    Animation animation;
    std::string path;
    PictureSize size;
    int samples = 1, frames_a_second = 25, threads = 0;
};

/// Calls `take` with each frame's scene and picture; stops at the first problem, or when it is cancelled.
template <class Take>
std::optional<Problem> for_each_frame(const FrameJob& job, LoadProgress& progress, Take take) {
    // A GIF's frame needs its colours apart, and its indices.
    const MemoryShare share(memory_need(MemoryUse::Output, png_memory(job.size)));
    Renderer renderer(job.threads);
    for (int frame = 0; frame < job.animation.frames; ++frame) {
        if (!report_progress(LoadStage::Reading, std::uint64_t(frame), std::uint64_t(job.animation.frames)) ||
            progress.cancelled)
            return Problem{job.path, "", "writing was cancelled", ""};
        const PartOfProgress meshes;  // of a frame whose fineness is animated
        const Result<Scene> scene = scene_at(job.document, job.animation, frame);
        if (const Problem* problem = problem_of(scene)) return *problem;
        const auto& shown = std::get<Scene>(scene);
        const PictureSize size{job.size.width, job.size.height, true};
        if (auto problem = take(frame, shown, renderer.render(shown, size, false, job.samples)))
            return problem;
    }
    return {};
}

Result<std::string> write_pngs(const FrameJob& job, LoadProgress& progress) {
    const auto take = [&job](int frame, const Scene& scene,
                             const Picture& picture) -> std::optional<Problem> {
        const std::string path = frame_path(job.path, frame);
        const std::string carried = carried_scene_text(scene, job.document.mesh_dir, path);
        const auto written = write_file_at_once(path, png_bytes(picture, carried));
        if (const Problem* problem = problem_of(written)) return *problem;
        return {};
    };
    if (const auto problem = for_each_frame(job, progress, take)) return *problem;
    return fmt::format("Wrote {} frames: {} to {}", job.animation.frames,
                       fs::path(frame_path(job.path, 0)).filename().string(),
                       fs::path(frame_path(job.path, job.animation.frames - 1)).filename().string());
}

/// How long a frame is shown: whole hundredths of a second, which over many frames keep the speed.
int hundredths_of(int frame, int frames_a_second) {
    const auto begins = [frames_a_second](int at) {
        return (100 * at + frames_a_second / 2) / frames_a_second;
    };
    return begins(frame + 1) - begins(frame);
}

Result<std::string> write_gif(const FrameJob& job, LoadProgress& progress) {
    GifWriter gif(job.size);
    const auto take = [&](int frame, const Scene&, const Picture& picture) -> std::optional<Problem> {
        if (gif.add(picture, hundredths_of(frame, job.frames_a_second))) return {};
        return Problem{job.path, "", "the GIF does not fit in memory", "fewer or smaller frames"};
    };
    if (const auto problem = for_each_frame(job, progress, take)) return *problem;
    const Result<std::string> bytes = gif.finish();
    if (const Problem* problem = problem_of(bytes)) return *problem;
    const auto written = write_file_at_once(job.path, std::get<std::string>(bytes));
    if (const Problem* problem = problem_of(written)) return *problem;
    return fmt::format("Wrote {} with {} frames", fs::path(job.path).filename().string(),
                       job.animation.frames);
}

/// Why one of the files to be written cannot be, the first of them; nothing where all can.
std::optional<Problem> why_not_all_writable(const FrameJob& job, bool gif) {
    if (gif) return why_not_writable(job.path);
    for (int frame = 0; frame < job.animation.frames; ++frame)
        if (auto problem = why_not_writable(frame_path(job.path, frame))) return problem;
    return {};
}

}  // namespace

void begin_frames(UiState& state, const std::string& path, PictureSize size, int samples) {
    AnimateState& animate = state.animate;
    const FrameJob job{
        document_as_made(state),        animate.animation, path, size, samples, animate.frames_a_second,
        state.renderer->stats().threads};
    const bool gif = lower_extension(path) == ".gif";
    // Drawing takes long, and replaces frames that were there: what can be told before it is told now.
    if (const auto problem = why_not_all_writable(job, gif)) return state.notifications.add(*problem);
    animate.playing = false;
    animate.open = true;  // it says how far they have come
    animate.job = std::make_unique<Job<std::string>>(
        fs::path(path).filename().string(), [job, gif](LoadProgress& progress) {
            return gif ? write_gif(job, progress) : write_pngs(job, progress);
        });
}

}  // namespace glint
