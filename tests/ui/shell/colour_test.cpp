// Editing colours: the picker and its presets.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/widgets/widgets.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

ImGuiWindow* open_popup() {
    const auto& stack = ImGui::GetCurrentContext()->OpenPopupStack;
    return stack.empty() ? nullptr : stack.back().Window;
}

/// Opens the picker of the selected light's diffuse colour; returns the position of its swatch.
ImVec2 open_picker(HeadlessWindow& bench) {
    const ImVec2 swatch = bench.control("/lights/0/diffuse");
    bench.click(swatch);
    bench.frames(2);
    REQUIRE(open_popup() != nullptr);
    return swatch;
}

/// The centre of a preset. `row`: 0 for pure colours, 1 for lamps.
ImVec2 preset_at(const ImGuiWindow& popup, int row, int column) {
    const ImVec2 pad = popup.WindowPadding;
    const float gap = 4, across = popup.Size.x - 2 * pad.x, side = (across - 9 * gap) / 10;
    const float low = popup.Pos.y + popup.Size.y - pad.y, step = side + ImGui::GetStyle().ItemSpacing.y;
    return {popup.Pos.x + pad.x + float(column) * (side + gap) + side / 2,
            low - side / 2 - float(1 - row) * step};
}

/// Linear sRGB of a black body, scaled so that its largest channel is 1.
/// Source: Kim et al., US patent 7,024,034 (2006): cubic splines for the Planckian locus, 1667 to 25000 K.
glm::dvec3 black_body(double t) {
    const double x = t <= 4000 ? -0.2661239e9 / (t * t * t) - 0.2343589e6 / (t * t) + 877.6956 / t + 0.179910
                               : -3.0258469e9 / (t * t * t) + 2.1070379e6 / (t * t) + 222.6347 / t + 0.240390;
    const double y = t <= 2222   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                     : t <= 4000 ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                                 : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    const glm::dvec3 xyz{x / y, 1, (1 - x - y) / y};
    const glm::dvec3 rgb{3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
                         -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
                         0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
    const double most = std::max({rgb.x, rgb.y, rgb.z});
    return {std::max(rgb.x, 0.0) / most, std::max(rgb.y, 0.0) / most, std::max(rgb.z, 0.0) / most};
}

}  // namespace

TEST_CASE("a preset in the picker sets its colour as one undo step", "[ui][window]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    const ImVec2 swatch = open_picker(bench);
    REQUIRE(bench.scene() == before);
    const ImGuiWindow& popup = *open_popup();
    CHECK(popup.Pos.x > swatch.x);  // the edited swatch stays visible
    bench.click(preset_at(popup, 0, 7));
    bench.frames(1);
    CHECK(bench.scene().lights[0].diffuse == glm::vec3(0, 1, 1));
    bench.click(preset_at(popup, 1, 1));
    bench.frames(1);
    CHECK(bench.scene().lights[0].diffuse == glm::vec3(1, 0.423f, 0.1f));
    CHECK(bench.state.editor.history.undo_name() == "Colour of Sun");
    bench.key(Key::Escape);
    bench.frames(2);
    CHECK(open_popup() == nullptr);
    bench.key(Key::Z, true);
    CHECK(bench.scene().lights[0].diffuse == glm::vec3(0, 1, 1));
    bench.key(Key::Z, true);
    CHECK(bench.scene() == before);
}

TEST_CASE("dragging a swatch onto another copies its colour", "[ui][window]") {
    DrawnWindow bench;
    bench.scene().lights[0].diffuse = {0.2f, 0.4f, 0.6f};
    bench.frames(2);
    const ImVec2 from = open_picker(bench);
    bench.key(Key::Escape);
    bench.frames(2);
    bench.drag(from, bench.control("/lights/0/specular"));
    bench.frames(1);
    CHECK(bench.scene().lights[0].specular == glm::vec3(0.2f, 0.4f, 0.6f));
    CHECK(bench.scene().lights[0].diffuse == glm::vec3(0.2f, 0.4f, 0.6f));
}

TEST_CASE("the lamp presets have the colour of a black body", "[ui]") {
    int lamps = 0;
    for (const ColourPreset& preset : colour_presets()) {
        INFO(preset.name);
        CHECK(std::max({preset.linear.x, preset.linear.y, preset.linear.z}) <= 1);
        if (preset.kelvin == 0) continue;
        ++lamps;
        const glm::dvec3 known = black_body(preset.kelvin);
        for (int i = 0; i < 3; ++i) CHECK(double(preset.linear[i]) == Approx(known[i]).margin(0.012));
    }
    CHECK(lamps == 7);
}
