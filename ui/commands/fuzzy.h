#pragma once
// Matches what was typed with names: letters in order, side by side or at the beginnings of words. No
// drawing.

#include <optional>
#include <string_view>
#include <vector>

namespace glint {

struct FuzzyMatch {
    int score = 0;           // more is better
    std::vector<int> bytes;  // of `text`, ascending: those that matched, to be shown
};

/// Matches each word of `query` (words are divided by blanks) with `text`. A word must occur in `text` as a
/// subsequence, capitals or not (ASCII only; other bytes match themselves). Its letters must stand side by
/// side, or each must begin a word or continue one whose beginning matched. Letters that begin a word or
/// follow one another score more. Of equal matches, the one in the shorter text scores more. An empty query
/// matches everything with 0.
[[nodiscard]] std::optional<FuzzyMatch> fuzzy_match(std::string_view query, std::string_view text);

/// What fuzzy_match() takes off a match for the length of its text.
inline constexpr int most_for_length = 63;
[[nodiscard]] int off_for_length(std::string_view text);

}  // namespace glint
