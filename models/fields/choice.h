#pragma once
// One member of a closed set, with the words that people see.

#include <string_view>

namespace glint {

struct Choice {
    std::string_view word;     // in the scene file; ends with '\0', as all literals
    const char* label = "";    // in the window
    const char* meaning = "";  // for tooltips, the documentation and the JSON Schema
};

}  // namespace glint
