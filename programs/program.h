#pragma once
// A scene as a program that draws it: text for people who learn to write such a program, and the meshes that
// it reads. Knows the scene, not the renderer. The programs stand in assets/programs as programs with all
// that they may need; what a scene does not need is left out (template.h says how).

#include <string>
#include <vector>

#include "models/problem.h"
#include "models/range.h"
#include "models/scene/scene.h"

namespace glint {

enum class Language { Gl1, Glsl, Cpp, Python };

/// One row a language: the word of the command line, and what stands behind it.
constexpr Choice choice_of(Language language) {
    switch (language) {
    case Language::Gl1:
        return {"gl1", "OpenGL 1", "C and the fixed-function calls of OpenGL 1, as a lecture writes them"};
    case Language::Glsl:
        return {"glsl", "GLSL", "C++ and OpenGL 3.3, with the shaders in files of their own"};
    case Language::Cpp:
        return {"cpp", "C++", "one C++17 file without any library"};
    case Language::Python:
        return {"python", "Python", "one Python file with numpy"};
    }
    return {};
}

struct ProgramFile {
    std::string name;  // without a folder
    std::string text;
};

/// A mesh that the program reads: mesh_text() of the object under the scene's mistakes, which can be long.
struct ProgramMesh {
    std::string name;  // of its file
    Object object;
};

struct Program {
    std::vector<ProgramFile> texts;  // the program itself first
    std::vector<ProgramMesh> meshes;
};

/// What the program is of: the scene with its meshes loaded, the picture's size, and the scene's name for the
/// program's first line.
struct ProgramOf {
    const Scene& scene;
    PictureSize size;
    std::string name;
};

/// The languages in which it can be written.
[[nodiscard]] std::vector<Language> languages_for(const ProgramOf& of);

/// The files of a program that draws the scene. Compiled or run as its first comment says, it gives the
/// picture of `glint render`. Problem (without a file): what the language cannot do, or that the program
/// would be too long; `expected` names the languages that can.
[[nodiscard]] Result<Program> write_program(const ProgramOf& of, Language language);

}  // namespace glint
