#pragma once
// Writes a program that draws a scene: text for people learning to write such a program, and the meshes that
// it reads. Depends on the scene, not on the renderer. The templates in assets/programs are complete
// programs; model_text.h omits the parts that a scene does not need.

#include <string>
#include <vector>

#include "models/numbers.h"
#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

enum class Language { Gl1, Glsl, Cpp, Python, Webgl };

/// One row per language: its name on the command line and its title.
constexpr Choice choice_of(Language language) {
    switch (language) {
    case Language::Gl1:
        return {"gl1", "OpenGL 1", "C and the fixed-function calls of OpenGL 1, as taught in lectures"};
    case Language::Glsl:
        return {"glsl", "GLSL", "C++ and OpenGL 3.3, with the shaders in separate files"};
    case Language::Cpp:
        return {"cpp", "C++", "one C++17 file without libraries"};
    case Language::Python:
        return {"python", "Python", "one Python file with numpy"};
    case Language::Webgl:
        return {"webgl", "WebGL", "one page for a browser, with the same shaders as glsl"};
    }
    return {};
}

struct ProgramFile {
    std::string name;  // without a folder
    std::string text;
};

/// A mesh file that the program reads. Its contents, mesh_text() with the scene's mistakes, can be long.
struct ProgramMesh {
    std::string name;  // the name of its file
    Object object;
};

struct Program {
    std::vector<ProgramFile> texts;  // the program itself first
    std::vector<ProgramMesh> meshes;
};

/// The input of the program: the scene with its meshes loaded, the picture's size, and the scene's name for
/// the program's first line.
struct ProgramOf {
    const Scene& scene;
    PictureSize size;
    std::string name;
    bool blank = false;  // GLSL and WebGL only: leaves the lighting equation for the reader to write
};

/// Returns the languages in which the program can be written.
[[nodiscard]] std::vector<Language> languages_for(const ProgramOf& of);

/// The files of a program that draws the scene. Compiled or run according to its first comment, it draws the
/// same picture as `glint render`. Returns a problem (without a file) if the language lacks a feature or the
/// program would be too long; its `expected` names suitable languages.
[[nodiscard]] Result<Program> write_program(const ProgramOf& of, Language language);

/// The shaders of the GLSL program, to be combined with any file in place of lighting.glsl (docs/shader.md),
/// without `#version`. In the stage that computes the lighting, `before` precedes that file and `vertex` or
/// `fragment` follows it; the other stage is complete on its own. The fragment stage also writes `raw`: the
/// colour before exposure, and 1, or 2 if the file evaluated loop_runs() more than max_loop_runs times for
/// this point. If pixels are lit, this stage also writes their position and normal, `raw_p` and `raw_n`.
/// Fails like write_program(), and also if the scene has no reflection model.
struct ShaderStages {
    std::string before, vertex, fragment;
    bool lights_pixels = true;  // the fragment stage computes the lighting
};
[[nodiscard]] Result<ShaderStages> shader_stages(const ProgramOf& of);

/// Mesa's software driver silently ends all loops of a shader after 65,535 iterations.
inline constexpr int max_loop_runs = 60'000;

}  // namespace glint
