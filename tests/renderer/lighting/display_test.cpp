// Bytes of a picture against IEC 61966-2-1 in double.
#include <cmath>
#include <vector>

#include "renderer/renderer.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

/// The standard's two pieces for linear x in 0 to 1.
double srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

/// The byte of a background of that much light, which the display converts like any pixel.
int byte_shown(float linear, Transfer transfer, float exposure = 1) {
    Scene scene;
    scene.display.background = glm::vec3(linear);
    scene.display.transfer = transfer;
    scene.display.exposure = exposure;
    Renderer renderer(1);
    return renderer.render(scene, {1, 1}).rgba[0];
}

}  // namespace

TEST_CASE("sRGB is linear up to 0.0031308 and a power above: its bytes match the standard", "[display]") {
    std::vector<float> linear{0, 0.0031308f, 0.0031309f, 0.04045f, 0.5f, 1};
    for (int i = 1; i <= 60; ++i) linear.push_back(0.001f * static_cast<float>(i));
    for (const float x : linear) {
        INFO("linear " << x);
        const double exact = 255 * srgb(double{x});
        const int byte = byte_shown(x, Transfer::Srgb);
        CHECK(std::abs(byte - exact) < 0.501);  // the nearest
    }
    CHECK(byte_shown(0.02f, Transfer::Srgb) == 39);  // 12.92 x would be 66
}

TEST_CASE("exposure is applied before clipping to the display's range", "[display]") {
    for (const float exposure : {0.0f, 0.25f, 0.5f, 2.0f, 3.0f})
        for (const float x : {0.0f, 0.1f, 0.3f, 0.45f, 0.7f, 1.0f, 1.5f, 3.0f}) {
            CAPTURE(exposure, x);
            const double exact = 255 * std::min(double{x} * exposure, 1.0);
            CHECK(std::abs(byte_shown(x, Transfer::None, exposure) - exact) < 0.501);
        }
    CHECK(byte_shown(3, Transfer::None, 0.25f) == 191);  // 3/4 of 255; clipping first would give 64
}

TEST_CASE("white is displayed as 1 with either transfer, nearly white as less", "[display]") {
    for (const Transfer transfer : {Transfer::None, Transfer::Srgb}) {
        Scene scene;
        scene.display.transfer = transfer;
        scene.display.background = {1, 7, 0.999f};
        Renderer renderer(1);
        (void)renderer.render(scene, {1, 1});
        const Explanation e = renderer.explain(0, 0);
        CHECK(e.displayed.x == 1);
        CHECK(e.displayed.y == 1);
        CHECK(e.displayed.z < 1);
        CHECK(e.byte[0] == 255);
    }
}
