#pragma once
// Functions for drawing a scene with OpenGL.

#include <glm/mat4x4.hpp>

#include "models/scene/scene.h"
#include "tests/oracle/wrong_programs.h"

namespace glint::oracle {

/// The matrix from world to camera coordinates, and the projection, as the OpenGL utility library computes
/// them.
[[nodiscard]] glm::dmat4 look_at(const Camera& camera);
void load_projection(const Projection& projection, PictureSize size);

/// Whether flat shading uses the triangle's last corner.
[[nodiscard]] bool lit_at_corner(const Shading& shading);

/// Multiplies the current matrix by T Rz Ry Rx S.
void multiply_transform(const Transform& t);

/// The material, with disabled terms set to zero.
[[nodiscard]] Material seen_material(const Material& material, const Shading& shading);

/// All triangles of an object, in Glint's order, with each corner's normal and position for lighting.
void emit_triangles(const Object& object, const Shading& shading);

/// OpenGL's own lighting. Precondition: the model-view matrix is `view`.
void set_fixed_lights(const Scene& scene, const glm::dmat4& view);
void set_fixed_material(const Material& material, const Shading& shading);

/// The uniforms of equation.glsl in the current program.
void set_shader_lights(unsigned program, const Scene& scene, const glm::dmat4& view);
void set_shader_material(unsigned program, const Scene& scene, const Material& given);
[[nodiscard]] unsigned make_program(const char* stage, const char* interpolated,
                                    const std::vector<TextChange>& changes);

}  // namespace glint::oracle
