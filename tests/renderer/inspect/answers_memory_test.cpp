// What telling of a mesh needs is reckoned before it is taken.
#include "models/mesh/topology.h"
#include "renderer/inspect/answers/answers.h"
#include "renderer/programs/mesh_text.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/scenes.h"

using namespace glint;

TEST_CASE("the edges of a mesh are counted only where there is memory for them", "[memory]") {
    const Object ball = test::object_of(test::primitive(Primitive::Sphere, 200));
    const std::uint64_t needed = ball.mesh->triangles.size() * bytes_of_topology;
    {
        const test::MemoryLimit limit(needed);
        CHECK_NOTHROW((void)info_json(*ball.mesh));
    }
    const test::MemoryLimit limit(needed - 1);
    CHECK_THROWS_AS((void)info_json(*ball.mesh), Refused);
}

TEST_CASE("the text of a mesh is made only where there is memory for it, and is no longer than was reckoned",
          "[memory][programs]") {
    for (const int detail : {3, 40, 200}) {
        Object ball = test::object_of(test::primitive(Primitive::Sphere, detail));
        ball.transform = {};
        MemoryShare share;
        const std::string text = mesh_text(ball, {}, share);
        const std::uint64_t reckoned = share.need().total();
        CHECK(text.size() <= reckoned);
        CHECK(reckoned < 3 * text.size() + 1000);
        share = {};
        const test::MemoryLimit limit(reckoned - 1);
        CHECK_THROWS_AS((void)mesh_text(ball, {}, share), Refused);
    }
}
