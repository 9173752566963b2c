#pragma once
// A renderer's caches must not affect its pictures.

#include "renderer/renderer.h"
#include "tests/support/catch.h"

namespace glint::test {

/// Draws with a renderer that has drawn before. Requires the bytes, and the unclamped numbers if requested,
/// to equal those of a picture drawn from scratch by a new renderer on one thread.
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
