#include "tests/bench/llvmpipe/gl_program.h"

#include "tests/gl/program.h"

namespace glint::bench {
namespace {

test::ShaderSource source(const std::string& name, const std::string& head, bool with_light) {
    const std::string folder = "bench/llvmpipe/";
    return {name, "#version 330 core\n" + head +
                      (with_light ? test::shader_text(folder + "light.glsl") : "") +
                      test::shader_text(folder + name)};
}

}  // namespace

unsigned make_program(const ProgramText& text) {
    return test::link_program(source(text.vertex, text.head, text.light_in_vertex),
                              source(text.fragment, text.head, text.light_in_fragment));
}

}  // namespace glint::bench
