#pragma once
// A scene drawn by OpenGL: its own matrices, clipping, rasterisation, interpolation, culling and depth test,
// and either its own lighting (fixed function) or a shader that was written from the formulas. Of our program
// only the scene value and its meshes are used: corners, triangles and the normals of corner_normals().

#include <array>
#include <utility>
#include <vector>

#include "models/scene/scene.h"
#include "tests/oracle/wrong_programs.h"

namespace glint::oracle {

enum class Route { FixedFunction, Shader };

/// Whether OpenGL can draw the scene at all: no mistakes, no strokes, no scanline interpolation, no more than
/// 8 lights.
[[nodiscard]] bool can_draw(const Scene& scene);

/// Whether fixed function can: lambert or blinn-phong under gouraud or provoking flat, colours interpolated
/// in perspective, no area light, exponents up to 128 and none of them a shininess of 0.
[[nodiscard]] bool fixed_function_can_draw(const Scene& scene);

/// OpenGL calls that draw the scene into the current context. Precondition: the route can, meshes are loaded.
/// Keeps compiled shaders from one call to the next: give it one GlCanvas.
class GlPainter {
  public:
    GlPainter() = default;
    /// Draws by a wrong program: its shaders' text is changed so.
    explicit GlPainter(std::vector<TextChange> wrong) : wrong_(std::move(wrong)) {}
    void draw(const Scene& scene, PictureSize size, Route route);

  private:
    [[nodiscard]] unsigned program(const Shading& shading);
    std::vector<TextChange> wrong_;
    std::array<unsigned, 5> programs_{};  // 0: not compiled yet
};

}  // namespace glint::oracle
