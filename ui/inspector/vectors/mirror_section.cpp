#include "ui/inspector/vectors/mirror_section.h"

#include <fmt/core.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/inspect/reflectance/mirror.h"
#include "ui/inspector/equation/parts.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Made when first asked for.
const std::array<Choice, 5>& step_options() {
    static const std::array<Choice, 5> options{
        Choice{"", "off", "r itself is drawn"}, Choice{"", "N, L", "What is given"},
        Choice{"", "P", "P = N (N·L): the shadow of L on N"}, Choice{"", "2P", "Twice as far"},
        Choice{"", "R", "R = 2P − L"}};
    return options;
}

}  // namespace

void mirror_section(WhyState& state, const ExplainedPoint& point, const ExplainedLight& light) {
    section("r = 2 n (n·l) − l, step by step");
    state.mirror_step = segments("##step", state.mirror_step, step_options(), {"", ""});
    if (state.mirror_step == 0) return;
    (void)number_field("|N|", state.normal_length,
                       {.range = {0.25, 2, "0.25 to 2"}, .step = 0.005f, .format = "%.2f", .usual_max = 2}, 1,
                       {"Length of the normal here; a normal is to be unit. Not part of the scene", ""});
    const bool world = state.world_frame;
    const glm::vec3 n = state.normal_length * (world ? point.normal.world : point.normal.camera);
    const glm::vec3 l = world ? light.l.world : light.l.camera;
    const MirrorSteps steps = mirror_steps(n, l);
    vector_line(Symbol::N, "N", n);
    vector_line(Symbol::L, "L", l);
    if (state.mirror_step >= 2) vector_line(Symbol::Diffuse, "P = N (N·L)", steps.p);
    if (state.mirror_step >= 3) vector_line(Symbol::Diffuse, "2P", steps.twice_p);
    if (state.mirror_step >= 4) vector_line(Symbol::R, "R = 2P − L", steps.r);
    const float length = state.normal_length;
    if (std::abs(length - 1) > 0.005f)
        warning_text(fmt::format("|N| = {:.2f}: P is {:.2f} times as long as it should be, |R| = {:.2f}",
                                 length, length * length, glm::length(steps.r)));
}

}  // namespace glint
