#include "ui/commands/fuzzy.h"

#include <algorithm>
#include <string>

namespace glint {
namespace {

constexpr int per_letter = 8, at_word_start = 12, side_by_side = 16;
constexpr int impossible = -1'000'000;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Whether a typed letter is the one at text[at]; x also where "×" ends there, which no keyboard has.
bool is_typed(char typed, std::string_view text, std::size_t at) {
    if (lower(typed) == lower(text[at])) return true;
    return lower(typed) == 'x' && at > 0 && text.substr(at - 1, 2) == "×";
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || (c & 0x80) != 0;
}

bool starts_word(std::string_view text, std::size_t at) {
    return is_letter(text[at]) && (at == 0 || !is_letter(text[at - 1]));
}

/// Whether the letters occur in that order: most texts are left out so, before anything is laid out.
bool occurs(std::string_view word, std::string_view text) {
    std::size_t next = 0;
    for (std::size_t at = 0; at < text.size() && next < word.size(); ++at)
        next += is_typed(word[next], text, at) ? 1 : 0;
    return next == word.size();
}

/// The best way to lay `word` over `text`: best[i][j] is the score of word[0..i] with word[i] on text[j].
class Alignment {
  public:
    Alignment(std::string_view word, std::string_view text) : word_(word), text_(text) {
        best_.assign(word.size(), std::vector<int>(text.size(), impossible));
        from_.assign(word.size(), std::vector<int>(text.size(), -1));
        for (std::size_t i = 0; i < word.size(); ++i) fill(i);
    }

    /// Nothing where the letters are only strewn over the text.
    std::optional<FuzzyMatch> match() const {
        std::optional<FuzzyMatch> found = best();
        if (found && !holds_together(found->bytes)) found.reset();
        return found;
    }

  private:
    std::optional<FuzzyMatch> best() const {
        const std::vector<int>& last = best_.back();
        const auto best = std::max_element(last.begin(), last.end());
        if (best == last.end() || *best < 0) return {};
        FuzzyMatch found{*best, {}};
        int j = static_cast<int>(best - last.begin());
        for (std::size_t i = word_.size(); i-- > 0; j = from_[i][static_cast<std::size_t>(j)])
            found.bytes.push_back(j);
        std::reverse(found.bytes.begin(), found.bytes.end());
        return found;
    }

    /// Whether the letters stand side by side, or each begins a word or goes on in one whose beginning
    /// matched.
    bool holds_together(const std::vector<int>& bytes) const {
        if (bytes.back() - bytes.front() == static_cast<int>(bytes.size()) - 1) return true;
        bool in_word = false;  // that is, in one whose beginning matched
        int before = -1;
        for (const int at : bytes) {
            in_word =
                starts_word(text_, static_cast<std::size_t>(at)) || (in_word && in_one_word(before, at));
            if (!in_word) return false;
            before = at;
        }
        return true;
    }
    bool in_one_word(int first, int last) const {
        const std::string_view between =
            text_.substr(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
        return std::all_of(between.begin(), between.end(), is_letter);
    }

    void fill(std::size_t i) {
        int before = impossible, before_at = -1;  // the best place of word[i - 1] left of text[j]
        for (std::size_t j = 0; j < text_.size(); ++j) {
            if (i > 0 && j > 0 && best_[i - 1][j - 1] > before) {
                before = best_[i - 1][j - 1];
                before_at = static_cast<int>(j) - 1;
            }
            if (!is_typed(word_[i], text_, j)) continue;
            const int here = per_letter + (starts_word(text_, j) ? at_word_start : 0);
            if (i == 0) {
                best_[i][j] = here;
                continue;
            }
            const int joined = j > 0 ? best_[i - 1][j - 1] + side_by_side : impossible;
            const bool joins = joined >= before;
            from_[i][j] = joins ? static_cast<int>(j) - 1 : before_at;
            const int so_far = joins ? joined : before;
            best_[i][j] = so_far < 0 ? impossible : so_far + here;
        }
    }

    std::string_view word_, text_;
    std::vector<std::vector<int>> best_, from_;
};

}  // namespace

int off_for_length(std::string_view text) {
    return static_cast<int>(std::min<std::size_t>(text.size(), most_for_length));
}

std::optional<FuzzyMatch> fuzzy_match(std::string_view query, std::string_view text) {
    FuzzyMatch whole;
    bool any = false;
    while (!query.empty()) {
        const std::size_t end = std::min(query.find(' '), query.size());
        const std::string_view word = query.substr(0, end);
        query.remove_prefix(std::min(end + 1, query.size()));
        if (word.empty()) continue;
        const auto found = occurs(word, text) ? Alignment(word, text).match() : std::nullopt;
        if (!found) return {};
        whole.score += (most_for_length + 1) * found->score;  // the length only decides between equals
        whole.bytes.insert(whole.bytes.end(), found->bytes.begin(), found->bytes.end());
        any = true;
    }
    std::sort(whole.bytes.begin(), whole.bytes.end());
    whole.bytes.erase(std::unique(whole.bytes.begin(), whole.bytes.end()), whole.bytes.end());
    if (any) whole.score -= off_for_length(text);
    return whole;
}

}  // namespace glint
