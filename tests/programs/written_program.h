#pragma once
// A program written by Glint, built and run as described in its first comment.

#include <string>
#include <vector>

#include "programs/program.h"

namespace glint::programs {

/// The program's output: for each pixel, from the top left, three bytes and, if it writes them, three floats.
struct Drawn {
    std::string failure;  // the output of its build or run; empty if both worked
    std::string text;     // of the program and its shaders
    std::vector<unsigned char> bytes;
    std::vector<float> linear;
};

/// Writes the program into its own folder, runs its lines `build offscreen:` and `run offscreen:` there (with
/// strict warnings and low optimisation), and reads the pictures. Precondition: the language supports the
/// scene.
[[nodiscard]] Drawn build_and_run(const ProgramOf& of, Language language);

}  // namespace glint::programs
