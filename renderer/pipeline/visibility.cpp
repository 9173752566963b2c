#include "renderer/pipeline/visibility.h"

#include "renderer/pipeline/rasterize.h"

namespace glint {

bool update_visibility(Visibility& kept, const Geometry& g, Cull cull, bool geometry_redone) {
    if (!geometry_redone && kept.cull == cull) return false;
    kept.cull = cull;
    const std::size_t pixels =
        static_cast<std::size_t>(g.size.width) * static_cast<std::size_t>(g.size.height);
    kept.keys.assign(pixels, 0);
    kept.back.assign(pixels, 0);
    rasterize_tiles(g, kept);
    return true;
}

}  // namespace glint
