#pragma once
// Everything that OpenGL gets to draw a scene by shader_stages(): plain data, which another process can
// draw. Mistakes of the scene are left out, because the lighting is someone else's.

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

/// The numbers of a mesh's triangles, 12 per corner, for the attributes 0 to 3 of scene.vert: position and
/// normal, the point to be lit, the mesh's colour; object coordinates.
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
    std::vector<Uniform> uniforms;                 // that all objects share
    std::vector<ShaderObject> objects;
};

/// Keeps the numbers of meshes between scenes. Not for several threads.
class CornerCache {
  public:
    /// The numbers of an object under that shading.
    [[nodiscard]] CornerNumbers of(const Object& object, const Shading& shading);

  private:
    struct Kept {
        MeshPtr mesh;  // keeps the key's pointer valid
        CornerNumbers numbers;
    };
    std::map<std::tuple<NormalsKey, bool, bool, bool>, Kept> kept_;
};

/// The scene at that size. Problem (without a file): as of shader_stages().
[[nodiscard]] Result<ShaderScene> shader_scene(const Scene& scene, PictureSize size, CornerCache& cache);

}  // namespace glint
