#pragma once
// Matches typed search text against names. Does not draw.

#include <optional>
#include <string>
#include <string_view>

namespace glint {

/// Returns the rank of a match between `text` and `name`; lower is better: 0 if they are equal, 1 if the name
/// begins with the text, 2 if a word of the name does, 3 if the name contains it, 4 if the text's letters
/// occur in that order and the first of them begins a word. Otherwise each word of the text is matched by
/// itself, and the worst rank counts. Returns nullopt if a word does not match. Ignores the case of ASCII
/// letters; '-' and '_' match spaces. Only the first 100 bytes of the text count.
[[nodiscard]] std::optional<int> match_rank(std::string_view text, std::string_view name);

/// Replaces the separators in a name from a file or a command by spaces: "lit_in_srgb" becomes "lit in sRGB".
[[nodiscard]] std::string with_spaces(std::string_view name);

}  // namespace glint
