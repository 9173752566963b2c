#pragma once
// The calls by which fixed-function OpenGL draws a scene, as the lecture writes them, in the order that
// matters: a light's place given before gluLookAt() stays with the camera, after it with the world. They are
// those of the program that `glint code --language gl1` writes, read from its text, with the scene's numbers
// in place of its variables. Knows the scene, not the renderer. Source: OpenGL 2.1, section 2.14; the OpenGL
// utility library's gluLookAt.

#include <string>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// A piece of a call's text: punctuation, or a number of the scene with its place.
struct CallPiece {
    std::string text;
    std::string pointer;  // "/lights/0/position/1"; empty: no number of the scene
    bool operator==(const CallPiece&) const = default;
};

struct GlCall {
    std::vector<CallPiece> pieces;
    std::string about;        // pointer of what it sets, "/lights/0", "/global_ambient"; or empty
    int place_of_light = -1;  // the light whose place it sets: whether gluLookAt() comes before it counts
    bool is_look_at = false;  // gluLookAt()
    bool is_remark = false;   // what fixed-function OpenGL cannot do, and what can
};

/// Calls that belong together; `about` as of a call, empty where it is of several things.
struct GlCallGroup {
    std::string title, about;
    std::vector<GlCall> calls;
};

/// All calls for the scene's lights that are on and objects that can be seen, without its mistakes, and with
/// them a remark where the scene asks for more than fixed-function OpenGL has: Phong shading, an area light,
/// Phong's reflection. `rgb(r, g, b)` and its product with a number stand for arrays of four floats whose
/// alpha is 1. Every number of a light and of a material stands there, also where the program can leave it
/// out as it is 0 in the whole scene. Meshes are not looked at.
[[nodiscard]] std::vector<GlCallGroup> gl_calls(const Scene& scene);

/// The call as a statement of C and of C++ in one line: `rgb()`, and numbers where OpenGL takes an array, are
/// written as an array. It may name `width`, `height` (int) and `mesh` (an array of display lists, one for
/// each object).
[[nodiscard]] std::string call_text(const GlCall& call);
/// The calls as a function of C and of C++, with the headers that it needs.
[[nodiscard]] std::string calls_text(const std::vector<GlCallGroup>& groups);

}  // namespace glint
