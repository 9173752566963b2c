#pragma once
// What students do by mistake to lights and viewer before the equation sees them (models/scene/mistakes.h).

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"

namespace glint {

/// Falloff and cone as the mistakes have them. No mistake leaves the source as it is.
void apply_source_mistakes(const Mistakes& mistakes, const Light& light, LightSource& source);

/// Viewer, shininess and projection as the mistakes have them; notes whether any mistake is made at all.
void apply_job_mistakes(const Scene& scene, PictureSize size, LightJob& job);

}  // namespace glint
