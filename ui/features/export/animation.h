#pragma once
// An animated scene: the camera or a light circles the target, or one number in the scene goes back and
// forth. The window edits and plays the animation, and writes it as PNG files, a GIF, a WebP or an MP4.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/fields/scene_fields.h"
#include "models/numbers.h"
#include "models/scene_file/scene_file.h"
#include "ui/commands/keys.h"
#include "ui/document/file_dialog.h"
#include "ui/document/job.h"
#include "ui/shell/notifications.h"
#include "ui/widgets/kept.h"

namespace glint {

struct UiState;

enum class Motion { Turntable, Circle, PingPong };
constexpr Choice choice_of(Motion motion) {
    switch (motion) {
    case Motion::Turntable:
        return {"turntable", "Turntable", "Moves the camera once round its target"};
    case Motion::Circle:
        return {"circle", "Light circles", "Moves a light once round the camera's target"};
    case Motion::PingPong:
        return {"to-and-fro", "Back and forth", "Varies one number in the scene between two values"};
    }
    return {};
}

/// The axis of a circle; it passes through the camera's target.
enum class CircleAxis { X, Y, Z, View };
constexpr Choice choice_of(CircleAxis axis) {
    switch (axis) {
    case CircleAxis::X:
        return {"x", "x", "Over the scene from front to back"};
    case CircleAxis::Y:
        return {"y", "y", "Round the scene, at the light's own height"};
    case CircleAxis::Z:
        return {"z", "z", "Over the scene from left to right"};
    case CircleAxis::View:
        return {"view", "View", "Round the line of sight"};
    }
    return {};
}

/// The file type of an animation. Mp4 needs the program ffmpeg.
enum class AnimationFile { Gif, WebP, Mp4, Png };
constexpr Choice choice_of(AnimationFile file) {
    switch (file) {
    case AnimationFile::Gif:
        return {".gif", "GIF", "Opens everywhere; 256 colours per frame, dithered"};
    case AnimationFile::WebP:
        return {".webp", "WebP", "One file in full colour; browsers show it"};
    case AnimationFile::Mp4:
        return {".mp4", "MP4", "A video for slides, made by the program ffmpeg"};
    case AnimationFile::Png:
        return {".png", "PNG", "One file per frame: NAME-0001.png and so on, each with its scene"};
    }
    return {};
}

struct Animation {
    Motion motion = Motion::Turntable;
    std::string pointer{};    // PingPong: the JSON pointer to a number in the scene file
    double from = 0, to = 1;  // PingPong: the number's values at the two ends
    int frames = 48;          // frames in one period, after which it repeats; at least 1
    int light = 0;            // Circle: index in Scene::lights
    CircleAxis axis = CircleAxis::Y;
    double radius = 0;  // Circle, for a light with a position; 0: the light's current distance from the axis
    bool operator==(const Animation&) const = default;
};

/// The scene at frame `frame`, any integer because the animation repeats. Turntable: the eye turns about the
/// axis through the target along `up`, counter-clockwise seen from above, by 360 degrees over the period;
/// frame 0 is the scene itself. Circle: the light, with its aim and edges, turns about `axis` likewise.
/// PingPong: the number goes linearly from `from` to `to` and back. Fails as --set does.
[[nodiscard]] Result<Scene> scene_at(const SceneDocument& document, const Animation& animation, int frame);

/// The text of a list entry for a number that can be animated: "Bulb: intensity".
[[nodiscard]] std::string number_words(const Scene& scene, const SceneNumber& number);

/// The light's distance from the axis of its circle, and that axis as a unit vector in world coordinates.
[[nodiscard]] double radius_of(const Light& light, const Camera& camera, const glm::dvec3& axis);
[[nodiscard]] glm::dvec3 axis_of(const Camera& camera, CircleAxis axis);

/// The animated number's value at a frame (PingPong).
[[nodiscard]] double value_at(const Animation& animation, int frame);

/// The state of the Animate panel and its animation between frames.
struct AnimateState {
    bool open = false, playing = false;
    std::optional<Scene> frame;  // the scene of the next picture, while playing
    Animation animation;
    std::string search;         // text of the search for the number to animate
    bool takes_keys = false;    // requested: focus the first field
    bool has_keyboard = false;  // the panel was focused when last drawn
    std::string searched;       // the last search, and the pointers it found, best match first
    Kept<Scene, std::vector<std::string>> found;
    std::string number;  // number_words() of the number when it was chosen: "Bulb: intensity"; empty: none
    int frames_a_second = 25;  // 1 to 50, because GIF delays are in hundredths of a second
    AnimationFile file = AnimationFile::Gif;
    double began = 0;          // ImGui time at frame 0
    std::string refused;       // why the animation cannot play; empty if it can
    JobPtr<Notification> job;  // writes the frames; its result is the notification to show
};

/// Draws the panel while it is open.
void animate_panel(UiState& state);

/// Opens the panel with that motion and focuses its first field. For PingPong this is the search field, where
/// Enter chooses the first match.
void begin_animation(UiState& state, Motion motion);
/// Starts or stops playing the animation.
void switch_playing(UiState& state);
/// The file dialog's purpose when all frames are exported.
extern const FilePurpose frames_purpose;
/// The path of the file for frame `frame`, counted from 0: NAME.png becomes NAME-0001.png, NAME-0002.png, ...
[[nodiscard]] std::string frame_path(const std::string& path, int frame);
/// Opens the file dialog for exporting all frames.
void ask_for_frames(UiState& state);

/// Writes all frames in the background: NAME.png as NAME-0001.png, NAME-0002.png, …, each with its scene
/// embedded; NAME.gif, NAME.webp and NAME.mp4 as one file. Pictures have the size `size` and `samples`
/// samples per pixel.
void begin_frames(UiState& state, const std::string& path, PictureSize size, int samples);

}  // namespace glint
