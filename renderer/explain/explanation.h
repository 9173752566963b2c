#pragma once
// Every number behind one pixel, as a value: what `glint explain` prints and the inspector shows.
// Filled by the same functions that make the picture; the JSON's fields are documented in docs/explain.md.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// A vector or a position in both frames; illumination is computed in camera coordinates.
struct InBothFrames {
    glm::vec3 camera{0}, world{0};
};

/// What a microfacet highlight is made of: S = π/4 D G F / n·v, where the light is in front of the surface.
struct ExplainedFacets {
    float d = 0, g = 0, n_dot_v = 0;
    glm::vec3 f{0};
};

/// What one light (or one sample of an area light) does at one point, as it enters the sum.
struct ExplainedLight {
    std::string name;      // empty in the samples of an area light
    int index = 0;         // in Scene::lights
    InBothFrames l, r, h;  // unit: towards the light; l mirrored at n; halfway between l and v
    float n_dot_l = 0;     // not clamped: negative means the light is behind the surface
    float r_dot_v = 0, n_dot_h = 0, l_dot_v = 0;
    float distance = 0;  // scene units; 0 for a directional light
    float falloff = 1, spot = 1;
    float spot_angle_deg = 0;      // between the cone's axis and the direction to the point; 0 without a cone
    float diffuse_factor = 0;      // what multiplies light.diffuse * k_d: <n.l> for Lambert
    glm::vec3 specular_factor{0};  // S of docs/scene_file.md, per channel; 0 where n.l <= 0
    ExplainedFacets facets;        // under Cook-Torrance
    glm::vec3 ambient{0}, diffuse{0}, specular{0};  // what reaches the eye
    glm::vec3 share{0};  // what is added to the sum: the three terms together, rounded as the picture rounds
                         // them; of an area light each sample has one, and this is 0
    std::vector<ExplainedLight> samples;  // of an area light; then the fields above are their sums
};

/// Cool-to-warm shading: what the sum begins with in place of emission, ambient and diffuse terms.
struct ExplainedTone {
    bool used = false;
    float n_dot_l = 0;           // for the first enabled light; 0 without one
    float k_w = 0.5f;            // share of the warm tone: (1 + n.l) / 2
    glm::vec3 cool{0}, warm{0};  // cool + alpha k_d, warm + beta k_d
    glm::vec3 color{0};          // k_w warm + (1 - k_w) cool
};

/// The lighting equation at one point.
struct ExplainedPoint {
    InBothFrames point, normal, view;
    std::vector<ExplainedLight> lights;  // enabled ones, in the scene's order
    glm::vec3 emission{0}, global_ambient{0};
    ExplainedTone cool_to_warm;
    /// What the sum begins with: emission + global ambient light, rounded as the shares are, or the tone.
    glm::vec3 base{0};
    glm::vec3 sum{0};
};

/// One corner of the interpolation under Gouraud, or the flat point (weight 1).
struct ExplainedCorner {
    float weight = 0;
    ExplainedPoint at;
};

/// The picked point carried through every space of the pipeline (lecture: "Projective Rendering Pipeline").
/// Lighting stands between camera and clip coordinates.
struct ExplainedSpaces {
    glm::vec3 object{0}, world{0}, camera{0};
    glm::vec4 clip{0};
    glm::vec3 ndc{0};    // -1 to 1
    glm::vec2 pixel{0};  // y down, (0, 0) the picture's upper left corner
};

/// The last step of a pixel's sum: (1 - coverage) shaded + coverage color.
struct ExplainedStroke {
    float coverage = 0;  // share of the pixel under strokes; 0: no stroke, nothing to add
    glm::vec3 color{0};
    glm::vec3 shaded{0};  // the sum before
};

/// What the pixel would be under a way of weighing the corners.
struct ExplainedInterpolation {
    Interpolation interpolation = Interpolation::Perspective;
    glm::vec3 sum{0};  // before strokes
};

struct Explanation {
    int x = 0, y = 0;
    bool hit = false;  // false: background
    std::string object;
    int object_index = -1;
    std::uint32_t face = 0;      // polygon, in the file's order from 0
    std::uint32_t triangle = 0;  // of that polygon's triangles, from 0
    bool front_facing = true;
    ShadingMode mode = ShadingMode::Phong;
    Reflection reflection = Reflection::Phong;
    Material material;
    std::array<std::uint32_t, 3> corner{};  // the drawn triangle's corners: indices into Mesh::positions
    glm::vec3 weights{0};                   // perspective-correct weights of those corners at the pixel
    ExplainedSpaces spaces;
    ExplainedPoint at;  // phong and facet: the pixel's own point, lit. Others: its place and normal, unlit
    std::vector<ExplainedCorner> corners;  // gouraud and flat: what was lit, and its weight
    Interpolation interpolation = Interpolation::Perspective;  // gouraud: whose weights the corners have
    std::vector<ExplainedInterpolation> interpolations;  // gouraud: each of them, in the enumerators' order
    bool lit_per_corner = false;                         // true when `corners` makes the sum
    ExplainedStroke stroke;                              // over surface or background
    glm::vec3 sum{0};        // linear, before exposure: the pixel of the PFM / exposure
    glm::vec3 displayed{0};  // after exposure, transfer and clamp, 0 to 1
    std::array<int, 3> byte{};
};

}  // namespace glint
