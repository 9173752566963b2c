#pragma once
// The calls that draw a scene in fixed-function OpenGL, as in the lecture. Their order matters: a light's
// position set before gluLookAt() moves with the camera; one set after it is fixed in the world. The calls
// are read from the program that `glint code --language gl1` writes, with the program's variables replaced by
// the scene's numbers. Depends on the scene, not on the renderer. Source: OpenGL 2.1, section 2.14; the
// OpenGL utility library's gluLookAt.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// A piece of a call's text: punctuation, or a number of the scene with its pointer.
struct CallPiece {
    std::string text;
    std::string pointer;  // "/lights/0/position/1"; empty: not a number of the scene
    bool operator==(const CallPiece&) const = default;
};

struct GlCall {
    std::vector<CallPiece> pieces;
    std::string about;  // pointer of the value that the call sets: "/lights/0", "/global_ambient"; or empty
    int place_of_light =
        -1;  // the light whose position the call sets, which depends on gluLookAt() before it
    bool is_look_at = false;  // gluLookAt()
    bool is_remark = false;   // a feature that fixed-function OpenGL lacks, and an alternative
};

/// Calls that belong together. `about`: as for a call; empty if the calls set several values.
struct GlCallGroup {
    std::string title, about;
    std::vector<GlCall> calls;
};

/// All calls for the scene's enabled lights and visible objects, without its mistakes. Adds a remark if the
/// scene uses a feature that fixed-function OpenGL lacks: Phong shading, an area light, Phong's reflection.
/// `rgb(r, g, b)` and its product with a number represent arrays of four floats whose alpha is 1. Includes
/// every number of a light and of a material, even if the program can omit it because it is 0 in the entire
/// scene. Ignores meshes.
[[nodiscard]] std::vector<GlCallGroup> gl_calls(const Scene& scene);

/// The call as a one-line statement in C and C++: `rgb()`, and numbers where OpenGL takes an array, are
/// written as an array. It may use `width`, `height` (int) and `mesh` (an array of display lists, one for
/// each object).
[[nodiscard]] std::string call_text(const GlCall& call);
/// The calls as a function in C and C++, with the necessary headers.
[[nodiscard]] std::string calls_text(const std::vector<GlCallGroup>& groups);

// A statement of the program `gl1` as a call with the scene's numbers in place of the program's variables.

/// The meaning of a variable of the program: `count` numbers of the scene at `key`, below the pointer of a
/// light or an object; or only `text`, if `count` is 0.
struct Variable {
    std::string_view name;
    std::string_view key;
    int count = 1;
    std::string_view text = {};
};

/// The numbers of a scene, keyed by their pointers.
using NumbersByPointer = std::map<std::string, float, std::less<>>;

/// The call without its comment or line end: "glEnable(light);". Empty if the line is not a call.
[[nodiscard]] std::string_view statement_of(std::string_view line);

/// Returns `statement` with each variable replaced; the longest match wins. `rgb(factor, ` becomes `factor *
/// rgb(`, and a factor of 1 is omitted. `below`: the pointer that the variables' keys follow. Precondition:
/// the numbers of all variables that occur are known (a test writes the calls of every scene).
[[nodiscard]] GlCall call_of(std::string_view statement, std::span<const Variable> variables,
                             const std::string& below, const NumbersByPointer& numbers);

}  // namespace glint
