// Every member of a scene has a row in models/fields/scene_fields.h: without one, the reader and the writer
// would silently skip it.
#include "models/fields/scene_fields.h"
#include "tests/support/catch.h"

using namespace glint;

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
