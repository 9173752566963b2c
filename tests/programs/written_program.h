#pragma once
// A program that Glint has written, built and run as its first comment says.

#include <string>
#include <vector>

#include "programs/program.h"

namespace glint::programs {

/// What the program drew: of each pixel, from the top left, three bytes and, where it writes them, three
/// floats.
struct Drawn {
    std::string failure;  // what its build or run said; empty where both worked
    std::string text;     // of the program and its shaders
    std::vector<unsigned char> bytes;
    std::vector<float> linear;
};

/// Writes the program into a folder of its own, types the lines `build offscreen:` and `run offscreen:` there
/// (compilers are made strict, and to optimise little), and reads the pictures. Precondition: the language
/// can.
[[nodiscard]] Drawn build_and_run(const ProgramOf& of, Language language);

}  // namespace glint::programs
