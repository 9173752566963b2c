#include "tests/gl/program.h"

#include <GL/gl.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/places.h"

namespace glint::test {
namespace {

GLuint compile(GLenum kind, const ShaderSource& source) {
    const char* text = source.text.c_str();
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    std::string log(4096, '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(source.name + ": " + log.c_str());
}

}  // namespace

std::string shader_text(const std::string& path) {
    const std::ifstream file(project_file("tests/") + path);
    if (!file) throw std::runtime_error("the shader " + path + " cannot be read");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

unsigned link_program(const ShaderSource& vertex, const ShaderSource& fragment) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER, vertex));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) return program;
    std::string log(4096, '\0');
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(vertex.name + ", " + fragment.name + ": " + log.c_str());
}

}  // namespace glint::test
