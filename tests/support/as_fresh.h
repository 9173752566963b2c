#pragma once
// Whatever a renderer keeps must not show.

#include "renderer/renderer.h"
#include "tests/support/catch.h"

namespace glint::test {

/// Draws with a renderer that has drawn before, and holds the picture against one drawn from scratch on
/// another number of threads: the bytes are the same, and the unclamped numbers where they are asked for.
inline const Picture& draw_as_fresh(Renderer& kept, const Scene& scene, PictureSize size, bool linear = false,
                                    int samples = 1) {
    Renderer fresh(1);
    const Picture& a = kept.render(scene, size, linear, samples);
    const Picture& b = fresh.render(scene, size, linear, samples);
    REQUIRE(a.rgba == b.rgba);
    REQUIRE(a.linear == b.linear);
    return a;
}

}  // namespace glint::test
