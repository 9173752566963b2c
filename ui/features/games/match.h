#pragma once
// *Match the target*: the player changes a few numbers of a scene until its picture matches a target, and
// sees the difference decrease. A seed determines the game, so a whole class can play the same one.

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

/// An initial scene and a target: they differ only in `numbers`, so the target can be reached.
struct MatchTask {
    Scene start, target;
    std::vector<std::string> numbers;  // JSON pointers to numbers in the scene
};
/// Makes the task for a seed. The same seed gives the same task on every machine.
[[nodiscard]] MatchTask match_task(std::uint64_t seed);

/// The difference between two pictures of equal size: root mean square over pixels and channels, in levels
/// from 0 to 255.
[[nodiscard]] double apart_of(const Picture& a, const Picture& b);
/// A difference of at most this many levels counts as a match.
inline constexpr double match_tolerance = 2;
inline constexpr PictureSize match_size{320, 180};

/// The term that differs most, and how it differs: "The specular term is furthest off: its highlight is too
/// small."
[[nodiscard]] std::string match_hint(Renderer& renderer, const Scene& scene, const Scene& target);

struct MatchState {
    bool on = false, shows_hint = false;
    std::uint64_t seed = 1;
    MatchTask task;
    std::unique_ptr<Renderer> renderer;  // draws at match_size; separate from the window's renderer
    Picture target;
    Scene asked_of;                              // the scene that the following values refer to
    double first = 0, now = 0;                   // difference at the beginning and now
    bool solved = false;                         // whether the difference was ever within the tolerance
    std::string hint;                            // for `asked_of`; computed on request
    PictureSheet sheet;                          // a picture of the target
    std::shared_ptr<const Scene> stored_before;  // scene B of the comparison before the game
};

/// Starts the game with that seed and discards the current scene. Precondition: the user has confirmed this.
void begin_match(UiState& state, std::uint64_t seed);
/// Ends the game and restores the previous comparison or the user's own picture; the scene stays open.
void end_match(UiState& state);

}  // namespace glint
