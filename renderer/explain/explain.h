#pragma once
// Explains the colour of a pixel: runs the drawing functions of the picture again, with `float`, and records
// every step.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"
#include "renderer/simd/glm_vec3.h"
#include "renderer/stages.h"
#include "renderer/surface/surface.h"

namespace glint {

// All numbers that determine one pixel. `glint explain` prints them and the inspector shows them. Computed by
// the functions that draw the picture; docs/explain.md documents the JSON fields.

/// A vector or a position in both frames. Lighting is computed in camera coordinates.
struct InBothFrames {
    glm::vec3 camera{0}, world{0};
};

/// The factors of a microfacet highlight: S = π/4 D G F / n·v, for a light in front of the surface.
struct ExplainedFacets {
    float d = 0, g = 0, n_dot_v = 0;
    glm::vec3 f{0};
};

/// The contribution of one light, or of one sample of an area light, at one point.
struct ExplainedLight {
    std::string name;      // empty in the samples of an area light
    int index = 0;         // index in Scene::lights
    InBothFrames l, r, h;  // unit vectors: towards the light; l mirrored about n; halfway between l and v
    float n_dot_l = 0;     // not clamped: negative if the light is behind the surface
    float r_dot_v = 0, n_dot_h = 0, l_dot_v = 0;
    float distance = 0;  // scene units; 0 for a directional light
    float falloff = 1, spot = 1;
    float spot_angle_deg = 0;      // between the cone's axis and the direction to the point; 0 without a cone
    float diffuse_factor = 0;      // multiplies light.diffuse * k_d: <n.l> for Lambert
    glm::vec3 specular_factor{0};  // S in docs/scene_file.md, per channel; 0 if n.l <= 0
    ExplainedFacets facets;        // used by Cook-Torrance
    glm::vec3 ambient{0}, diffuse{0}, specular{0};  // light reflected towards the eye
    glm::vec3 share{0};  // added to the sum: the three terms together, rounded as in the picture;
                         // 0 for an area light, whose samples have one each
    // With the models `shadows` and `bounces`, the three terms and `share` are 0 if the light is blocked.
    float reached = 1;  // 0 or 1; for an area light, unblocked fraction of samples in front of the surface
    // The first blocking object, an index into Scene::objects; for an area light, that of its first blocked
    // sample; -1: none.
    int blocker = -1;
    std::string blocked_by;               // name of the blocker
    std::vector<ExplainedLight> samples;  // for an area light; the fields above are sums over them
};

/// Cool-to-warm shading, which starts the sum instead of the emission, ambient and diffuse terms.
struct ExplainedTone {
    bool used = false;
    float n_dot_l = 0;           // for the first enabled light; 0 without one
    float k_w = 0.5f;            // fraction of the warm tone: (1 + n.l) / 2
    glm::vec3 cool{0}, warm{0};  // cool + alpha k_d, warm + beta k_d
    glm::vec3 color{0};          // k_w warm + (1 - k_w) cool
};

/// Light that arrives from other surfaces, with the model `bounces`.
struct ExplainedBounces {
    bool used = false;            // whether it replaces global ambient light
    glm::vec3 arrives{0};         // mean radiance of the paths
    glm::vec3 standard_error{0};  // of `arrives`, estimated from the variance of the paths; 0 for one path
    int paths = 0;
    glm::vec3 term{0};  // k_d times `arrives`
};

/// The lighting equation at one point.
struct ExplainedPoint {
    InBothFrames point, normal, view;
    std::vector<ExplainedLight> lights;  // enabled lights, in scene order
    glm::vec3 emission{0}, global_ambient{0};
    ExplainedBounces bounces;
    ExplainedTone cool_to_warm;
    /// The initial value of the sum: emission plus global ambient light or bounced light, rounded like the
    /// light contributions; or the tone.
    glm::vec3 base{0};
    glm::vec3 sum{0};
};

/// One corner of the Gouraud interpolation, or the flat point (weight 1).
struct ExplainedCorner {
    float weight = 0;
    ExplainedPoint at;
};

/// The picked point in every coordinate system of the pipeline (lecture: "Projective Rendering Pipeline").
/// Lighting is computed between camera and clip coordinates.
struct ExplainedSpaces {
    glm::vec3 object{0}, world{0}, camera{0};
    glm::vec4 clip{0};
    glm::vec3 ndc{0};    // -1 to 1
    glm::vec2 pixel{0};  // y down, with (0, 0) at the picture's upper left corner
};

/// The last step of a pixel's sum: (1 - coverage) shaded + coverage color.
struct ExplainedStroke {
    float coverage = 0;  // fraction of the pixel covered by strokes; 0: no stroke
    glm::vec3 color{0};
    glm::vec3 shaded{0};  // the sum before the stroke
};

/// The colour that the pixel would have with this interpolation of the corners.
struct ExplainedInterpolation {
    Interpolation interpolation = Interpolation::Perspective;
    glm::vec3 sum{0};  // before strokes
};

struct Explanation {
    int x = 0, y = 0;
    bool hit = false;  // false: background
    std::string object;
    int object_index = -1;
    std::uint32_t face = 0;      // polygon index in file order, from 0
    std::uint32_t triangle = 0;  // index among the polygon's triangles, from 0
    bool front_facing = true;
    ShadingMode mode = ShadingMode::Phong;
    Reflection reflection = Reflection::Phong;
    Material material;
    std::array<std::uint32_t, 3> corner{};  // the drawn triangle's corners: indices into Mesh::positions
    glm::vec3 weights{0};                   // perspective-correct weights of those corners at the pixel
    ExplainedSpaces spaces;
    // Phong and facet: the pixel's own point, lit. Others: its position and normal, unlit.
    ExplainedPoint at;
    std::vector<ExplainedCorner> corners;  // gouraud and flat: the lit points and their weights
    Interpolation interpolation = Interpolation::Perspective;  // gouraud: determines the corners' weights
    std::vector<ExplainedInterpolation> interpolations;        // gouraud: one per kind, in enumerator order
    bool lit_per_corner = false;                               // whether the sum blends `corners`
    ExplainedStroke stroke;                                    // over the surface or the background
    glm::vec3 sum{0};        // linear, before exposure: the pixel in the PFM divided by the exposure
    glm::vec3 displayed{0};  // after exposure, transfer and clamp, 0 to 1
    std::array<int, 3> byte{};
};

/// Precondition: the stages contain a drawn picture and (x, y) is inside it.
[[nodiscard]] Explanation explain_pixel(const KeptStages& stages, int x, int y);

/// Explains the pixel as if the scene were `other`. It may differ from the drawn scene in lights, materials,
/// ambient light, display and shading, but not in strokes or in anything that determines the visible face
/// (camera, meshes, transforms, `cull`). The result is bit-identical to drawing and explaining `other`, at
/// the cost of one pixel (plus all normals, if they differ).
[[nodiscard]] Explanation explain_pixel_as(KeptStages& stages, const Scene& other, int x, int y);

/// Implement Renderer::shadow_rays() and Renderer::bounce_path().
[[nodiscard]] std::vector<TracedLight> trace_lights(KeptStages& stages, int x, int y, int corner);
[[nodiscard]] std::vector<PathStep> trace_path(KeptStages& stages, int x, int y, int path, int corner);

// Explains the lighting equation at one point. Used by explain.cpp.

/// Converts a vector or position in camera coordinates to InBothFrames.
class Frames {
  public:
    explicit Frames(const Camera& camera) : world_from_view_(world_from_view(camera)) {}
    [[nodiscard]] InBothFrames direction(Vec3<float> v) const { return both_frames(to_glm(v), 0); }
    [[nodiscard]] InBothFrames position(Vec3<float> v) const { return both_frames(to_glm(v), 1); }

  private:
    [[nodiscard]] InBothFrames both_frames(glm::vec3 v, double w) const {
        return {v, glm::vec3(world_from_view_ * glm::dvec4(glm::dvec3(v), w))};
    }
    glm::dmat4 world_from_view_;
};

/// The inputs for shadow rays and paths. The references must outlive this object.
struct PointTransport {
    LitPointFinder points;
    const TransportInputs& inputs;
    const Scene& scene;
};

/// The light that arrives at a point. Without a transport, nothing is blocked.
struct PointArrivals {
    const PointTransport* transport = nullptr;
    TracedPoint point = {};
};

/// Evaluates the equation at one point and records every step; adds the sum in the same order as the picture.
/// Unless `lit`, fills in only position, normal and view vector.
[[nodiscard]] ExplainedPoint explain_point(const Lighting& lighting, const LightJob& job,
                                           const PositionNormal& place, const Frames& frames, bool lit,
                                           const PointArrivals& arrivals);

}  // namespace glint
