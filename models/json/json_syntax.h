#pragma once
// What is wrong with JSON text at the place where a parser stopped, in our words.

#include <string_view>

#include "models/problem.h"

namespace glint {

/// What a parser understood last.
enum class JsonEvent { Nothing, Key, Value, OpenedObject, OpenedArray };
enum class JsonContainer { None, Object, Array };

/// Where a parser stopped.
struct JsonStop {
    std::string_view text;
    std::size_t understood = 0;  // end of what it understood last
    std::size_t reached = 0;     // end of what it looked at
    JsonEvent last = JsonEvent::Nothing;
    JsonContainer container = JsonContainer::None;  // around the place
};

/// Line (from 1), what is wrong and what was expected; the file is left empty.
[[nodiscard]] Problem syntax_problem(const JsonStop& stop);

/// Line of the byte at `place`, from 1.
[[nodiscard]] int line_of(std::string_view text, std::size_t place);

}  // namespace glint
