#pragma once
// Evaluates the highlight of one light at individual points on a surface, and finds the light direction for
// which it peaks there, for dragging a highlight. Uses the picture's own equation, including mistakes.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "models/scene/scene.h"
#include "models/scene/shading.h"
#include "renderer/renderer.h"

namespace glint {

/// Returns the specular term of `light` (which need not be in the scene or enabled) at each of `points`, for
/// a white light and a material with k_s = 1: the sum over the channels, including falloff and cone; for an
/// area light, the sum over its samples. Each point is lit individually, as in the mode `phong`. The term is
/// >= 0, and 0 if the model has no highlight or the light is behind the surface.
[[nodiscard]] std::vector<double> highlight_at(const Scene& scene, PictureSize size, const Light& light,
                                               std::span<const SeenPoint> points);

/// Overload that uses `material` instead of the objects' materials.
[[nodiscard]] std::vector<double> highlight_at(const Scene& scene, PictureSize size, const Light& light,
                                               std::span<const SeenPoint> points, const Material& material);

/// n.l of a light at a point, not clamped; for an area light, of its middle sample (the third if there are
/// four).
[[nodiscard]] double cosine_at(const Scene& scene, PictureSize size, const Light& light,
                               const SeenPoint& point);

/// Unit direction from a point towards a light whose highlight factor is largest there: v mirrored about n,
/// which is the same for (r.v)^n and (n.h)^n, or v itself for retro-reflection. Camera coordinates. (0, 0, 0)
/// if the surface faces away from the viewer (n.v <= 0).
[[nodiscard]] glm::vec3 peak_direction(const Scene& scene, PictureSize size, const SeenPoint& point);

// Alternative falloffs of a highlight, and the best-fitting power of a cosine. Lecture: "How might we model
// this falloff?"

/// Alternatives to cos^n: a Gaussian and a straight line, each 1 at 0 degrees and 1/2 where cos^n is 1/2.
enum class HighlightShape { Gaussian, Linear };

/// The angle in degrees where cos^n is 1/2: 60 for n = 1; 90 if cos^n stays above 1/2 (n near 0). n >= 0.
[[nodiscard]] double half_angle_deg(double n);

/// Returns the shape as (degrees, value) from 0 to 90.
[[nodiscard]] std::vector<glm::dvec2> highlight_shape(HighlightShape shape, double n, int steps);

struct HighlightFit {
    double shininess = 0;  // 0 to 10,000
    double error = 0;      // root mean square of the residuals
};
/// The shininess for which the highlight of a reflection model (Phong or Blinn-Phong, light at the normal) is
/// the least-squares fit to points (degrees from the highlight's centre, 0 to 90; value). nullopt for fewer
/// than two points.
[[nodiscard]] std::optional<HighlightFit> fitted_highlight(Reflection reflection,
                                                           std::span<const glm::dvec2> points);

/// The shininess n' for which Blinn-Phong's highlight is the least-squares fit to Phong's with `shininess`
/// (>= 0) over angles from 0 to 90 degrees. n' is about four times `shininess`.
[[nodiscard]] double blinn_shininess_like(float shininess);

// The derivation of r, step by step. Lecture: "Calculating R Vector": P is the projection of l onto n, R = 2
// P - L.

struct MirrorSteps {
    float n_dot_l = 0;
    glm::vec3 p{0}, twice_p{0}, r{0};  // n (n.l); 2 n (n.l); 2 n (n.l) - l
};

/// The equation's r for a normal of any length. If |n| = k, p is too long by a factor of k^2, and r is not
/// the mirror direction. All vectors are in the same frame.
[[nodiscard]] MirrorSteps mirror_steps(glm::vec3 n, glm::vec3 l);

// Plots single factors of the equation against their argument, sampled from the equation's own functions.
// Lecture: "Light Source Falloff", "Light Sources" (spot), "Phong Lighting Model" (cos^n).

/// (r, falloff) from 0 to `farthest` (> 0) scene units in `steps` (>= 1) steps. Empty if the light's falloff
/// is not a function of r alone (directional: no falloff; area: one falloff per sample). Precondition:
/// `light` is an index into Scene::lights. The light may be disabled.
[[nodiscard]] std::vector<glm::dvec2> falloff_curve(const Scene& scene, int light, double farthest,
                                                    int steps);

/// (degrees from the spot's axis, factor) from -90 to 90. Empty for a light without a cone. The samples
/// include both edges of the cutoff and the angles just outside them.
[[nodiscard]] std::vector<glm::dvec2> spot_curve(const Scene& scene, int light, int steps);

/// (degrees between r and v, S) from -90 to 90 for a light at the normal: cos^n for Phong, cos^n of half the
/// angle for Blinn-Phong. For other reflection models, their S.
[[nodiscard]] std::vector<glm::dvec2> highlight_curve(Reflection reflection, float shininess, int steps);

/// S of a surface with k_s = 1 at `view_deg` from its normal, for a light at the normal.
[[nodiscard]] double highlight_at(Reflection reflection, float shininess, double view_deg);

}  // namespace glint
