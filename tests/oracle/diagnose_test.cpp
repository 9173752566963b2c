// Pictures by Mesa's OpenGL, right ones and those of a program with a mistake in its text: what a diagnosis
// makes of them.
#include "renderer/diagnose/diagnose.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "models/scene/mistakes.h"
#include "tests/oracle/gl_canvas.h"
#include "tests/oracle/gl_scene.h"
#include "tests/oracle/random_scene.h"
#include "tests/oracle/wrong_programs.h"
#include "tests/renderer/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::oracle;

namespace {

constexpr PictureSize size{160, 120};

/// What OpenGL draws, as 8 bits behind the scene's display.
Picture shown(GlCanvas& canvas, GlPainter& painter, const Scene& scene, const WrongProgram* wrong) {
    const GlPicture<float> drawn = canvas.floats(size, [&] { painter.draw(scene, size, Route::Shader); });
    Picture picture{size, std::vector<std::uint8_t>(4 * size.pixels(), 255), {}};
    for (std::size_t i = 0; i < drawn.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        const float x = wrong != nullptr && wrong->shown ? wrong->shown(drawn.rgba[i]) : drawn.rgba[i];
        picture.rgba[i] = std::isnan(x)
                              ? std::uint8_t{0}
                              : static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0f, 1.0f)));
    }
    return picture;
}

std::optional<std::size_t> number_of(std::string_view name) {
    for (std::size_t i = 0; i < mistake_names().size(); ++i)
        if (mistake_names()[i].name == name) return i;
    return std::nullopt;
}

/// Scenes such as a student lights: those whose reflection is one of the lecture's, under modes that light
/// corners or pixels.
bool is_usual(const Scene& scene) {
    const Reflection r = scene.shading.reflection;
    return !scene.npr.cool_to_warm &&
           (r == Reflection::Lambert || r == Reflection::Phong || r == Reflection::BlinnPhong);
}

SceneDocument document_of(const Scene& scene) {
    SceneDocument document;
    document.scene = scene;
    return document;
}

/// Whether a mistake shows in OpenGL's pictures where two programs can be compared at all.
bool shows(const Scene& scene, const Picture& wrong, const Picture& right) {
    constexpr std::uint64_t enough = 30;
    Renderer renderer;
    (void)renderer.render(scene, size);
    const std::vector<PixelKind> kinds = pixel_kinds(renderer, size);
    return score(Exhibit(wrong, right, kinds), {right, {}}, {}).unlike >= enough;
}

/// How many pictures of how many were named: by the first name, and by one of the first three.
struct Named {
    int all = 0, first = 0, among_three = 0;

    void add(const Diagnosis& d, const MistakeSet& set, const std::string& what) {
        const auto named = [&](const Candidate& c) {
            return c.mistakes == set || std::find(c.also.begin(), c.also.end(), set) != c.also.end();
        };
        const bool is_mistake = d.verdict == Verdict::Mistake;
        const bool is_first = is_mistake && named(d.candidates.front());
        ++all;
        first += is_first ? 1 : 0;
        among_three += is_mistake && std::any_of(d.candidates.begin(), d.candidates.end(), named) ? 1 : 0;
        if (is_first) return;
        std::printf("  %s under %s: verdict %d %s\n", name_of(set).c_str(), what.c_str(),
                    static_cast<int>(d.verdict),
                    d.candidates.empty() ? "" : name_of(d.candidates[0].mistakes).c_str());
    }
};

}  // namespace

TEST_CASE("a right picture of OpenGL has no mistake", "[oracle][diagnose]") {
    GlCanvas canvas;
    GlPainter painter;
    int all = 0, right = 0;
    for (unsigned i = 0; i < 126; ++i) {
        const Scene scene = random_scene(i);
        if (!can_draw(scene)) continue;
        const Diagnosis d =
            diagnose(document_of(scene), shown(canvas, painter, scene, nullptr), {false, 0, {}});
        if (d.verdict == Verdict::NotComparable) continue;  // it shows next to no surface
        ++all;
        right += d.verdict == Verdict::NoMistake ? 1 : 0;
    }
    std::printf("diagnose: %d of %d right pictures of OpenGL have no mistake\n", right, all);
    CHECK(all > 100);
    CHECK(100 * right >= 99 * all);
}

TEST_CASE("the mistake in an OpenGL program's text is named", "[oracle][diagnose]") {
    GlCanvas canvas;
    GlPainter right_painter;
    Named named;
    for (const WrongProgram& wrong : wrong_programs()) {
        const auto mistake = number_of(wrong.name);
        if (!mistake) continue;
        GlPainter painter(wrong.text);
        unsigned drawn = 0;
        for (unsigned i = 0; i < 300 && drawn < 8; ++i) {
            const Scene scene = random_scene(i);
            Scene seen = scene;
            if (!is_usual(scene) || !can_draw(scene) || (wrong.scene && !wrong.scene(seen))) continue;
            const Picture picture = shown(canvas, painter, seen, &wrong);
            if (!shows(scene, picture, shown(canvas, right_painter, scene, nullptr))) continue;
            ++drawn;
            const test::WrongPicture brought = test::displayed_somehow(picture, 1000 * i + drawn);
            const Diagnosis d = diagnose(document_of(scene), brought.picture, {false, 0, {}});
            named.add(d, {*mistake}, brought.what + " in scene " + std::to_string(i));
        }
    }
    std::printf("diagnose: of %d wrong pictures of OpenGL %d are named first, %d among three\n", named.all,
                named.first, named.among_three);
    CHECK(named.all > 80);
    CHECK(100 * named.first >= 95 * named.all);
    CHECK(100 * named.among_three >= 97 * named.all);
}
