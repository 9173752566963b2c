#pragma once
// Compares a written program's picture with Glint's.

#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/renderer.h"
#include "tests/programs/written_program.h"

namespace glint::programs {

/// The result of comparing pictures.
struct Figure {
    int scenes = 0;
    std::size_t pixels = 0, surfaces = 0;  // all compared pixels, and those on surfaces
    double largest = 0;                    // difference of floats, as a fraction of the tolerance
    int largest_bytes = 0;
    std::vector<std::string> disagreements;  // the worst pixel of each scene that has one, or what failed
};

/// Draws scenes with a program and with Glint. Compares pixels whose centre is well within one triangle, with
/// no other surface nearby and no applicable rule of left_out.h.
class Comparison {
  public:
    void add(const std::string& name, const Scene& scene, PictureSize size, Language language);
    [[nodiscard]] const Figure& figure() const { return figure_; }
    /// The text of the last compared program.
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    Renderer renderer_;
    Figure figure_;
    std::string text_;
};

}  // namespace glint::programs
