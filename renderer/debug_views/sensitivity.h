#pragma once
// Measures how much a pixel changes with each number of its scene: the equation's derivatives, by differences
// of the picture itself, so that they include everything that the engine does.

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
    double value = 0;        // current
    glm::dvec3 change{0};    // of the pixel (linear RGB times exposure) per unit of the number
    bool one_sided = false;  // the number can move in one direction only (it is at an end of its range)
    bool is_w = false;       // the w of a position, which is not for moving a light
    double move = 0;         // usual_move(); negative if the number can only decrease
    glm::dvec3 effect{0};    // change of the pixel when the number moves by `move`, in the entire scene
};

/// The usual change of a number, in its unit: a tenth of its usual range, or without one, the change of a
/// drag over 100 pixels.
[[nodiscard]] double usual_move(const SceneNumber& number);

struct Sensitivities {
    std::vector<Sensitivity> numbers;    // those with an effect, the largest change of a channel first
    std::vector<std::string> no_effect;  // changing them leaves every bit of the pixel unchanged
    std::vector<std::string> fixed;      // without small changes (integers, a direction's w)
};

/// More lights than these are a problem: each of their numbers would take two pictures.
inline constexpr std::size_t max_sensitivity_lights = 64;
inline constexpr std::size_t max_stroking_objects = 32;

/// Measures the sensitivities step by step, so that a window need not wait for all of them.
class SensitivityRun {
  public:
    /// `document.scene` must be drawable, the pixel inside the picture. Threads as for Renderer.
    SensitivityRun(const SceneDocument& document, PictureSize size, int x, int y, int threads);
    ~SensitivityRun();
    SensitivityRun(const SensitivityRun&) = delete;
    SensitivityRun& operator=(const SensitivityRun&) = delete;

    /// Measures the next number; returns false when all are measured.
    bool step();
    [[nodiscard]] std::size_t measured() const;
    [[nodiscard]] std::size_t count() const;
    /// The measurements so far, sorted.
    [[nodiscard]] Sensitivities result() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Central differences over a thousandth of each number. The face at the pixel is pinned: the other objects,
/// which with local illumination could change the pixel only by hiding it, are left out and have no effect;
/// only a number's long move includes them.
/// If a stroke covers part of the pixel, they are kept and their numbers are measured too; with more than
/// max_stroking_objects, only those of the visible object.
/// `document.scene` must be drawable, the pixel inside the picture. `measured` is called after each number
/// with the finished and the total count. Problem: more than max_sensitivity_lights.
using SensitivityProgress = std::function<void(std::size_t done, std::size_t all)>;
[[nodiscard]] Result<Sensitivities> sensitivities(const SceneDocument& document, PictureSize size, int x,
                                                  int y, int threads,
                                                  const SensitivityProgress& measured = {});

/// A table for people; ends with a newline.
[[nodiscard]] std::string sensitivity_text(const Sensitivities& s);

}  // namespace glint
