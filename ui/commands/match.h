#pragma once
// Matches what was typed into a search with names. No drawing.

#include <optional>
#include <string>
#include <string_view>

namespace glint {

/// How well `text` fits `name`; less is better: 0 if they are the same, 1 if the name begins with the text, 2
/// if a word of the name does, 3 if the name contains it, 4 if its letters occur in that order, the first at
/// the beginning of a word. Otherwise each word of the text must fit by itself, and the worst one counts.
/// Nothing where one does not. ASCII capitals match small letters; '-' and '_' match blanks. Of a long text
/// only the first 100 bytes count.
[[nodiscard]] std::optional<int> match_rank(std::string_view text, std::string_view name);

/// A name as files and commands write it, "spot-cone" or "lit_in_srgb", with blanks.
[[nodiscard]] std::string with_spaces(std::string_view name);

}  // namespace glint
