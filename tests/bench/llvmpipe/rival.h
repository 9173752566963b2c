#pragma once
// The rival is what a course would probably use instead of Glint: OpenGL 3.3 on Mesa's llvmpipe (software,
// vectorised, compiled for the current CPU), drawing into memory. It is fully optimized: buffers are filled
// once, one indexed draw per object with vertices numbered by first use, back faces culled, lights sorted by
// kind so that no fragment branches on it, colours premultiplied, uniforms set once per frame. It shares only
// the scene, its meshes and its matrices with Glint.

#include <cstdint>
#include <memory>
#include <vector>

#include "models/scene/scene.h"

namespace glint::bench {

enum class Way {
    Forward,  // geometry and lighting in one pass
    Deferred  // a G-buffer first, reused while only lights and materials change; Phong only
};

class Rival {
  public:
    /// Preconditions: meshes are loaded; one object; every light is a point, directional or spot light
    /// without an ambient term. Throws std::runtime_error on an OpenGL error or a scene that it cannot draw.
    Rival(const Scene& scene, PictureSize size, int threads);
    ~Rival();
    Rival(const Rival&) = delete;
    Rival& operator=(const Rival&) = delete;

    /// Draws and waits for completion. `same_view`: camera and objects equal those of the last frame.
    void draw(const Scene& scene, Way way, bool same_view);

    /// The last picture, RGBA, top row first.
    [[nodiscard]] std::vector<std::uint8_t> picture() const;

  private:
    struct Gl;
    std::unique_ptr<Gl> gl_;
};

}  // namespace glint::bench
