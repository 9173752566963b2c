// The effects of an object's switches: `visible` and `normals.flip`.
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
