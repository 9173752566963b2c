#pragma once
// A statement of the program `gl1` as a call with the scene's numbers in place of the program's variables.

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "programs/gl_calls.h"

namespace glint {

/// The meaning of a variable of the program: `count` numbers of the scene at `key`, below the pointer of a
/// light or an object; or only `text`, if `count` is 0.
struct Variable {
    std::string_view name;
    std::string_view key;
    int count = 1;
    std::string_view text = {};
};

/// The numbers of a scene by their pointers.
using NumbersByPointer = std::map<std::string, float, std::less<>>;

/// The call without comment or line end: "glEnable(light);". Empty if the line is not a call.
[[nodiscard]] std::string_view statement_of(std::string_view line);

/// Returns `statement` with each variable replaced; the longest match wins. `rgb(factor, ` becomes `factor *
/// rgb(`, and a factor of 1 is omitted. `below`: the pointer that the variables' keys follow. Precondition:
/// the numbers of all variables that occur are known (a test writes the calls of every scene).
[[nodiscard]] GlCall call_of(std::string_view statement, std::span<const Variable> variables,
                             const std::string& below, const NumbersByPointer& numbers);

}  // namespace glint
