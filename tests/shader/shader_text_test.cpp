#include "shader/shader_text.h"

#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

std::string only_message(const std::string& log) {
    const auto messages = shader_messages(log, 7);
    REQUIRE(messages.size() == 1);
    return problem_from(messages[0], "a.glsl").text();
}

}  // namespace

TEST_CASE("each loop of a shader counts its iterations, and line numbers stay the same", "[shader]") {
    CHECK(prepared_shader("while (a < b) ++a;") == "while (loop_runs() && (a < b)) ++a;");
    CHECK(prepared_shader("for(int i = f(1); i < 3; ++i) {}") ==
          "for(int i = f(1);loop_runs() && ( i < 3); ++i) {}");
    CHECK(prepared_shader("for (;;) {}") == "for (;loop_runs();) {}");
    CHECK(prepared_shader("do { } while (x);") == "do { } while (loop_runs() && (x));");
    CHECK(prepared_shader("while (for_(x) > 0) while(y);") ==
          "while (loop_runs() && (for_(x) > 0)) while(loop_runs() && (y));");
    CHECK(prepared_shader("while /* ( */ (a /* ) */ )\n{}") ==
          "while /* ( */ (loop_runs() && (a /* ) */ ))\n{}");
    CHECK(prepared_shader("#define EVER for (;;)\nEVER") == "#define EVER for (;loop_runs();)\nEVER");
}

TEST_CASE("text that is not a loop stays the same", "[shader]") {
    for (const char* text :
         {"float forward(float while_) { return while_; } // while (true)", "/* for (;;) */", "while (",
          "for (;", "while (bool b = f()) {}", "for", "", "/*", "//"})
        CHECK(prepared_shader(text) == text);
}

TEST_CASE("a #version line in a shader becomes spaces", "[shader]") {
    CHECK(prepared_shader("// a\n #  version 330\nvec3 a;") == "// a\n               \nvec3 a;");
    CHECK(prepared_shader("#versio").size() == 7);
}

TEST_CASE("messages from three compilers name the line in the user's file", "[shader]") {
    CHECK(only_message("0:4(12): error: `foo' undeclared\n") == "a.glsl:4: `foo' undeclared");
    CHECK(only_message("1:8(1): preprocessor error: Unterminated comment") ==
          "a.glsl:8: Unterminated comment");
    CHECK(only_message("0(12) : error C1008: undefined variable \"foo\"") ==
          "a.glsl:12: undefined variable \"foo\"");
    CHECK(only_message("ERROR: 0:3: 'foo' : undeclared identifier") ==
          "a.glsl:3: 'foo' : undeclared identifier");
    CHECK(only_message("0:4(2): error: syntax error, unexpected BASIC_TYPE_TOK, expecting ',' or ';'") ==
          "a.glsl:4: syntax error, unexpected a type, expecting ',' or ';'");
    CHECK_FALSE(shader_messages("0:2(1): warning: `x' used uninitialized", 7)[0].is_error);
    CHECK(shader_messages("0:2(1): error: `return' with wrong type error, in function `lit'", 7).empty());
    CHECK(shader_messages("0:2(1): error: a\n0:2(1): error: a\nnothing\n", 7).size() == 1);
}

TEST_CASE("an error after the user's file is reported about that file", "[shader]") {
    CHECK(only_message("0:3000012(3): error: no function with name 'lit'") ==
          "a.glsl: there is no function that can be called as lit(vec3 p, vec3 n); expected vec3 lit(vec3 p, "
          "vec3 n)");
    CHECK(only_message("error: unresolved reference to function `lit'") ==
          only_message("0:3000012(3): error: no function with name 'lit'"));
    CHECK(only_message("0:3000001(1): error: syntax error, unexpected OUT") ==
          "a.glsl:7: the file ends within a function, a declaration or a comment");
    CHECK(only_message("0:3000004(1): error: function `main' redefined") ==
          "a.glsl: it conflicts with the code that Glint adds: function `main' redefined");
    CHECK(shader_messages("0:3000004(1): warning: `turned' used uninitialized", 7).empty());
}

TEST_CASE("a long line in a compiler's log is truncated", "[shader]") {
    const std::string log = "0:4(12): error: `" + std::string(1'000'000, 'a') + "' undeclared";
    CHECK(shader_messages(log, 7)[0].text.size() < 1000);
}
