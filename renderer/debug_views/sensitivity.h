#pragma once
// Measures how much a pixel changes with each number of its scene: the equation's derivatives, by differences
// of the picture itself, so that whatever the engine does is in them.

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "models/fields/scene_numbers.h"
#include "models/scene_file/scene_file.h"
#include "renderer/picture.h"

namespace glint {

/// One number of the scene file.
struct Sensitivity {
    std::string pointer;     // RFC 6901
    double value = 0;        // what it is now
    glm::dvec3 change{0};    // of the pixel (linear RGB times exposure) for each unit of the number
    bool one_sided = false;  // the number can move in one direction only (it is at the end of its range)
    bool is_w = false;       // of a position: nobody moves a light by it
    double move = 0;         // usual_move(), below 0 where the number can only become less
    glm::dvec3 effect{0};    // what the pixel gains when the number moves so far, in the whole scene
};

/// How far a number is usually moved, in its unit: a tenth of its usual range; where it has none, what a drag
/// over 100 pixels adds.
[[nodiscard]] double usual_move(const SceneNumber& number);

struct Sensitivities {
    std::vector<Sensitivity> numbers;    // those that count, the largest change of a channel first
    std::vector<std::string> no_effect;  // moving them leaves the pixel as it is, to the last bit
    std::vector<std::string> fixed;      // that cannot move a little (whole numbers, a direction's w)
};

/// More lights than these are a problem: every number of each would take two pictures.
inline constexpr std::size_t max_sensitivity_lights = 64;
inline constexpr std::size_t max_stroking_objects = 32;

/// Measures the sensitivities step by step, for a window that must not wait for all of them.
class SensitivityRun {
  public:
    /// `document.scene` must be drawable, the pixel inside the picture. Threads as for Renderer.
    SensitivityRun(const SceneDocument& document, PictureSize size, int x, int y, int threads);
    ~SensitivityRun();
    SensitivityRun(const SensitivityRun&) = delete;
    SensitivityRun& operator=(const SensitivityRun&) = delete;

    /// Measures the next number; false when all are measured.
    bool step();
    [[nodiscard]] std::size_t measured() const;
    [[nodiscard]] std::size_t count() const;
    /// What is measured so far, sorted.
    [[nodiscard]] Sensitivities result() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Central differences over a thousandth of each number. The face at the pixel is pinned: the other objects,
/// which under local illumination could change the pixel only by hiding it, are left out and have no effect;
/// but behind a number's long move they are there.
/// Where a stroke covers some of the pixel, they stay, and their numbers are measured too: of more than
/// max_stroking_objects only those of the object that shows.
/// `document.scene` must be drawable, the pixel inside the picture. `measured` is told how many numbers of
/// how many are done, after each. Problem: more than max_sensitivity_lights.
using SensitivityProgress = std::function<void(std::size_t done, std::size_t all)>;
[[nodiscard]] Result<Sensitivities> sensitivities(const SceneDocument& document, PictureSize size, int x,
                                                  int y, int threads,
                                                  const SensitivityProgress& measured = {});

/// A table for people; ends with a newline.
[[nodiscard]] std::string sensitivity_text(const Sensitivities& s);

}  // namespace glint
