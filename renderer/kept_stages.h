#pragma once
// The stages as the renderer keeps them between frames.

#include "models/scene.h"
#include "renderer/pipeline/geometry.h"
#include "renderer/pipeline/lighting.h"
#include "renderer/pipeline/strokes.h"
#include "renderer/pipeline/surface.h"
#include "renderer/pipeline/visibility.h"

namespace glint {

struct KeptStages {
    Scene scene;  // as drawn last
    Geometry geometry;
    Visibility visibility;
    Surface surface;
    Strokes strokes;
    Lighting lighting;
};

}  // namespace glint
