#pragma once
// The stages as the renderer keeps them between frames.

#include "models/scene/scene.h"
#include "renderer/geometry/geometry.h"
#include "renderer/shade/lighting.h"
#include "renderer/strokes/strokes.h"
#include "renderer/surface/surface.h"
#include "renderer/transport/transport_stage.h"
#include "renderer/visibility/visibility.h"

namespace glint {

struct KeptStages {
    Scene scene;  // drawn last
    Geometry geometry;
    Visibility visibility;
    Surface surface;
    Strokes strokes;
    TransportStage transport;
    Lighting lighting;
};

}  // namespace glint
