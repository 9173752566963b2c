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

/// Each word of `query` (blanks divide them) must occur in `text` as a subsequence, capitals or not (ASCII
/// only; other bytes match themselves), whose letters stand side by side, or each begins a word or goes on in
/// one whose beginning matched. Letters that begin a word or follow one another count more; of equal matches
/// in a shorter and a longer text the shorter is better. An empty query matches everything with 0.
[[nodiscard]] std::optional<FuzzyMatch> fuzzy_match(std::string_view query, std::string_view text);

/// What fuzzy_match() takes off a match for the length of its text.
inline constexpr int most_for_length = 63;
[[nodiscard]] int off_for_length(std::string_view text);

}  // namespace glint
