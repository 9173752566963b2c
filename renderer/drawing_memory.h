#pragma once
// Says how much memory a picture takes, before any of it is taken. What only drawing can tell (how many tiles
// the triangles touch, how the objects divide the rows of pixels) is guessed here and counted, by the stages
// themselves, before they make room for it.

#include "models/memory_limit.h"
#include "models/scene/scene.h"
#include "renderer/picture.h"

namespace glint {

/// A lower bound of the memory that a renderer holds while it draws this scene at this size, without the
/// meshes, which are counted where they are made. Precondition: meshes are loaded.
struct DrawingMemory {
    MemoryNeed certain;  // needed whatever the picture shows
    MemoryNeed guessed;  // a guess of what is needed beside that
};
[[nodiscard]] DrawingMemory drawing_memory(const Scene& scene, PictureSize size, bool linear, int samples);

}  // namespace glint
