#pragma once
// All data that OpenGL needs to draw a scene with shader_stages(): plain data, so that another process can
// draw it. Omits the scene's mistakes, because the lighting is the user's own.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "models/problem.h"
#include "models/scene/scene.h"
#include "programs/program.h"

namespace glint {

/// A uniform variable by its name in GLSL: "lights[0].position". docs/shader.md lists them.
struct Uniform {
    std::string name;
    std::variant<int, float, glm::vec3, glm::mat4> value;
};

/// The vertex data of a mesh's triangles, 12 numbers per corner, for the attributes 0 to 3 of scene.vert:
/// position and normal, the point to be lit, the mesh's colour; object coordinates.
using CornerNumbers = std::shared_ptr<const std::vector<float>>;
inline constexpr std::size_t numbers_per_corner = 12;

struct ShaderObject {
    CornerNumbers corners;
    bool is_mirrored = false;  // its front faces are clockwise
    std::vector<Uniform> uniforms;
};

struct ShaderScene {
    PictureSize size;
    ShaderStages stages;
    Cull cull = Cull::None;
    glm::vec3 background{0}, shown_background{0};  // linear before exposure; as displayed, 0 to 1
    std::vector<Uniform> uniforms;                 // shared by all objects
    std::vector<ShaderObject> objects;
};

/// Keeps the vertex data of meshes between scenes. Not thread-safe.
class CornerCache {
  public:
    /// Returns the vertex data of an object with that shading.
    [[nodiscard]] CornerNumbers of(const Object& object, const Shading& shading);

  private:
    struct Kept {
        MeshPtr mesh;  // keeps the key's pointer valid
        CornerNumbers numbers;
    };
    std::map<std::tuple<NormalsKey, bool, bool, bool>, Kept> kept_;
};

/// Returns the scene for a picture of that size. Fails like shader_stages().
[[nodiscard]] Result<ShaderScene> shader_scene(const Scene& scene, PictureSize size, CornerCache& cache);

}  // namespace glint
