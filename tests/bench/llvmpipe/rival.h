#pragma once
// The rival: what a course would use in our place, OpenGL 3.3 on Mesa's llvmpipe (software, vectorised,
// compiled for the CPU at hand), drawing into memory. Written as well as it can be: buffers are filled once,
// one indexed draw an object with vertices numbered by first use, back faces culled, lights sorted by kind so
// that no fragment branches on it, colours multiplied beforehand, uniforms set once a frame. Of ours only the
// scene, its meshes and its matrices are used.

#include <cstdint>
#include <memory>
#include <vector>

#include "models/scene/scene.h"

namespace glint::bench {

enum class Way {
    Forward,  // geometry and lighting in one pass
    Deferred  // a G-buffer first, kept while only lights and materials change; Phong only
};

class Rival {
  public:
    /// Meshes must be loaded; one object. Lights point, directional or spot, no ambient share of their own.
    /// Throws std::runtime_error, also for a scene that it does not draw.
    Rival(const Scene& scene, PictureSize size, int threads);
    ~Rival();
    Rival(const Rival&) = delete;
    Rival& operator=(const Rival&) = delete;

    /// Draws and waits for the end. `same_view`: camera and objects are those of the frame before.
    void draw(const Scene& scene, Way way, bool same_view);

    /// The picture drawn last, RGBA, first row at the top.
    [[nodiscard]] std::vector<std::uint8_t> picture() const;

  private:
    struct Gl;
    std::unique_ptr<Gl> gl_;
};

}  // namespace glint::bench
