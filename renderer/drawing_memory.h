#pragma once
// Says how much memory a picture takes, before any of it is taken. What only drawing can tell (how many tiles
// the triangles touch, how the objects divide the rows of pixels) is guessed here and counted, by the stages
// themselves, before they make room for it.

#include "models/memory_limit.h"
#include "models/scene/scene.h"
#include "renderer/picture.h"

namespace glint {

/// At least what a renderer holds at any one time of drawing this scene at this size, with what may be
/// guessed of it before; meshes are counted where they are made. Precondition: meshes are loaded.
struct DrawingMemory {
    MemoryNeed certain;  // whatever shows in the picture
    MemoryNeed guessed;  // beside that
};
[[nodiscard]] DrawingMemory drawing_memory(const Scene& scene, PictureSize size, bool linear, int samples);

}  // namespace glint
