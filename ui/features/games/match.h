#pragma once
// *Match the target*: the player changes a few numbers of a scene until its picture matches a target, and
// sees the difference fall. Scene and target follow from a seed, so that a class can play the same one.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/compare.h"
#include "renderer/renderer.h"
#include "ui/features/views/compare_view.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

struct UiState;

/// A scene to begin with and the one to reach: they differ in these numbers alone, so that it can be reached.
struct MatchTask {
    Scene start, target;
    std::vector<std::string> numbers;  // pointers into the scene
};
/// Makes the task of a seed, which is the same on every machine.
[[nodiscard]] MatchTask match_task(std::uint64_t seed);

/// How far two pictures of one size are apart: the root of the mean square over pixels and channels, in
/// levels of 255.
[[nodiscard]] double apart_of(const Picture& a, const Picture& b);
/// A distance of at most this counts as matched.
inline constexpr double match_tolerance = 2;
inline constexpr PictureSize match_size{320, 180};

/// Which term is off most, and how: "The specular term is off: its highlight is too small."
[[nodiscard]] std::string match_hint(Renderer& renderer, const Scene& scene, const Scene& target);

struct MatchState {
    bool on = false, shows_hint = false;
    std::uint64_t seed = 1;
    MatchTask task;
    std::unique_ptr<Renderer> renderer;  // at match_size, beside the window's
    Picture target;
    Scene asked_of;                              // of the numbers below
    double first = 0, now = 0;                   // how far off at the beginning and now
    bool solved = false;                         // it was near enough once
    std::string hint;                            // of `asked_of`; made when it is asked for
    PictureSheet sheet;                          // the target
    std::shared_ptr<const Scene> stored_before;  // B of the comparison before the game
};

/// Begins with that seed; the scene in hand is given up, which was asked before.
void begin_match(UiState& state, std::uint64_t seed);
/// Ends the game; the scene stays, with the comparison from before the game or the user's own picture.
void end_match(UiState& state);
/// Once a frame: how far off the scene in hand is.
void poll_match(UiState& state);
/// Once a frame, after its step was recorded: what was moved in the game is play and nobody's work, until it
/// was saved under a name.
void forget_play(UiState& state);
/// The game's column.
void match_column(UiState& state);

}  // namespace glint
