// Diagnoses pictures of Mesa's OpenGL: correct ones, and those of programs with a mistake in their code.
#include "diagnose/diagnose.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "models/scene/mistakes.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/oracle/gl_canvas.h"
#include "tests/oracle/gl_scene.h"
#include "tests/oracle/left_out.h"
#include "tests/oracle/random_scene.h"
#include "tests/oracle/wrong_programs.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::oracle;

namespace {

constexpr PictureSize size{160, 120};

/// OpenGL's picture in 8 bits, after the conversion by the scene's display.
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

/// Whether a scene is typical of a student: its reflection is one of the lecture's, in a mode that lights
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

std::vector<PixelKind> kinds_in(const Scene& scene) {
    Renderer renderer;
    (void)renderer.render(scene, size);
    return pixel_kinds(renderer, size);
}

/// Whether a mistake is visible in OpenGL's pictures at pixels where two programs are comparable.
bool shows(const std::vector<PixelKind>& kinds, const Picture& wrong, const Picture& right) {
    constexpr std::uint64_t enough = 30;
    return score(Exhibit(wrong, right, kinds), {right, {}}, {}).unlike >= enough;
}

/// Whether the two programs interpolate the scene's triangles differently: OpenGL's clipper or the near plane
/// cuts one under screen-linear interpolation.
bool is_cut_otherwise(const Scene& scene) {
    if (scene.shading.interpolation != Interpolation::Screen) return false;
    Renderer renderer;
    (void)renderer.render(scene, size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Explanation e = renderer.explain(x, y);
            if (!e.hit) continue;
            const LeftOut out = left_out_at(scene, size, e);
            if (out == LeftOut::CutByNear || out == LeftOut::CutTwice) return true;
        }
    return false;
}

struct NumberedScene {
    unsigned number = 0;
    Scene scene;
};

/// Returns the typical scenes among the first `count` random scenes.
std::vector<NumberedScene> usual_scenes(unsigned count) {
    std::vector<NumberedScene> usual;
    for (unsigned i = 0; i < count; ++i) {
        const Scene scene = random_scene(i);
        if (is_usual(scene) && can_draw(scene) && !is_cut_otherwise(scene)) usual.push_back({i, scene});
    }
    return usual;
}

/// OpenGL's picture of a scene without a mistake, and the kinds of its pixels.
struct Right {
    Picture picture;
    std::vector<PixelKind> kinds;
};

/// Draws each scene's correct picture once, for all mistakes.
class RightPictures {
  public:
    const Right& of(GlCanvas& canvas, const NumberedScene& scene) {
        const auto known = drawn_.find(scene.number);
        if (known != drawn_.end()) return known->second;
        Right right{shown(canvas, painter_, scene.scene, nullptr), kinds_in(scene.scene)};
        return drawn_.emplace(scene.number, std::move(right)).first->second;
    }

  private:
    GlPainter painter_;
    std::map<unsigned, Right> drawn_;
};

/// Whether the wrong picture is the correct one times a gain, except for rounding: then they are
/// indistinguishable, and the answer is "no mistake".
bool is_a_gain_of(const Picture& wrong, const Picture& right) {
    constexpr int clamped = 250;
    constexpr double rounding = 3;
    double product = 0, square = 0;
    const auto for_each = [&](const auto& take) {
        for (std::size_t i = 0; i < right.rgba.size(); ++i)
            if (i % 4 != 3 && right.rgba[i] < clamped && wrong.rgba[i] < clamped)
                take(double(wrong.rgba[i]), double(right.rgba[i]));
    };
    for_each([&](double w, double r) {
        product += w * r;
        square += r * r;
    });
    const double gain = square > 0 ? product / square : 1;
    int unlike = 0;
    for_each([&](double w, double r) { unlike += std::abs(w - gain * r) > rounding ? 1 : 0; });
    return unlike < 30;
}

/// Counts pictures whose mistake is named by the first candidate or by one of the first three.
struct Named {
    int all = 0, first = 0, among_three = 0;

    void add(const Diagnosis& d, const MistakeSet& set, const std::string& what) {
        const bool is_first = test::is_named(d, set);
        const auto named = [&](const Candidate& c) {
            return c.mistakes == set || std::find(c.also.begin(), c.also.end(), set) != c.also.end();
        };
        ++all;
        first += is_first ? 1 : 0;
        const bool is_later =
            d.verdict == Verdict::Mistake && std::any_of(d.candidates.begin(), d.candidates.end(), named);
        among_three += is_first || is_later ? 1 : 0;
        if (is_first) return;
        std::printf("  %s under %s: verdict %d %s\n", name_of(set).c_str(), what.c_str(),
                    static_cast<int>(d.verdict),
                    d.candidates.empty() ? "" : name_of(d.candidates[0].mistakes).c_str());
    }
};

std::vector<TextChange> together(std::vector<TextChange> a, const std::vector<TextChange>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

}  // namespace

TEST_CASE("a correct picture by OpenGL has no mistake", "[oracle][diagnose]") {
    GlCanvas canvas;
    GlPainter painter;
    int all = 0, right = 0;
    for (unsigned i = 0; i < 126; ++i) {
        const Scene scene = random_scene(i);
        if (!can_draw(scene)) continue;
        const Diagnosis d = diagnose(document_of(scene), shown(canvas, painter, scene, nullptr), {});
        if (d.verdict == Verdict::NotComparable) continue;  // the picture shows almost no surface
        ++all;
        right += d.verdict == Verdict::NoMistake ? 1 : 0;
    }
    std::printf("diagnose: %d of %d correct OpenGL pictures have no mistake\n", right, all);
    CHECK(all > 100);
    CHECK(100 * right >= 99 * all);
}

namespace {

/// Diagnoses that number of wrong pictures by OpenGL for each mistake.
void check_mistakes(int pictures) {
    GlCanvas canvas;
    RightPictures right_pictures;
    Named named;
    const std::vector<NumberedScene> usual = usual_scenes(300);
    for (const WrongProgram& wrong : wrong_programs()) {
        const auto mistake = number_of(wrong.name);
        if (!mistake) continue;
        GlPainter painter(wrong.text);
        int drawn = 0;
        for (const NumberedScene& numbered : usual) {
            const auto& [i, scene] = numbered;
            if (drawn == pictures) break;
            Scene seen = scene;
            if (wrong.scene && !wrong.scene(seen)) continue;
            const Picture picture = shown(canvas, painter, seen, &wrong);
            const Right& right = right_pictures.of(canvas, numbered);
            if (!shows(right.kinds, picture, right.picture) || is_a_gain_of(picture, right.picture)) continue;
            ++drawn;
            const test::WrongPicture brought = test::displayed_somehow(picture, 1000 * i + drawn);
            const Diagnosis d = diagnose(document_of(scene), brought.picture, {});
            named.add(d, {*mistake}, brought.what + " in scene " + std::to_string(i));
        }
    }
    std::printf("diagnose: of %d wrong OpenGL pictures, %d are named first, %d among three\n", named.all,
                named.first, named.among_three);
    CHECK(named.all >= 35 * pictures);
    CHECK(100 * named.first >= 95 * named.all);
    CHECK(100 * named.among_three >= 98 * named.all);
}

/// Diagnoses that number of pictures by OpenGL programs with two mistakes each.
void check_pairs(int wanted) {
    GlCanvas canvas;
    RightPictures right_pictures;
    Named named;
    const std::span<const WrongProgram> programs = wrong_programs();
    const std::vector<NumberedScene> usual = usual_scenes(120);
    for (std::size_t k = 0; k < 128 && named.all < wanted; ++k) {
        const WrongProgram& a = programs[7 * k % programs.size()];
        const WrongProgram& b = programs[(7 * k + 1 + k % 11) % programs.size()];
        const auto first = number_of(a.name), second = number_of(b.name);
        if (!first || !second || first == second || (a.shown && b.shown)) continue;
        if (a.name == "encoded_twice" || b.name == "encoded_twice") continue;  // is in `display`
        const NumberedScene& numbered = usual[k % usual.size()];
        const auto& [i, scene] = numbered;
        Scene seen_by_a = scene, seen_by_b = scene;
        if ((a.scene && !a.scene(seen_by_a)) || (b.scene && !b.scene(seen_by_b))) continue;
        Scene seen_by_both = seen_by_a;
        if (b.scene && !b.scene(seen_by_both)) continue;
        GlPainter by_a(a.text), by_b(b.text), by_both(together(a.text, b.text));
        const Picture both = shown(canvas, by_both, seen_by_both, a.shown ? &a : &b);
        // If one hides the other or is invisible, they do not count as two. A gain is excluded, because a
        // display can cause it as well.
        const Right& right = right_pictures.of(canvas, numbered);
        const auto is_more_than = [&](const Picture& less) {
            return shows(right.kinds, both, less) && !is_a_gain_of(both, less);
        };
        if (!is_more_than(right.picture) || !is_more_than(shown(canvas, by_a, seen_by_a, &a)) ||
            !is_more_than(shown(canvas, by_b, seen_by_b, &b)))
            continue;
        const Diagnosis d = diagnose(document_of(scene), both, {.pairs = true});
        named.add(d, {std::min(*first, *second), std::max(*first, *second)}, "scene " + std::to_string(i));
    }
    std::printf("diagnose: of %d OpenGL pictures with two mistakes, %d are named first, %d among three\n",
                named.all, named.first, named.among_three);
    CHECK(named.all == wanted);
    CHECK(100 * named.first >= 80 * named.all);
}

}  // namespace

// A picture with one mistake takes a sixth of a second, one with two takes over a second.
TEST_CASE("the mistake in an OpenGL program's code is named", "[oracle][diagnose]") { check_mistakes(6); }
TEST_CASE("the mistake in an OpenGL program's code is named in more scenes", "[.nightly][oracle][diagnose]") {
    check_mistakes(12);
}
TEST_CASE("two mistakes in one OpenGL program's code are named together", "[oracle][diagnose]") {
    check_pairs(6);
}
TEST_CASE("two mistakes in one OpenGL program's code are named together in more scenes",
          "[.nightly][oracle][diagnose]") {
    check_pairs(16);
}
