#include "renderer/shade/runs_to_do.h"

#include <algorithm>

namespace glint {
namespace {

unsigned of_objects_again(const Lighting& l, const Surface& s, std::size_t batch) {
    const std::size_t first = batch * block_size, count = std::min(block_size, s.runs.size() - first);
    unsigned again = 0;
    for (std::size_t i = 0; i < count; ++i) again |= unsigned{l.objects_again[s.runs[first + i].object]} << i;
    return again;
}

/// Those where the moving light may add something.
unsigned of_moving_light(const Lighting& l, std::size_t batch) {
    unsigned lit = 0;
    for (const LightSource& source : l.moving_sources)
        lit |= shade_kernels().find_lit(source, l.reach[batch]);
    return lit;
}

}  // namespace

RunsToDo runs_to_do(Lighting& l, const Surface& s, std::size_t batch) {
    if (!l.objects_again.empty()) return {of_objects_again(l, s, batch), 0};
    if (l.moving < 0 || l.reach.empty()) return {};
    const unsigned lit = of_moving_light(l, batch), shown = l.shown_lit[batch];
    l.shown_lit[batch] = static_cast<std::uint16_t>(lit);
    return {lit, shown & ~lit};
}

}  // namespace glint
