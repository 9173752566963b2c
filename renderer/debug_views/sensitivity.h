#pragma once
// Measures how much a pixel changes with each number of its scene: the derivatives of the lighting equation,
// as finite differences of the picture, so they include every effect that the engine computes.

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "models/fields/scene_fields.h"
#include "models/scene_file/scene_file.h"
#include "renderer/picture.h"

namespace glint {

/// One number of the scene file.
struct Sensitivity {
    std::string pointer;     // RFC 6901
    double value = 0;        // current value
    glm::dvec3 change{0};    // change in the pixel (linear RGB times exposure) per unit of the number
    bool one_sided = false;  // the number is at an end of its range and can change in one direction only
    bool is_w = false;       // the w of a position; must not be used to move a light
    double move = 0;         // usual_move(); negative if the number can only decrease
    glm::dvec3 effect{0};    // change in the pixel in the entire scene when the number changes by `move`
};

/// The usual change of a number, in its unit: a tenth of its usual range, or if there is none, the change
/// from dragging over 100 pixels.
[[nodiscard]] double usual_move(const SceneNumber& number);

struct Sensitivities {
    std::vector<Sensitivity> numbers;    // numbers with an effect, in descending order of the largest channel
    std::vector<std::string> no_effect;  // numbers that do not change any bit of the pixel
    std::vector<std::string> fixed;      // numbers that cannot change slightly (integers, a direction's w)
};

/// The maximum number of lights: each of a light's numbers requires drawing two pictures.
inline constexpr std::size_t max_sensitivity_lights = 64;
inline constexpr std::size_t max_stroking_objects = 32;

/// Measures the sensitivities step by step, so that a window need not wait for all of them.
class SensitivityRun {
  public:
    /// `document.scene` must be drawable, and (x, y) must lie within `size`. `threads`: as for Renderer.
    SensitivityRun(const SceneDocument& document, PictureSize size, int x, int y, int threads);
    ~SensitivityRun();
    SensitivityRun(const SensitivityRun&) = delete;
    SensitivityRun& operator=(const SensitivityRun&) = delete;

    /// Measures the next number. Returns false if all have been measured.
    bool step();
    [[nodiscard]] std::size_t measured() const;
    [[nodiscard]] std::size_t count() const;
    /// The measurements so far, sorted.
    [[nodiscard]] Sensitivities result() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Central differences over a thousandth of each number. The face at the pixel is pinned: all other objects
/// are omitted and have no effect, because with local illumination they could change the pixel only by hiding
/// that face. Only the effect of `Sensitivity::move` includes them. If a stroke covers part of the pixel, all
/// objects are kept and their numbers are measured too; if there are more than max_stroking_objects objects,
/// only the numbers of the visible object are measured. `document.scene` must be drawable, and (x, y) must
/// lie within `size`. `measured` is called after each number with the number of finished measurements and the
/// total. Returns a problem if there are more than max_sensitivity_lights lights.
using SensitivityProgress = std::function<void(std::size_t done, std::size_t all)>;
[[nodiscard]] Result<Sensitivities> sensitivities(const SceneDocument& document, PictureSize size, int x,
                                                  int y, int threads,
                                                  const SensitivityProgress& measured = {});

/// A table as text; ends with a newline.
[[nodiscard]] std::string sensitivity_text(const Sensitivities& s);

}  // namespace glint
