#include "tests/bench/llvmpipe/gl_program.h"

#include <GL/gl.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace glint::bench {
namespace {

std::string text_of(const std::string& name) {
    const std::ifstream file(std::string(GLINT_SOURCE_DIR) + "/tests/bench/llvmpipe/" + name);
    if (!file) throw std::runtime_error("the shader " + name + " cannot be read");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

GLuint compile(GLenum kind, const std::string& name, const std::string& head, bool with_light) {
    const std::string text =
        "#version 330 core\n" + head + (with_light ? text_of("light.glsl") : "") + text_of(name);
    const char* source = text.c_str();
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    std::string log(4096, '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(name + ": " + log.c_str());
}

}  // namespace

unsigned make_program(const ProgramText& text) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER, text.vertex, text.head, text.light_in_vertex));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, text.fragment, text.head, text.light_in_fragment));
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) return program;
    std::string log(4096, '\0');
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(text.vertex + ", " + text.fragment + ": " + log.c_str());
}

}  // namespace glint::bench
