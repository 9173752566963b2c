#pragma once
// Positions a light by its effect at a surface point: brightest there, or lit from behind, so that the
// outline is lit. Also finds the light that contributes most there. Pure functions.

#include <map>
#include <optional>

#include "models/scene/light.h"
#include "renderer/explain/explanation.h"
#include "ui/picture/surface_patch.h"

namespace glint {

/// The effect of a light at the point under the cursor.
enum class LightEffect { Brightest, Rim };

struct LightEffectInfo {
    LightEffect effect;
    const char* done;   // "Bulb ...", at the cursor
    const char* means;  // in the status line: the resulting position of the light
    const char* waits;  // there, if no position of the light has the effect
};
[[nodiscard]] const LightEffectInfo& info_of(LightEffect effect);

/// The angle between n and l, in degrees, at the point that sets a rim light: the surface is lit from there
/// to the outline.
inline constexpr double rim_light_deg = 75;

/// Returns the light moved to have that effect at a pixel. Brightest: n.l = 1. Rim: n.l = cos 75 degrees, l
/// in the plane of n and v on the far side of n. It keeps its distance from the point (a directional light is
/// turned); a spot or a panel turns to shine at the point. Nothing on the background; for Rim, nothing where
/// n and v are less than 15 degrees apart: light from behind cannot reach it.
[[nodiscard]] std::optional<Light> with_effect(LightEffect effect, const Light& light,
                                               const SurfaceView& view, glm::dvec2 pixel);

/// What a light adds to the sum at one point, per channel: all terms together, all samples of an area light.
[[nodiscard]] glm::vec3 added_by(const ExplainedLight& light);

/// What each light adds to a pixel, per channel, by its index; under Gouraud and flat shading from all
/// corners.
[[nodiscard]] std::map<int, glm::vec3> added_to_pixel(const Explanation& explanation);
/// The share of `added` in the pixel's sum over all channels, 0 to 1.
[[nodiscard]] double share_of_pixel(const Explanation& explanation, glm::vec3 added);

/// The light that contributes most to a pixel's sum.
struct MainLight {
    int light = 0;     // index into Scene::lights
    double share = 0;  // share of the sum over all channels, 0 to 1
};
/// Nothing if no light contributes.
[[nodiscard]] std::optional<MainLight> main_light(const Explanation& explanation);

/// The intensity after the cursor moved up by `up_px` in a picture `height` pixels high: a factor of e per
/// third of the height. An intensity of 0 rises as if from a hundredth.
[[nodiscard]] float dimmed(float intensity, double up_px, int height);

}  // namespace glint
