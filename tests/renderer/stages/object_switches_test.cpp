// The effects of an object's switches: `visible`, `normals.flip` and `material.reflection`.
#include "renderer/renderer.h"
#include "tests/support/as_fresh.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize small{96, 72};

void for_each_mode(Scene scene, auto&& check) {
    for (const ShadingMode mode :
         {ShadingMode::Flat, ShadingMode::Facet, ShadingMode::Gouraud, ShadingMode::Phong}) {
        scene.shading.mode = mode;
        CAPTURE(static_cast<int>(mode));
        check(scene);
    }
}

std::vector<std::uint8_t> drawn_bytes(const Scene& scene) { return Renderer(1).render(scene, small).rgba; }

}  // namespace

TEST_CASE("a hidden object leaves the picture as if it were not in the scene", "[renderer]") {
    Scene scene = busy_scene();
    REQUIRE(scene.objects.size() >= 2);
    scene.npr.silhouettes = scene.npr.creases = true;
    for_each_mode(scene, [](const Scene& shown) {
        for (std::size_t o = 0; o < shown.objects.size(); ++o) {
            CAPTURE(o);
            Scene hidden = shown, without = shown;
            hidden.objects[o].visible = false;
            without.objects.erase(without.objects.begin() + static_cast<std::ptrdiff_t>(o));
            CHECK(drawn_bytes(hidden) == drawn_bytes(without));
            CHECK(drawn_bytes(hidden) != drawn_bytes(shown));
        }
    });
}

TEST_CASE("flipping all objects equals the mistake that flips all normals, and undoes it", "[renderer]") {
    for_each_mode(busy_scene(), [](const Scene& right) {
        Scene flipped = right, mistaken = right;
        for (Object& object : flipped.objects) object.normals.flip = true;
        mistaken.shading.mistakes.normals_flipped = true;
        CHECK(drawn_bytes(flipped) == drawn_bytes(mistaken));
        CHECK(drawn_bytes(flipped) != drawn_bytes(right));
        flipped.shading.mistakes.normals_flipped = true;
        CHECK(drawn_bytes(flipped) == drawn_bytes(right));
    });
}

TEST_CASE("flipping one object's normals does not change the others", "[renderer]") {
    for_each_mode(busy_scene(), [](const Scene& right) {
        Scene flipped = right;
        flipped.objects[0].normals.flip = true;
        Renderer renderer(1);
        const Picture before = renderer.render(right, small, true);
        const Picture& after = renderer.render(flipped, small, true);
        CHECK(after.rgba == drawn_bytes(flipped));
        int wrong = 0, changed = 0;
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) {
                const Explanation e = renderer.explain(x, y);
                wrong += !same_bits(e.sum, after.linear_at(x, y));
                const bool same = same_bits(before.linear_at(x, y), after.linear_at(x, y));
                if (e.hit && e.object_index == 0) changed += !same;
                if (!e.hit || e.object_index != 0) wrong += !same;
            }
        CHECK(wrong == 0);
        CHECK(changed > 100);
    });
}

TEST_CASE("each object looks as if its own reflection model were the scene's", "[renderer]") {
    for_each_mode(busy_scene(), [](Scene scene) {
        const std::array own{OwnReflection::Scene, OwnReflection::OrenNayar, OwnReflection::CookTorrance};
        for (std::size_t o = 0; o < scene.objects.size(); ++o)
            scene.objects[o].material.reflection = own[o % own.size()];
        Renderer renderer(1), alone(1);
        const Picture mixed = renderer.render(scene, small, true);
        for (std::size_t o = 0; o < scene.objects.size(); ++o) {
            CAPTURE(o);
            Scene other = scene;
            for (Object& object : other.objects) object.material.reflection = OwnReflection::Scene;
            if (o % own.size() > 0) other.shading.reflection = static_cast<Reflection>(own[o % own.size()]);
            const Picture& same_model = alone.render(other, small, true);
            int seen = 0, wrong = 0;
            for (int y = 0; y < small.height; ++y)
                for (int x = 0; x < small.width; ++x) {
                    const Explanation e = renderer.explain(x, y);
                    if (!e.hit || e.object_index != static_cast<int>(o)) continue;
                    ++seen;
                    wrong +=
                        e.reflection != other.shading.reflection || !same_bits(e.sum, mixed.linear_at(x, y));
                    wrong += !same_bits(same_model.linear_at(x, y), mixed.linear_at(x, y));
                }
            CHECK(seen > 0);
            CHECK(wrong == 0);
        }
    });
}

TEST_CASE("switching to an object's own reflection model equals a fresh picture", "[renderer]") {
    Scene scene = busy_scene();
    Renderer renderer(1);
    (void)renderer.render(scene, small);
    scene.objects[0].material.reflection = OwnReflection::CookTorrance;
    CHECK(renderer.render(scene, small).rgba == drawn_bytes(scene));
    scene.shading.reflection = Reflection::None;  // no material is lit
    const std::vector<std::uint8_t> unlit = drawn_bytes(scene);
    scene.objects[0].material.reflection = OwnReflection::Scene;
    CHECK(drawn_bytes(scene) == unlit);
}
