#pragma once
// Compares Glint's picture with OpenGL's, pixel by pixel.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "tests/oracle/gl_canvas.h"
#include "tests/oracle/gl_scene.h"
#include "tests/oracle/left_out.h"

namespace glint::oracle {

struct Figure {
    int scenes = 0, by_fixed_function = 0;
    std::size_t pixels = 0;                              // surface pixels that were compared
    std::size_t background = 0;                          // pixels that are background in both pictures
    std::size_t edges = 0;                               // skipped: another triangle within one pixel
    std::array<std::size_t, left_out_count> left_out{};  // skipped by that rule
    double largest = 0, sum = 0;                         // differences of channels, as floats
    double largest_share = 0;                            // as a fraction of the bound
    int largest_bytes = 0;                               // difference of a channel in 8 bits
    std::vector<std::string> disagreements;              // the worst pixel of each scene that has one
    [[nodiscard]] std::string text() const;
};

/// Draws scenes with OpenGL and with Glint, and accumulates the results.
class Comparison {
  public:
    /// `name` is for messages. Precondition: OpenGL can draw the scene by this route.
    void add(const std::string& name, const Scene& scene, PictureSize size, Route route);
    [[nodiscard]] const Figure& figure() const { return figure_; }
    [[nodiscard]] GlCanvas& canvas() { return canvas_; }

  private:
    GlCanvas canvas_;
    GlPainter painter_;
    Renderer renderer_, faces_;
    Figure figure_;
};

}  // namespace glint::oracle
