#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "models/fields/scene_fields.h"
#include "models/scene/scene.h"
#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "tests/support/asset_scenes.h"
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

// The scenes that come with Glint.
TEST_CASE("every scene in assets opens, draws without a warning, and fills its picture", "[assets]") {
    const std::vector<std::string> paths = test::asset_scenes();
    REQUIRE(paths.size() >= 7);
    for (const std::string& path : paths) {
        CAPTURE(path);
        const auto document = open_document(path);
        if (const Problem* problem = problem_of(document)) FAIL(problem->text());
        const auto& opened = std::get<SceneDocument>(document);
        CHECK(opened.warnings.empty());
        Renderer renderer(1);
        renderer.render(opened.scene, {160, 90});
        CHECK(renderer.warnings().empty());
        CHECK(renderer.stats().shaded_pixels > 160 * 90 / 16);
    }
}

// Every member of a scene has a row in models/fields/scene_fields.h: without one, the reader and the writer
// would silently skip it.
namespace {

struct Anything {
    template <class T> operator T() const;  // never called: only the conversion must exist
};

/// The number of members of the aggregate T: the largest number of values that can initialize it.
template <class T, class... Given> constexpr std::size_t member_count() {
    if constexpr (requires { T{Given{}..., Anything{}}; })
        return member_count<T, Given..., Anything>();
    else
        return sizeof...(Given);
}

template <class T> std::size_t row_count() {
    std::size_t rows = 0;
    const T value{};
    fields(value, [&](const Row&, const auto&, const auto&) { ++rows; });
    return rows;
}

template <class T> void check_rows(const char* name, std::size_t without_row = 0, std::size_t more_rows = 0) {
    INFO(name);
    CHECK(row_count<T>() + without_row == member_count<T>() + more_rows);
}

struct Three {
    std::string name;
    Projection projection;
    glm::vec3 position{0};
};
static_assert(member_count<Three>() == 3);

}  // namespace

TEST_CASE("every member of a scene has its row", "[scene_fields]") {
    check_rows<Falloff>("Falloff");
    check_rows<SpotCone>("SpotCone");
    check_rows<AreaShape>("AreaShape");
    check_rows<Light>("Light");
    check_rows<MeshFile>("MeshFile");
    check_rows<PrimitiveMesh>("PrimitiveMesh");
    check_rows<Transform>("Transform");
    check_rows<NormalOptions>("NormalOptions");
    check_rows<Material>("Material");
    check_rows<Object>("Object", 1);  // the mesh is loaded from the source in the row
    check_rows<Perspective>("Perspective");
    check_rows<Orthographic>("Orthographic");
    check_rows<Frustum>("Frustum");
    check_rows<Camera>("Camera");
    check_rows<Terms>("Terms");
    check_rows<Mistakes>("Mistakes", 0, 3);  // `only` has four rows
    check_rows<Shading>("Shading");
    check_rows<Npr>("Npr");
    check_rows<Display>("Display");
    check_rows<Scene>("Scene");
}
