#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "models/scene/scene.h"
#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("there are 29 materials: 6 gems, 11 metals, 6 plastics, 6 rubbers", "[material]") {
    std::map<std::string_view, int> families;
    std::set<std::string_view> names;
    for (const MaterialPreset& p : material_presets()) {
        ++families[p.family];
        names.insert(p.name);
    }
    CHECK(families ==
          std::map<std::string_view, int>{{"gem", 6}, {"metal", 11}, {"plastic", 6}, {"rubber", 6}});
    CHECK(names.size() == 29);
}

TEST_CASE("the materials have the numbers of the classic sample programs", "[material]") {
    const auto preset = [](std::string_view name) {
        const auto all = material_presets();
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == name; });
        REQUIRE(found != all.end());
        return found->material;
    };
    // Kilgard's teapots.c gives the shininess as a fraction of 128.
    const Material silver = preset("silver"), brass = preset("brass"), rubber = preset("black rubber");
    CHECK(silver.ambient == glm::vec3(0.19225f));
    CHECK(silver.diffuse == glm::vec3(0.50754f));
    CHECK(silver.specular == glm::vec3(0.508273f));
    CHECK(silver.shininess == Approx(0.4 * 128));
    CHECK(brass.specular == glm::vec3(0.992157f, 0.941176f, 0.807843f));
    CHECK(brass.shininess == Approx(0.21794872 * 128));
    CHECK(rubber.ambient == glm::vec3(0.02f));
    CHECK(rubber.shininess == Approx(0.078125 * 128));
    CHECK(preset("emerald").emission == glm::vec3(0));
}
