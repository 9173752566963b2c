#pragma once
// Matches a typed search with names. No drawing.

#include <optional>
#include <string>
#include <string_view>

namespace glint {

/// How well `text` fits `name`; lower is better: 0 if they are the same, 1 if the name begins with the text,
/// 2 if a word of the name does, 3 if the name contains it, 4 if its letters occur in that order, the first
/// at the beginning of a word. Otherwise each word of the text must fit by itself, and the worst rank counts.
/// Nothing if one does not fit. Ignores case of ASCII letters; '-' and '_' match blanks. Only the first 100
/// bytes of the text count.
[[nodiscard]] std::optional<int> match_rank(std::string_view text, std::string_view name);

/// A name as spelled in files and commands, "spot-cone" or "lit_in_srgb", with blanks.
[[nodiscard]] std::string with_spaces(std::string_view name);

}  // namespace glint
