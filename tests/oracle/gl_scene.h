#pragma once
// Draws a scene with OpenGL: its own matrices, clipping, rasterization, interpolation, culling and depth
// test, and either its own lighting (fixed function) or a shader written from the formulas. From Glint it
// uses only the scene value and its meshes: corners, triangles and the normals of corner_normals().

#include <array>
#include <utility>
#include <vector>

#include "models/scene/scene.h"
#include "tests/oracle/wrong_programs.h"

namespace glint::oracle {

enum class Route { FixedFunction, Shader };

/// Whether OpenGL can draw the scene: no mistakes, no strokes, no scanline interpolation, at most 8 lights.
[[nodiscard]] bool can_draw(const Scene& scene);

/// Whether OpenGL's fixed function can draw the scene: lambert or blinn-phong under gouraud or provoking
/// flat, colours interpolated in perspective, no area light, exponents up to 128 and no shininess of 0.
[[nodiscard]] bool fixed_function_can_draw(const Scene& scene);

/// Draws the scene into the current context. Preconditions: OpenGL can draw it by this route, and meshes are
/// loaded. Reuses compiled shaders between calls: use it with only one GlCanvas.
class GlPainter {
  public:
    GlPainter() = default;
    /// Draws with an incorrect program: changes its shaders' text.
    explicit GlPainter(std::vector<TextChange> wrong) : wrong_(std::move(wrong)) {}
    void draw(const Scene& scene, PictureSize size, Route route);

  private:
    [[nodiscard]] unsigned program(const Shading& shading);
    std::vector<TextChange> wrong_;
    std::array<unsigned, 5> programs_{};  // 0: not compiled yet
};

}  // namespace glint::oracle
