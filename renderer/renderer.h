#pragma once
// Scene -> pixels, and why. Each of the five stages is a function of its inputs and cached until they change:
// geometry -> visibility -> surface -> transport -> lighting, with a small strokes stage before transport
// (docs/architecture.md). There are no dirty flags: the renderer compares the scene with the last one.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "models/problem.h"
#include "models/scene/scene.h"
#include "renderer/explain/explain.h"
#include "renderer/picture.h"
#include "renderer/transport/traced.h"

namespace glint {

enum class Stage { Geometry, Visibility, Surface, Transport, Lighting };
inline constexpr int stage_count = 5;

/// Timings and counts of one frame.
struct FrameStats {
    std::array<double, stage_count> ms{};  // wall time of each stage; 0 if it did not run
    std::array<bool, stage_count> redone{};
    double strokes_ms = 0;  // time for silhouettes and creases, a small stage before lighting
    bool strokes_redone = false;
    double total_ms = 0;
    std::uint64_t triangles = 0;      // in all objects
    std::uint64_t shaded_pixels = 0;  // pixels that show a surface
    std::uint64_t evaluations = 0;  // times the lighting equation was evaluated: lit points x enabled lights
    int threads = 0;
    const char* instruction_set = "";  // scalar, sse2, avx2, avx512 or neon
};

/// The surface that a pixel shows. Camera coordinates, scene units.
struct SeenPoint {
    int object = 0;          // in Scene::objects
    std::uint32_t face = 0;  // polygon, in the file's order from 0
    glm::vec3 position{0};
    glm::vec3 normal{0};         // unit vector; facet normal in the mode `facet`, else interpolated
    bool front = true;           // counter-clockwise on the screen (clockwise if the object is mirrored)
    std::uint32_t triangle = 0;  // global number of the visible triangle
};

class Renderer {
  public:
    /// `threads` = 0: all cores. The picture has the same bits for any number of threads.
    explicit Renderer(int threads = 0);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Draws the scene; meshes must be loaded. The picture stays valid and unchanged until the next call.
    /// `linear` also fills Picture::linear. If the scene is too_large() (models/scene/scene.h), throws
    /// LimitExceeded before drawing, and the last picture remains. Any other exception discards the picture;
    /// the next call then starts from scratch. `samples`: 1, 2, 4 or 8 per pixel; each face seen in a pixel
    /// is lit once, at the mean of its covered samples, and weighted by their count, in linear light.
    /// Mistakes with a scope (MistakeScope) are drawn three or four times; explain() then ignores the scope.
    const Picture& render(const Scene& scene, PictureSize size, bool linear = false, int samples = 1);

    /// Sets whether a frame in which only one light has changed may reuse the sum of the others. If true (the
    /// default), the sum is reused only if that gives the same bytes. If false, every light is added every
    /// time.
    void keep_sums(bool keep);

    /// Calls `progress(done, all)` on the thread that called render() while it follows paths: `done` of `all`
    /// paths of each point are finished. A picture refines in steps if the scene's number of paths grows from
    /// call to call: render() then follows only the additional ones, and the bytes are the same as for all at
    /// once.
    void on_paths(std::function<void(int done, int all)> progress);

    /// Draws only these blocks from the next frame on, so that many variants of a scene can be compared
    /// quickly. The other pixels keep their earlier contents. Null: all blocks are drawn.
    void draw_blocks(BlockChoice blocks);

    [[nodiscard]] const FrameStats& stats() const;

    /// Explains the colour of pixel (x, y) of the last rendered picture. Its sum equals the pixel to the last
    /// bit. Precondition: render() was called with one sample per pixel, and the pixel is inside the picture.
    [[nodiscard]] Explanation explain(int x, int y) const;

    /// Explains the pixel as if the scene were `other`, which may differ from the drawn one in lights,
    /// materials, ambient light, display and shading, but not in strokes or in anything that decides which
    /// face a pixel shows (camera, meshes, transforms, `cull`; also lights if lights_cull()). Gives the same
    /// bits as render(other) and explain(), at the cost of one pixel; the picture is unchanged.
    [[nodiscard]] Explanation explain_as(const Scene& other, int x, int y) const;

    /// The rays from a pixel's point to the enabled lights, in the scene's order (for an area light, to its
    /// middle sample), and what they hit first. Includes lights behind the surface, and works under the local
    /// model too: the first call then builds the acceleration structure. `corner`: for shading at corners,
    /// the start in Explanation::corners; -1: the one with the largest weight. Empty for background. Same
    /// precondition as explain().
    [[nodiscard]] std::vector<TracedLight> shadow_rays(int x, int y, int corner = -1) const;

    /// Whether the acceleration structure for shadow_rays() has already been built.
    [[nodiscard]] bool has_rays() const;

    /// The steps of path number `path` from the point of shadow_rays(); the path need not be one that the
    /// picture uses. Empty for background. Same precondition as explain().
    [[nodiscard]] std::vector<PathStep> bounce_path(int x, int y, int path, int corner = -1) const;

    /// Object index at a pixel of the last picture, or -1.
    [[nodiscard]] int object_at(int x, int y) const;

    /// The surface at a pixel of the last picture; nullopt for background.
    [[nodiscard]] std::optional<SeenPoint> seen_at(int x, int y) const;

    /// Distance of the surface at a pixel in front of the camera (-z in camera coordinates), or 0 for
    /// background.
    [[nodiscard]] float depth_at(int x, int y) const;

    /// The fraction of a pixel of the last picture that strokes cover, from 0 to 1.
    [[nodiscard]] float stroke_at(int x, int y) const;

    /// Warnings about the last frame (missing normals, ...), one of each kind.
    [[nodiscard]] const Warnings& warnings() const;

  private:
    struct Kept;
    std::unique_ptr<Kept> kept_;
};

// Mistakes that are made in only part of the picture (MistakeScope).

class Renderer;

/// Whether the scene's mistakes are made in only part of the picture. Visibility has no scope: with
/// culled_by_light, all mistakes are made everywhere.
[[nodiscard]] bool has_scope(const Scene& scene);

/// Returns the scene with nothing but the lights and terms of the scope.
[[nodiscard]] Scene isolated(Scene scene, const MistakeScope& scope);

/// Draws a scene whose mistakes have a scope, with linear colours. Light is a sum: the picture is the one
/// without mistakes, minus the scope's part of it, plus that part with the mistakes.
[[nodiscard]] Picture draw_scoped(Renderer& renderer, const Scene& scene, PictureSize size, int samples);

/// Explains a pixel of draw_scoped()'s picture: lights and terms in the scope are those with the mistakes.
/// Its sum equals the pixel to the last bit. Preconditions as for Renderer::explain_as(), for the scene with
/// and without the mistakes.
[[nodiscard]] Explanation explain_scoped(const Renderer& renderer, const Scene& scene, int x, int y);

}  // namespace glint
