#include "ui/features/export/animation.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "models/io/file.h"
#include "models/json/json.h"
#include "renderer/image/image_file.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/document/file_dialog.h"
#include "ui/feature.h"
#include "ui/features/export/clipboard.h"
#include "ui/features/export/export_picture.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/picture_notes.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Drops the animated number, which the scene no longer has, and reports this if the animation was playing.
void forget_number(UiState& state) {
    AnimateState& animate = state.get<AnimateState>();
    const std::string gone = animate.number.empty() ? animate.animation.pointer : animate.number;
    animate.number.clear();
    animate.animation.pointer.clear();
    animate.refused.clear();
    if (animate.animation.motion != Motion::PingPong) return;
    animate.playing = false;
    state.notifications.tell("Animate: “" + gone + "” no longer exists", Tone::Warning);
}

void follow_moved(UiState& state, const ItemPlaces& places) {
    AnimateState& animate = state.get<AnimateState>();
    if (!places.follow_light(animate.animation.light) && animate.animation.motion == Motion::Circle)
        animate.playing = false;
    if (!places.follow(animate.animation.pointer)) forget_number(state);
}

/// After lights or objects were deleted or renamed, or the scene was replaced, the pointer may refer to a
/// different number.
void forget_number_that_is_gone(UiState& state) {
    AnimateState& animate = state.get<AnimateState>();
    if (animate.animation.pointer.empty()) return;
    const Scene& scene = state.editor.scene();
    const std::optional<SceneNumber> number = number_at(scene, animate.animation.pointer);
    const std::string words = number ? number_words(scene, *number) : "";
    if (animate.number.empty()) animate.number = words;
    if (number && words == animate.number) return;
    forget_number(state);
}

/// Reports that there is no light, or that no number to animate has been chosen.
bool refuses_nothing_chosen(AnimateState& animate, const Scene& scene) {
    if (animate.animation.motion == Motion::Circle && scene.lights.empty()) {
        animate.refused = "The scene has no lights";
        return true;
    }
    if (animate.animation.motion != Motion::PingPong || !animate.animation.pointer.empty()) return false;
    animate.refused = "No number is chosen: click one in the list";
    return true;
}

/// Maps any frame to its index within the period, from 0 to frames - 1.
int within_period(const Animation& animation, int frame) {
    const int period = std::max(animation.frames, 1);
    return ((frame % period) + period) % period;
}

Scene turned(Scene scene, double angle) {
    Camera& camera = scene.camera;
    const glm::dvec3 axis = glm::normalize(glm::dvec3(camera.up)), target(camera.target);
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), angle, axis);
    camera.eye = glm::vec3(target + glm::dvec3(turn * glm::dvec4(glm::dvec3(camera.eye) - target, 0)));
    return scene;
}

/// The vector from the target to the light, or towards a directional light; world coordinates.
glm::dvec3 arm_of(const Light& light, const ScreenMap& map, const Camera& camera) {
    const double w = light.position.w == 0 ? 0 : 1;
    const glm::dvec3 own = glm::dvec3(light.position) / (w == 0 ? 1.0 : double(light.position.w));
    return to_world(light, own, w, map) - w * glm::dvec3(camera.target);
}

Scene circled(Scene scene, const Animation& animation, double angle) {
    if (scene.lights.empty()) return scene;
    const auto last = static_cast<int>(scene.lights.size()) - 1;
    Light& light = scene.lights[static_cast<std::size_t>(std::clamp(animation.light, 0, last))];
    const Camera& camera = scene.camera;
    const ScreenMap map = screen_map(camera, {1, 1});
    const glm::dvec3 axis = axis_of(camera, animation.axis), arm = arm_of(light, map, camera);
    const double present = radius_of(light, camera, axis), w = light.position.w == 0 ? 0 : 1;
    const bool resized = w == 1 && animation.radius > 0 && present > 0;
    const glm::dvec3 along = glm::dot(arm, axis) * axis;
    const glm::dvec3 sized = along + (resized ? animation.radius / present : 1.0) * (arm - along);
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), angle, axis);
    const glm::dvec3 world = glm::dvec3(turn * glm::dvec4(sized, 0)) + w * glm::dvec3(camera.target);
    light.position = glm::vec4(glm::vec3(to_own(light, world, w, map)), float(w));
    turn_shape(light, turn, map);
    return scene;
}

/// The scene with the number set to that value; changed meshes have not been built yet.
Result<Scene> with_number(Scene scene, const std::string& pointer, double value) {
    const std::optional<SceneNumber> number = number_at(scene, pointer);
    const bool is_count = number && number->count;
    if (const auto problem = set_number(scene, pointer, is_count ? number->count->nearest(value) : value))
        return *problem;
    return scene;
}

/// Whether this frame, or the animation's far end, needs a mesh that takes a long time to build.
bool is_held_up(const SceneDocument& document, const Animation& animation, int frame) {
    const auto of_object = item_in(animation.pointer, "/objects/");
    if (animation.motion != Motion::PingPong || !of_object || !is_within(of_object->rest, "/mesh"))
        return false;
    const auto is_slow_at = [&](double value) {
        const Result<Scene> moved = with_number(document.scene, animation.pointer, value);
        const Scene* scene = std::get_if<Scene>(&moved);
        return scene != nullptr &&
               std::any_of(scene->objects.begin(), scene->objects.end(), awaits_slow_mesh);
    };
    return is_slow_at(animation.to) || is_slow_at(value_at(animation, frame));
}

/// Stops playing; the picture shows the edited scene again.
void stop_animation(UiState& state) {
    state.get<AnimateState>().playing = false;
    state.get<AnimateState>().frame.reset();
}

/// Enter starts or stops playing while the panel has focus. Returns true if the key is consumed.
bool animate_by_key(UiState& state, KeyPress press) {
    AnimateState& animate = state.get<AnimateState>();
    if (!animate.open || !animate.has_keyboard) return false;
    if (press == KeyPress{Key::Tab}) return animate.takes_keys = true;
    if (!(press == KeyPress{Key::Enter}) || animate.job || !animate.refused.empty()) return false;
    switch_playing(state);
    return true;
}

/// Once a frame: advances the animation and the writing of frames.
void poll_animation(UiState& state) {
    AnimateState& animate = state.get<AnimateState>();
    poll_job(animate.job, state.notifications);
    forget_number_that_is_gone(state);
    animate.frame.reset();
    if (!animate.playing) return;
    const double frame = (ImGui::GetTime() - animate.began) * animate.frames_a_second;
    if (refuses_nothing_chosen(animate, state.editor.scene())) {
        animate.playing = false;
        return;
    }
    const SceneDocument document = document_as_made(state);
    if (is_held_up(document, animate.animation, static_cast<int>(frame))) {
        animate.playing = false;
        return state.notifications.add(Tone::Warning,
                                       "Animate: these meshes take too long to build while playing; "
                                       "Export animation… builds them in the background");
    }
    Result<Scene> scene = scene_at(document, animate.animation, static_cast<int>(frame));
    if (const Problem* problem = problem_of(scene)) {
        animate.refused = with_expected(problem->what, problem->expected);
        animate.playing = false;
        if (!animate.open) state.notifications.add(*problem);  // a lesson plays animations without the panel
        return;
    }
    animate.frame = std::get<Scene>(std::move(scene));
    redraw_within((std::floor(frame) + 1 - frame) / animate.frames_a_second);
}

}  // namespace

std::string number_words(const Scene& scene, const SceneNumber& number) {
    return fmt::format("{}: {}", owner_of(number.pointer, scene), number.words);
}

void begin_animation(UiState& state, Motion motion) {
    AnimateState& animate = state.get<AnimateState>();
    animate.open = animate.takes_keys = true;
    animate.animation.motion = motion;
    if (const int light = selected_light(state.editor.selection); light >= 0) animate.animation.light = light;
    animate.refused.clear();
}

void switch_playing(UiState& state) {
    AnimateState& animate = state.get<AnimateState>();
    animate.playing = !animate.playing;
    animate.open |= animate.playing;
    animate.began = ImGui::GetTime();
}

void ask_for_frames(UiState& state) {
    if (refuses_nothing_chosen(state.get<AnimateState>(), state.editor.scene())) {
        state.get<AnimateState>().open = true;  // to show the reason
        return;
    }
    const std::string ending(choice_of(state.get<AnimateState>().file).word);
    state.files.ask(frames_purpose, offered_name(state, ending.c_str()));
}

double radius_of(const Light& light, const Camera& camera, const glm::dvec3& axis) {
    const glm::dvec3 arm = arm_of(light, screen_map(camera, {1, 1}), camera);
    return glm::length(arm - glm::dot(arm, axis) * axis);
}

glm::dvec3 axis_of(const Camera& camera, CircleAxis axis) {
    if (axis == CircleAxis::View) return glm::normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
    glm::dvec3 unit(0);
    unit[static_cast<int>(axis)] = 1;
    return unit;
}

double value_at(const Animation& animation, int frame) {
    const double share = double(within_period(animation, frame)) / std::max(animation.frames, 1);
    return animation.from + (animation.to - animation.from) * (1 - std::abs(1 - 2 * share));
}

Result<Scene> scene_at(const SceneDocument& document, const Animation& animation, int frame) {
    const int at = within_period(animation, frame);
    const double angle = 2 * std::numbers::pi * at / std::max(animation.frames, 1);
    if (animation.motion != Motion::PingPong && at == 0 && animation.radius == 0) return document.scene;
    if (animation.motion == Motion::Turntable) return turned(document.scene, angle);
    if (animation.motion == Motion::Circle) return circled(document.scene, animation, angle);
    Result<Scene> moved = with_number(document.scene, animation.pointer, value_at(animation, frame));
    if (auto* scene = std::get_if<Scene>(&moved)) {
        const Result<Warnings> warned = load_meshes(*scene, document.path, document.mesh_dir);
        if (const Problem* problem = problem_of(warned)) return *problem;
    }
    return moved;
}

namespace {

void switch_animate(UiState& state) {
    AnimateState& animate = state.get<AnimateState>();
    animate.open = !animate.open || animate.job;  // to show the progress of writing
    animate.playing &= animate.open;
}

std::optional<OtherScene> show_frame(const UiState& state) {
    const AnimateState& animate = state.get<AnimateState>();
    if (!animate.frame) return {};
    OtherScene shown{.scene = *animate.frame,
                     .name = "the animation's current frame",
                     .label = "Animated",
                     .note = "Animation",
                     .end = stop_animation};
    // A lesson's animation plays until the mouse is pressed, perhaps on an item that the animation moves.
    if (!animate.open) shown.press = [](UiState& s) { s.get<AnimateState>().playing = false; };
    return shown;
}

bool close_panel(UiState& state) {
    AnimateState& animate = state.get<AnimateState>();
    if (!animate.open) return false;
    if (animate.job)  // keep the progress of writing visible
        animate.job->cancel();
    else
        animate.open = animate.playing = false;
    return true;
}

std::vector<WindowCommand> animation_commands() {
    return {
        {.name = "Animate: turntable, light, number…",
         .keys = {{Key::T, ctrl}},
         .section = Section::LectureAnimate,
         .run = switch_animate,
         .is_on = [](const UiState& s) { return s.get<AnimateState>().open; },
         .line_above = true,
         .words = "video movie gif webp mp4 circle orbit export back and forth"},
    };
}

void add_animation(std::vector<PaletteEntry>& entries, UiState& state) {
    const AnimateState& animate = state.get<AnimateState>();
    for (const Motion motion : enumerators<Motion>)
        entries.push_back({fmt::format("Animate: {}", choice_of(motion).label), "Animation", "", "",
                           [motion](UiState& s) { begin_animation(s, motion); }});
    const std::string refused = animate.job ? "Frames are being written" : animate.refused;
    entries.push_back({animate.playing ? "Stop the animation" : "Play the animation", "Animation", "",
                       refused, switch_playing});
    entries.push_back({"Export animation…", "Animation", "", refused, ask_for_frames});
}

}  // namespace

extern const Feature animation_feature;
const Feature animation_feature{.draw = [](UiState& s, const Layout&) { animate_panel(s); },
                                .end = poll_animation,
                                .shows = show_frame,
                                .commands = animation_commands,
                                .palette = add_animation,
                                .key = animate_by_key,
                                .escape = close_panel,
                                .is_presented = [](const UiState& s) { return s.get<AnimateState>().open; },
                                .follow = follow_moved,
                                .leave_document =
                                    [](UiState& s, const SceneDocument& next) {
                                        if (is_another(s, next)) stop_animation(s);
                                    },
                                .put_away =
                                    [](UiState& s) {
                                        stop_animation(s);
                                        AnimateState& animate = s.get<AnimateState>();
                                        animate.open = false;
                                        animate.animation.pointer.clear();
                                        animate.number.clear();
                                    }};

// Writes the frames of an animation to files.

namespace {

namespace fs = std::filesystem;

struct FrameJob {
    SceneDocument document;
    Animation animation;
    std::string path;
    std::optional<AnimationFormat> format;  // nullopt: each frame is written as its own PNG
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
        const PartOfProgress meshes;  // meshes built while a resolution is animated
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
    return fmt::format("Wrote {} frame{}: {} to {}", job.animation.frames,
                       job.animation.frames == 1 ? "" : "s",
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
    return fmt::format("Wrote {} with {} frame{}", fs::path(job.path).filename().string(),
                       job.animation.frames, job.animation.frames == 1 ? "" : "s");
}

/// Makes ffmpeg write a video of all frames. The frames are kept as PNG in an unnamed file, so only the
/// complete video appears in the folder.
Result<std::string> write_video(const FrameJob& job, LoadProgress& progress) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> frames(std::tmpfile(), std::fclose);
    const Problem full{job.path, "", "the frames do not fit in the folder for temporary files", ""};
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
        return fmt::format("Wrote {} with {} frame{}", path.filename().string(), job.animation.frames,
                           job.animation.frames == 1 ? "" : "s");
    fs::remove(part, failed);
    return Problem{job.path, "",
                   progress.cancelled ? "writing was cancelled" : "ffmpeg could not write the video", ""};
}

bool is_video(const std::string& path) { return lower_extension(path) == ".mp4"; }

/// The problem with the first output file that cannot be written; nullopt if all can.
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
    // Drawing takes a long time and replaces existing frames, so problems are reported before it starts.
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
