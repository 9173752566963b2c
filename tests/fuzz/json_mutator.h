#pragma once
// Mutates the structure of JSON, with the words and numbers of scene files.

#include <random>
#include <string>
#include <string_view>

#include "models/json/json.h"

namespace glint::fuzz {

/// The text with one value replaced, left out, duplicated or moved. Text that is not JSON is returned
/// unchanged.
[[nodiscard]] std::string with_changed_json(std::string_view text, std::mt19937& random);

/// Random JSON: a number, a list of numbers, a word, true or false, null, or an empty list or object.
[[nodiscard]] Json random_leaf(std::mt19937& random);

/// The result of an LLVMFuzzerCustomMutator for JSON: half of the time its structure is changed, otherwise
/// its bytes.
[[nodiscard]] std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                      unsigned seed);

}  // namespace glint::fuzz
