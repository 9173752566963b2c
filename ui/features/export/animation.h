#pragma once
// A moving scene: the camera goes round its target, or one number of the scene goes back and forth. The
// window edits and plays it, and writes it as PNG files, as a GIF or as a WebP.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/fields/scene_numbers.h"
#include "models/range.h"
#include "models/scene_file/scene_file.h"
#include "ui/commands/keys.h"
#include "ui/document/file_dialog.h"
#include "ui/document/job.h"
#include "ui/shell/notifications.h"
#include "ui/widgets/kept.h"

namespace glint {

struct UiState;

enum class Motion { Turntable, PingPong };
constexpr Choice choice_of(Motion motion) {
    switch (motion) {
    case Motion::Turntable:
        return {"turntable", "Turntable", "The camera once round its target"};
    case Motion::PingPong:
        return {"to-and-fro", "Back and forth", "One number of the scene between two values"};
    }
    return {};
}

struct Animation {
    Motion motion = Motion::Turntable;
    std::string pointer;      // PingPong: of a number in the scene file
    double from = 0, to = 1;  // PingPong: its values at both ends
    int frames = 48;          // of one period, after which it repeats; at least 1
    bool operator==(const Animation&) const = default;
};

/// The scene at frame `frame` (any integer: it repeats). Turntable: eye and up turned about the axis through
/// the target along `up`, counter-clockwise seen from above, 360 degrees over the period; frame 0 is the
/// scene itself. PingPong: the number goes linearly from `from` to `to` and back. Problems are those of
/// --set.
[[nodiscard]] Result<Scene> scene_at(const SceneDocument& document, const Animation& animation, int frame);

/// The list's text for a number that can be animated: "Bulb: intensity".
[[nodiscard]] std::string number_words(const Scene& scene, const SceneNumber& number);

/// The value at a frame of a PingPong.
[[nodiscard]] double value_at(const Animation& animation, int frame);

/// The animation's state between frames.
struct AnimateState {
    bool open = false, playing = false;
    std::optional<Scene> frame;  // while it plays: the scene of the next picture
    Animation animation;
    std::string search;         // for the number to animate
    bool takes_keys = false;    // the first field gets focus
    bool has_keyboard = false;  // the panel was focused when last drawn
    std::string searched;       // the last search, and the pointers that it found, best first
    Kept<Scene, std::vector<std::string>> found;
    std::string number;  // text of Animation::pointer when it was chosen: "Bulb: intensity"; empty: none yet
    int frames_a_second = 25;  // 1 to 50: GIF counts hundredths of a second
    double began = 0;          // ImGui time at frame 0
    std::string refused;       // why it cannot play; empty when it can
    JobPtr<Notification> job;  // its result: the notification after writing
};

/// The panel, while it is open.
void animate_panel(UiState& state);

/// Opens the panel with that motion and focuses its first field: for a number's motion the search, where
/// Enter takes the first match.
void begin_animation(UiState& state, Motion motion);
/// Starts or stops playing.
void switch_playing(UiState& state);
/// Stops playing; the picture shows the scene.
void stop_animation(UiState& state);
/// Enter starts or stops playing while the panel has focus; true: the key is consumed.
bool animate_by_key(UiState& state, KeyPress press);
/// The files of all frames.
extern const FilePurpose frames_purpose;
/// The file of frame `frame`, from 0, of an animation: next to NAME.png as NAME-0001.png, NAME-0002.png, ...
[[nodiscard]] std::string frame_path(const std::string& path, int frame);
/// Opens the dialog for the path of the frames.
void ask_for_frames(UiState& state);

/// Drops the animated number, which the scene no longer has, and reports it if it was playing.
void forget_number(UiState& state);

/// Once a frame: advances the animation and the writing of frames.
void poll_animation(UiState& state);

/// Writes all frames in the background: NAME.png as NAME-0001.png, NAME-0002.png, …, each with its scene
/// embedded; NAME.gif and NAME.webp as one file. The picture's size is `size`, with `samples` per pixel.
void begin_frames(UiState& state, const std::string& path, PictureSize size, int samples);

}  // namespace glint
