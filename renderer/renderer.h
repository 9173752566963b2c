#pragma once
// Scene -> pixels, and why. Four stages, each a function of its inputs alone and kept until they differ:
// geometry -> visibility -> surface -> lighting, with strokes as a small one before the last
// (docs/architecture.md). Nobody ever says "dirty": the renderer compares the scene with the last one.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "models/problem.h"
#include "models/scene/scene.h"
#include "renderer/explain/explanation.h"
#include "renderer/picture.h"

namespace glint {

enum class Stage { Geometry, Visibility, Surface, Lighting };
inline constexpr int stage_count = 4;

/// What one frame took and did.
struct FrameStats {
    std::array<double, stage_count> ms{};  // wall time of each stage; 0 when it was kept
    std::array<bool, stage_count> redone{};
    double strokes_ms = 0;  // of silhouettes and creases, a small stage beside surface and lighting
    bool strokes_redone = false;
    double total_ms = 0;
    std::uint64_t triangles = 0;      // of all objects
    std::uint64_t shaded_pixels = 0;  // pixels that show a surface
    std::uint64_t evaluations = 0;    // of the lighting equation: points lit x enabled lights
    int threads = 0;
    const char* instruction_set = "";  // scalar, sse2, avx2, avx512 or neon
};

/// What shows at a pixel. Camera coordinates, scene units.
struct SeenPoint {
    int object = 0;          // in Scene::objects
    std::uint32_t face = 0;  // polygon, in the file's order from 0
    glm::vec3 position{0};
    glm::vec3 normal{0};         // unit; the facet's under the mode `facet`, else the interpolated one
    bool front = true;           // counter-clockwise on the screen, the other way round for a mirrored object
    std::uint32_t triangle = 0;  // of all triangles that are drawn: which of them shows
};

class Renderer {
  public:
    /// `threads` = 0: all cores. The picture is the same, bit for bit, for every number.
    explicit Renderer(int threads = 0);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Draws the scene; meshes must be loaded. The picture stays valid and unchanged until the next call.
    /// `linear` asks for Picture::linear too. Throws LimitExceeded before anything is drawn where the scene
    /// is too_large() (models/scene/scene_cost.h): then the last picture stays. After any other exception
    /// there is no picture, and the next call draws as the first one does. `samples`: 1, 2, 4 or 8 a pixel;
    /// each face seen in a pixel is lit once, at the mean of its covered samples, and weighted by their
    /// count, in linear light.
    const Picture& render(const Scene& scene, PictureSize size, bool linear = false, int samples = 1);

    /// Sets whether a frame in which only one light has changed may reuse the sum of the others. If true (the
    /// default), it does so only where that gives the same bytes. If false, every light is added every time.
    void keep_sums(bool keep);

    [[nodiscard]] const FrameStats& stats() const;

    /// Why pixel (x, y) of the last rendered picture has its colour. Its sum equals the pixel to the last
    /// bit. Precondition: render() was called with one sample a pixel, and the pixel is inside the picture.
    [[nodiscard]] Explanation explain(int x, int y) const;

    /// Explains the pixel as if the scene were `other`, which may differ from the drawn one in lights,
    /// materials, ambient light, display and shading, but in nothing that decides which face a pixel shows
    /// (camera, meshes, transforms, `cull`; lights too where lights_cull()) nor in strokes. Equal to
    /// render(other) and explain(), to the last bit, at the cost of one pixel; the picture stays.
    [[nodiscard]] Explanation explain_as(const Scene& other, int x, int y) const;

    /// Object index at a pixel of the last picture, or -1.
    [[nodiscard]] int object_at(int x, int y) const;

    /// What shows at a pixel of the last picture; nothing for background.
    [[nodiscard]] std::optional<SeenPoint> seen_at(int x, int y) const;

    /// Distance in front of the camera (-z in camera coordinates) of what shows at a pixel, or 0 for
    /// background.
    [[nodiscard]] float depth_at(int x, int y) const;

    /// The share of a pixel of the last picture that strokes cover, from 0 to 1.
    [[nodiscard]] float stroke_at(int x, int y) const;

    /// Warnings of the last frame (normals that were missing, ...), one a kind.
    [[nodiscard]] const Warnings& warnings() const;

  private:
    struct Kept;
    std::unique_ptr<Kept> kept_;
};

}  // namespace glint
