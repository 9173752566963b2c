#include "ui/commands/match.h"

#include <algorithm>
#include <utility>

namespace glint {
namespace {

constexpr std::size_t longest_search = 100;
constexpr int same = 0, at_start = 1, at_word = 2, inside = 3, in_order = 4;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string folded(std::string_view text) {
    std::string plain = with_spaces(text);
    std::transform(plain.begin(), plain.end(), plain.begin(), lower);
    // British and American spellings match each other, even while the word is still being typed.
    constexpr std::pair<std::string_view, std::string_view> spellings[] = {
        {"colou", "colo"}, {"grey", "gray"}, {"alis", "aliz"}, {"centre", "center"}};
    for (const auto& [british, american] : spellings)
        for (std::size_t at = plain.find(british); at != plain.npos; at = plain.find(british))
            plain.replace(at, british.size(), american);
    return plain;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80) != 0; }

bool occurs_in_order(std::string_view letters, std::string_view name) {
    for (const char c : name) {
        if (letters.empty()) break;
        if (c == letters.front()) letters.remove_prefix(1);
    }
    return letters.empty();
}

/// Precondition: both texts are folded.
std::optional<int> rank_of(std::string_view text, std::string_view name) {
    if (name == text) return same;
    if (name.starts_with(text)) return at_start;
    bool occurs = false;
    for (std::size_t at = 0; at < name.size(); ++at) {
        if (!is_letter(name[at]) || (at > 0 && is_letter(name[at - 1]))) continue;  // not the start of a word
        const std::string_view rest = name.substr(at);
        if (rest.starts_with(text)) return at_word;
        occurs = occurs || (rest.front() == text.front() && occurs_in_order(text, rest));
    }
    if (name.find(text) != name.npos) return inside;
    return occurs ? std::optional(in_order) : std::nullopt;
}

}  // namespace

std::string with_spaces(std::string_view name) {
    std::string words(name);
    std::replace_if(
        words.begin(), words.end(), [](char c) { return c == '-' || c == '_'; }, ' ');
    for (const std::string_view word : {"sRGB", "NaN", "Phong"}) {
        std::string small(word);
        std::transform(small.begin(), small.end(), small.begin(), lower);
        const auto is_end = [&](std::size_t at) { return at >= words.size() || !is_letter(words[at]); };
        for (std::size_t at = words.find(small); at != words.npos; at = words.find(small, at + 1))
            if (is_end(at - 1) && is_end(at + word.size())) words.replace(at, word.size(), word);
    }
    return words;
}

std::optional<int> match_rank(std::string_view text, std::string_view name) {
    const std::string wanted = folded(text.substr(0, longest_search)), in = folded(name);
    const std::optional<int> whole = rank_of(wanted, in);
    if (whole && *whole < in_order) return whole;
    int worst = same;
    for (std::string_view rest = wanted; !rest.empty();) {
        const std::string_view word = rest.substr(0, rest.find(' '));
        rest.remove_prefix(std::min(word.size() + 1, rest.size()));
        if (word.empty()) continue;
        const std::optional<int> rank = rank_of(word, in);
        if (!rank) return whole;
        worst = std::max(worst, *rank);
    }
    return worst;
}

}  // namespace glint
