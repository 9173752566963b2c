#pragma once
// Sets a light by its effect at a point of the surface: it shines brightest there, or from behind, so that
// the outline is lit. Also finds the light that contributes most there. Pure functions.

#include <optional>

#include "models/scene/light.h"
#include "renderer/explain/explanation.h"
#include "ui/picture/surface_patch.h"

namespace glint {

/// What a light shall do at the point under the cursor.
enum class LightEffect { Brightest, Rim };

struct LightEffectInfo {
    LightEffect effect;
    const char* done;   // "Bulb ...", beside the cursor
    const char* means;  // in the status line: where the light then stands
    const char* waits;  // there, where no light can do it
};
[[nodiscard]] const LightEffectInfo& info_of(LightEffect effect);

/// The angle between n and l, in degrees, at the point that a rim light is set by: the surface is lit from
/// there to the outline.
inline constexpr double rim_light_deg = 75;

/// Returns the light moved so that it has that effect at a pixel. Brightest: n.l = 1. Rim: n.l = cos 75
/// degrees, l in the plane of n and v on the far side of n. It keeps its distance from the point (a
/// directional light is turned); a spot or a panel turns to shine at the point. Nothing on the background;
/// for Rim, nothing where n and v are less than 15 degrees apart: light from behind cannot come there.
[[nodiscard]] std::optional<Light> with_effect(LightEffect effect, const Light& light,
                                               const SurfaceView& view, glm::dvec2 pixel);

/// The light that adds most to a pixel's sum.
struct MainLight {
    int light = 0;     // in Scene::lights
    double share = 0;  // of the sum over all channels, 0 to 1
};
/// Nothing where no light adds anything.
[[nodiscard]] std::optional<MainLight> main_light(const Explanation& explanation);

/// The intensity after the cursor went up by `up_px` of a picture so many pixels high: a third of the height
/// is a factor e. From 0 it rises as from a hundredth.
[[nodiscard]] float dimmed(float intensity, double up_px, int height);

}  // namespace glint
