#pragma once
// Changes JSON by its structure, with the words and the numbers that a scene file knows.

#include <random>
#include <string>
#include <string_view>

#include "models/json/json.h"

namespace glint::fuzz {

/// The text with one value replaced, left out, doubled or put elsewhere. Text that is not JSON comes back as
/// it is.
[[nodiscard]] std::string with_changed_json(std::string_view text, std::mt19937& random);

/// A number, a word, a switch, null or something empty, as JSON.
[[nodiscard]] Json random_leaf(std::mt19937& random);

/// What a LLVMFuzzerCustomMutator returns for JSON: half of the time its structure is changed, else its
/// bytes.
[[nodiscard]] std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                      unsigned seed);

}  // namespace glint::fuzz
