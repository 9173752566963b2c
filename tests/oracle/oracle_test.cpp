#include <cstdio>

#include "tests/catch.h"
#include "tests/oracle/agreement.h"
#include "tests/oracle/random_scene.h"

using namespace glint;
using namespace glint::oracle;

TEST_CASE("OpenGL draws random scenes as we do", "[oracle]") {
    Comparison comparison;
    for (unsigned i = 0; i < 168; ++i) {
        const Scene scene = random_scene(i);
        REQUIRE(can_draw(scene));
        comparison.add("random scene " + std::to_string(i), scene, {160, 120}, Route::Shader);
    }
    for (unsigned i = 0; i < 72; ++i) {
        const Scene scene = random_fixed_function_scene(i);
        REQUIRE(fixed_function_can_draw(scene));
        comparison.add("fixed-function scene " + std::to_string(i), scene, {160, 120}, Route::FixedFunction);
    }
    std::printf("%s\n%s\n", comparison.canvas().description().c_str(), comparison.figure().text().c_str());
    for (const std::string& line : comparison.figure().disagreements) FAIL_CHECK(line);
    CHECK(comparison.figure().pixels > 100000);
}
