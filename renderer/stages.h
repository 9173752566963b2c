#pragma once
// The stages, which the renderer keeps between frames.

#include "models/scene/scene.h"
#include "renderer/geometry/geometry.h"
#include "renderer/shade/lighting.h"
#include "renderer/strokes/strokes.h"
#include "renderer/surface/surface.h"
#include "renderer/transport/transport_stage.h"
#include "renderer/visibility/visibility.h"

namespace glint {

struct KeptStages {
    Scene scene;  // the last scene drawn
    Geometry geometry;
    Visibility visibility;
    Surface surface;
    Strokes strokes;
    TransportStage transport;
    Lighting lighting;
};

}  // namespace glint
