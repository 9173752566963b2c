// The guarantee of docs/explain.md: the values that `explain` lists, added as floats in order, equal the
// pixel bit for bit.
#include <array>
#include <bit>
#include <cstdint>

#include "models/fields/choices.h"
#include "models/json/json.h"
#include "models/scene_file/scene_file.h"
#include "renderer/explain/equation_text.h"
#include "renderer/renderer.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

using Rgb = std::array<float, 3>;

Rgb rgb_of(const Json& json) { return {json[0].get<float>(), json[1].get<float>(), json[2].get<float>()}; }

void add(Rgb& sum, const Rgb& more) {
    for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] + more[i];
}

/// The base plus the shares in order, clamped like fixed-function OpenGL if `clamps`.
Rgb added_up(const Json& at, bool clamps) {
    Rgb sum = rgb_of(at["base"]);
    for (const Json& light : at["lights"]) {
        if (!light.contains("samples")) {
            add(sum, rgb_of(light["share"]));
            continue;
        }
        CHECK_FALSE(light.contains("share"));
        for (const Json& sample : light["samples"]) add(sum, rgb_of(sample["share"]));
    }
    if (clamps)
        for (float& x : sum) x = std::min(std::max(x, 0.0f), 1.0f);
    return sum;
}

bool same_bits(const Rgb& a, const Rgb& b) {
    using Bits = std::array<std::uint32_t, 3>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

void check_pixel(const Json& e, const Scene& scene, const glm::vec3& pixel) {
    const Rgb sum = rgb_of(e["sum"]);
    CHECK(same_bits(sum, {pixel.x, pixel.y, pixel.z}));
    if (!e["hit"].get<bool>() || scene.shading.reflection == Reflection::None || e.contains("stroke")) return;
    const bool per_corner = e.contains("corners");
    const bool clamps = per_corner && scene.shading.rules == Rules::OpenGL2;
    if (!per_corner) CHECK(same_bits(added_up(e, clamps), sum));
    if (per_corner)
        for (const Json& corner : e["corners"])
            CHECK(same_bits(added_up(corner, clamps), rgb_of(corner["sum"])));
}

}  // namespace

TEST_CASE("base and shares add up to the sum for each shipped scene, mode, model and rules",
          "[explain][release]") {
    Renderer renderer(1);
    const PictureSize size{47, 29};
    for (const std::string& path : test::asset_scenes()) {
        Scene scene = std::get<SceneDocument>(open_document(path)).scene;
        for (const ShadingMode mode : enumerators<ShadingMode>)
            for (const Reflection reflection : enumerators<Reflection>)
                for (const Rules rules : enumerators<Rules>) {
                    scene.shading.mode = mode;
                    scene.shading.reflection = reflection;
                    scene.shading.rules = rules;
                    INFO(path << ' ' << name_of(mode) << ' ' << name_of(reflection) << ' ' << name_of(rules));
                    const Picture& picture = renderer.render(scene, size, true);
                    for (const auto& [x, y] : {std::pair{23, 14}, {9, 20}, {36, 8}})
                        check_pixel(Json::parse(explain_json(renderer.explain(x, y))), scene,
                                    picture.linear_at(x, y));
                }
    }
}
