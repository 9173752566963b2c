// Writes the frames of an animation to files.
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "models/io/file.h"
#include "renderer/image/animation_file.h"
#include "renderer/image/image_file.h"
#include "ui/document/file_dialog.h"
#include "ui/features/export/animation.h"
#include "ui/features/export/clipboard.h"
#include "ui/features/export/export_picture.h"
#include "ui/picture/picture_notes.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

struct FrameJob {
    SceneDocument document;
    Animation animation;
    std::string path;
    std::optional<AnimationFormat> format;  // none: each frame is its own PNG
    PictureSize size;
    int samples = 1, frames_a_second = 25, threads = 0;
};

/// Calls `take` with each frame's scene and picture; stops at the first problem, or when cancelled.
template <class Take>
std::optional<Problem> for_each_frame(const FrameJob& job, LoadProgress& progress, Take take) {
    Renderer renderer(job.threads);
    for (int frame = 0; frame < job.animation.frames; ++frame) {
        if (!report_progress(LoadStage::Reading, std::uint64_t(frame), std::uint64_t(job.animation.frames)) ||
            progress.cancelled)
            return Problem{job.path, "", "writing was cancelled", ""};
        const PartOfProgress meshes;  // meshes of a frame with an animated resolution
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

/// Writes all frames into one file.
Result<std::string> write_animation(const FrameJob& job, LoadProgress& progress) {
    const auto of_file = [&job](Problem problem) {
        problem.file = job.path;
        return problem;
    };
    const auto made = animation_writer(*job.format, job.size, job.frames_a_second);
    if (const Problem* problem = problem_of(made)) return of_file(*problem);
    const auto& writer = std::get<std::unique_ptr<AnimationWriter>>(made);
    const auto take = [&](int, const Scene&, const Picture& picture) -> std::optional<Problem> {
        auto problem = writer->add(picture);
        if (problem) return of_file(*problem);
        return {};
    };
    if (const auto problem = for_each_frame(job, progress, take)) return *problem;
    const Result<std::string> bytes = writer->finish();
    if (const Problem* problem = problem_of(bytes)) return of_file(*problem);
    const auto written = write_file_at_once(job.path, std::get<std::string>(bytes));
    if (const Problem* problem = problem_of(written)) return *problem;
    return fmt::format("Wrote {} with {} frames", fs::path(job.path).filename().string(),
                       job.animation.frames);
}

/// Makes ffmpeg write a video of all frames. The frames are kept as PNG in an unnamed file, so that only the
/// complete video appears in the folder.
Result<std::string> write_video(const FrameJob& job, LoadProgress& progress) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> frames(std::tmpfile(), std::fclose);
    const Problem full{job.path, "", "the frames do not fit into the folder for temporary files", ""};
    if (!frames) return full;
    const auto take = [&](int, const Scene&, const Picture& picture) -> std::optional<Problem> {
        const std::string bytes = png_bytes(picture, "");
        if (std::fwrite(bytes.data(), 1, bytes.size(), frames.get()) != bytes.size()) return full;
        return {};
    };
    if (const auto problem = for_each_frame(job, progress, take)) return *problem;
    if (std::fflush(frames.get()) != 0) return full;
    std::rewind(frames.get());
    const fs::path path = fs::absolute(job.path),
                   part = path.parent_path() / ("." + path.filename().string() + ".part");
    const std::string rate = std::to_string(job.frames_a_second);
    // Most players show nothing if the number of rows or columns is odd.
    const int status = run_tool({"ffmpeg",     "-y",
                                 "-loglevel",  "error",
                                 "-f",         "image2pipe",
                                 "-framerate", rate,
                                 "-c:v",       "png",
                                 "-i",         "-",
                                 "-vf",        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                 "-pix_fmt",   "yuv420p",
                                 "-crf",       "14",
                                 "-movflags",  "+faststart",
                                 "-f",         "mp4",
                                 part.string()},
                                ::fileno(frames.get()), &progress.cancelled);
    std::error_code failed;
    if (status == 0) fs::rename(part, path, failed);
    if (status == 0 && !failed)
        return fmt::format("Wrote {} with {} frames", path.filename().string(), job.animation.frames);
    fs::remove(part, failed);
    return Problem{job.path, "",
                   progress.cancelled ? "writing was cancelled" : "ffmpeg could not write the video", ""};
}

bool is_video(const std::string& path) { return lower_extension(path) == ".mp4"; }

/// The reason why the first unwritable output file cannot be written; nothing if all can.
std::optional<Problem> why_not_all_writable(const FrameJob& job) {
    if (is_video(job.path) && !mp4_disabled_reason().empty())
        return Problem{job.path, "", mp4_disabled_reason(), ".gif, .webp or .png"};
    if (job.format || is_video(job.path)) return why_not_writable(job.path);
    for (int frame = 0; frame < job.animation.frames; ++frame)
        if (auto problem = why_not_writable(frame_path(job.path, frame))) return problem;
    return {};
}

/// Whether each frame gets its own file.
bool writes_many(const std::string& path) { return !animation_format(path) && !is_video(path); }

/// Whether one of the frames would replace an existing file.
bool has_frames(const std::string& path) {
    const fs::path file(path), folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::error_code failed;
    fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, failed);
    for (; !failed && it != fs::directory_iterator(); it.increment(failed)) {
        const std::string name = it->path().filename().string(), before = file.stem().string() + "-";
        if (!name.starts_with(before)) continue;
        int number = 0;
        std::from_chars(name.data() + before.size(), name.data() + name.size(), number);
        if (number > 0 && name == fs::path(frame_path(path, number - 1)).filename()) return true;
    }
    return false;
}

}  // namespace

const FilePurpose frames_purpose{.title = "Export animation",
                                 .button = "Export",
                                 .hint = "One file (.gif .webp .mp4), or one per frame: NAME-0001.png …",
                                 .extensions = {".gif", ".webp", ".mp4", ".png"},
                                 .saves = true,
                                 .writes_many = writes_many,
                                 .may_replace_many = has_frames,
                                 .use = [](UiState& s, const std::string& path) {
                                     const ExportOptions options = export_options(s);
                                     begin_frames(s, path, options.size, options.samples);
                                 }};

std::string frame_path(const std::string& path, int frame) {
    const fs::path file(path);
    return (file.parent_path() / fmt::format("{}-{:04}.png", file.stem().string(), frame + 1)).string();
}

void begin_frames(UiState& state, const std::string& path, PictureSize size, int samples) {
    AnimateState& animate = state.get<AnimateState>();
    const FrameJob job{document_as_made(state),
                       animate.animation,
                       path,
                       animation_format(path),
                       size,
                       samples,
                       animate.frames_a_second,
                       state.renderer->stats().threads};
    // Drawing takes long and replaces existing frames, so problems are reported before it starts.
    if (const auto problem = why_not_all_writable(job)) return state.notifications.add(*problem);
    animate.playing = false;
    animate.frame.reset();
    animate.open = true;  // it shows the progress
    animate.job = state.jobs.start<Notification>(
        fs::path(path).filename().string(),
        [job, notes = notes_of_edited(state)](LoadProgress& progress) -> Result<Notification> {
            const Result<std::string> written = is_video(job.path) ? write_video(job, progress)
                                                : job.format       ? write_animation(job, progress)
                                                                   : write_pngs(job, progress);
            if (const Problem* problem = problem_of(written)) return *problem;
            return file_message(std::get<std::string>(written), notes);
        });
}

}  // namespace glint
