#pragma once
// What tests of the WHY column share.

#include "tests/unit/ui_bench.h"
#include "ui/why/tabs.h"

namespace glint::test {

/// Opens a tab and picks the pixel at this share of the picture.
inline void ask(Bench& bench, WhyTab tab, glm::dvec2 share = {0.5, 0.5}) {
    bench.frames(2);
    bench.state.why_column.tab = tab;
    bench.state.viewport.probe = share;
    bench.frames(3);
}

}  // namespace glint::test
