// GLINT_ISA forces an instruction set: the bytes of a picture must not depend on it.
#include <cstdlib>

#include "renderer/simd/isa/kernel_set.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

/// Sets GLINT_ISA for the programs that this test starts.
class Forced {
  public:
    explicit Forced(const char* set) { setenv("GLINT_ISA", set, 1); }
    ~Forced() { unsetenv("GLINT_ISA"); }
    Forced(const Forced&) = delete;
    Forced& operator=(const Forced&) = delete;
};

/// The bytes of a float picture.
std::string drawn(const std::vector<std::string>& settings) {
    const TemporaryDirectory folder;
    std::vector<std::string> words{
        "render", project_file("tests/bench/knot.json"), "--size", "159x91", "-o", folder.path("out.pfm")};
    for (const std::string& setting : settings) {
        words.emplace_back("--set");
        words.push_back(setting);
    }
    const Ended ended = run_glint(words);
    CHECK(ended.err.empty());
    return bytes_of(folder.path("out.pfm"));
}

}  // namespace

TEST_CASE("every instruction set draws the same bytes in every mode and model", "[cli][renderer][isa]") {
    std::vector<std::vector<std::string>> scenes;
    for (const char* model : {"lambert", "phong", "blinn-phong", "retro", "oren-nayar", "cook-torrance"})
        scenes.push_back({std::string("/shading/reflection=") + model});
    for (const char* mode : {"flat", "facet", "gouraud"})
        scenes.push_back({std::string("/shading/mode=") + mode});
    scenes.push_back({"/shading/two_sided=true", "/shading/cull=front"});
    scenes.push_back({"/npr/cool_to_warm=true"});
    // 60 taken as radians has a negative cosine: a cone wider than the half space in front of it.
    scenes.push_back({"/shading/mistakes/degrees_for_radians=true", "/lights/7/spot/cutoff_deg=60"});
    for (const auto& scene : scenes) {
        std::string first;
        for (const char* set : {"scalar", "sse2", "avx2", "avx512"}) {
            const Forced forced(set);
            if (instruction_set_problem()) continue;  // this processor lacks it
            const std::string bytes = drawn(scene);
            REQUIRE(!bytes.empty());
            if (first.empty()) first = bytes;
            INFO(set << " " << scene.front());
            CHECK((bytes == first));
        }
    }
}

TEST_CASE("an instruction set that does not exist is reported in one line as wrong usage", "[cli][isa]") {
    const Forced forced("sse9");
    const Ended ended = run_glint({"--version"});
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(ended.err ==
          "glint: error: GLINT_ISA: sse9 is not an instruction set; expected one of scalar, sse2, avx2, "
          "avx512\n");
}
