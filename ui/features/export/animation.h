#pragma once
// A scene that moves: the camera goes round its target, or one number of the scene to and fro. The window
// lets it be chosen, plays it, and writes it as PNG files, as a GIF or as a WebP.

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
    int frames = 48;          // of one period, after which it begins anew; at least 1
    bool operator==(const Animation&) const = default;
};

/// The scene at frame `frame` (of any sign: it repeats). Turntable: eye and up turned about the axis through
/// the target along `up`, counter-clockwise seen from above, 360 degrees over the period; frame 0 is the
/// scene itself. PingPong: the number goes evenly from `from` to `to` and back. Problems are those of --set.
[[nodiscard]] Result<Scene> scene_at(const SceneDocument& document, const Animation& animation, int frame);

/// What is listed for a number that may move: "Bulb: intensity".
[[nodiscard]] std::string number_words(const Scene& scene, const SceneNumber& number);

/// The value at a frame of a PingPong.
[[nodiscard]] double value_at(const Animation& animation, int frame);

/// What the window remembers of an animation between frames.
struct AnimateState {
    bool open = false, playing = false;
    std::optional<Scene> frame;  // while it plays: what the next picture shows
    Animation animation;
    std::string search;         // for the number that shall move
    bool takes_keys = false;    // the first field shall get the keyboard
    bool has_keyboard = false;  // the panel was the focused window when it was drawn last
    std::string searched;       // that search was the last, and these the pointers that it found, best first
    Kept<Scene, std::vector<std::string>> found;
    std::string number;  // Animation::pointer in words when it was chosen: "Bulb: intensity"; empty: not yet
    int frames_a_second = 25;  // 1 to 50: GIF counts hundredths of a second
    double began = 0;          // ImGui's time at frame 0
    std::string refused;       // why it cannot play; empty when it can
    JobPtr<Notification> job;  // its result: what to say when the frames are written
};

/// The panel, while it is open.
void animate_panel(UiState& state);

/// Opens the panel with that motion. The keyboard is in its first field: for a number's motion the search for
/// it, where Enter takes the first.
void begin_animation(UiState& state, Motion motion);
/// Plays, or ends playing.
void switch_playing(UiState& state);
/// Ends playing; the picture shows the scene.
void stop_animation(UiState& state);
/// Enter plays or ends playing while the panel has the keyboard; true: the key is taken.
bool animate_by_key(UiState& state, KeyPress press);
/// The files of all frames.
extern const FilePurpose frames_purpose;
/// Where frame `frame`, from 0, of an animation goes: beside NAME.png as NAME-0001.png, NAME-0002.png, ...
[[nodiscard]] std::string frame_path(const std::string& path, int frame);
/// Asks where the frames shall be written.
void ask_for_frames(UiState& state);

/// Leaves the number that goes to and fro, which the scene does not have any more, and says so where it
/// played.
void forget_number(UiState& state);

/// Once a frame: what plays is shown in the next one; what is being written goes on.
void poll_animation(UiState& state);

/// Writes all frames in the background: NAME.png as NAME-0001.png, NAME-0002.png, …, each carrying its scene;
/// NAME.gif and NAME.webp as one file. The picture's size is `size`, with `samples` a pixel.
void begin_frames(UiState& state, const std::string& path, PictureSize size, int samples);

}  // namespace glint
