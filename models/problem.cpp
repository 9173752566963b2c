#include "models/problem.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>

#include "models/utf8.h"

namespace glint {
namespace {

// A line on standard error has at most 4096 bytes, including `glint: warning: ` and the newline.
constexpr std::size_t text_limit = 4096 - 32;
// No part is truncated to less than this, so that a hostile file name cannot hide the expected text.
constexpr std::size_t part_minimum = text_limit / 4 - 8;
constexpr std::string_view ellipsis = "…";

std::string escaped(std::string_view bytes) {
    if (bytes == "\n") return "\\n";
    if (bytes == "\t") return "\\t";
    if (bytes == "\r") return "\\r";
    std::string text;
    for (const char c : bytes) text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    return text;
}

/// `raw` as valid UTF-8 without control characters, in at most `limit` bytes; an ellipsis marks truncation.
std::string printable(std::string_view raw, std::size_t limit) {
    std::string text;
    std::size_t safe = 0;  // bytes of `text` that leave room for the ellipsis
    for (std::size_t i = 0; i < raw.size();) {
        const std::size_t length = utf8_length(raw.substr(i, 4));
        const std::string_view character = raw.substr(i, std::max<std::size_t>(length, 1));
        text += length == 0 || is_control(character) ? escaped(character) : std::string(character);
        if (text.size() > limit) return text.substr(0, safe).append(ellipsis);
        if (text.size() + ellipsis.size() <= limit) safe = text.size();
        i += character.size();
    }
    return text;
}

/// Makes each part printable and truncates the parts, the first ones first, to `limit` bytes in total.
template <std::size_t N> void shorten(std::array<std::string*, N> parts, std::size_t limit) {
    std::size_t total = 0;
    for (std::string* part : parts) total += (*part = printable(*part, text_limit)).size();
    for (std::string* part : parts) {
        if (total <= limit) return;
        const std::size_t over = total - limit, size = part->size();
        *part = printable(*part, std::max(part_minimum, size - std::min(size, over)));
        total -= size - std::min(size, part->size());
    }
}

/// The cost of the edits (insert, drop, replace, swap two neighbours) that change a to b. `differ` decides
/// whether two characters are different. Source: optimal string alignment, after F. Damerau, CACM 7(3), 1964.
template <class Differ> std::size_t edits(std::string_view a, std::string_view b, Differ differ) {
    std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(before, above);
        std::swap(above, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replace = above[j - 1] + (differ(a[i - 1], b[j - 1]) ? 1 : 0);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, replace});
            const bool swapped = i > 1 && j > 1 && !differ(a[i - 1], b[j - 2]) && !differ(a[i - 2], b[j - 1]);
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

int lower(char c) { return std::tolower(static_cast<unsigned char>(c)); }

}  // namespace

std::string Problem::text() const {
    std::string place = file, at = pointer, wrong = what, wanted = expected;
    const std::string line_text = line > 0 ? fmt::format(":{}", line) : "";
    shorten<4>({&wrong, &at, &place, &wanted}, text_limit - line_text.size() - 8);
    std::string text = place + line_text;
    const auto append = [&text](std::string_view separator, const std::string& part) {
        if (part.empty()) return;
        if (!text.empty()) text += separator;
        text += part;
    };
    append(": ", at);
    append(": ", with_expected(wrong, wanted));
    return text;
}

std::string with_expected(const std::string& what, const std::string& expected) {
    if (expected.empty()) return what;
    return what + (what.empty() ? "" : "; ") + "expected " + expected;
}

std::string on_one_line(std::string_view raw) {
    return printable(raw, 4 * raw.size());  // an escape takes at most four characters per byte
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
    word = word.substr(0, 64);  // longer than any of our names; the rest only costs time
    std::string best;
    auto least = std::pair(std::string::npos, std::string::npos);
    for (const std::string& candidate : candidates) {
        std::pair distance(edits(word, candidate, [](char a, char b) { return lower(a) != lower(b); }),
                           edits(word, candidate, [](char a, char b) { return a != b; }));
        // The beginning of a long name is at most one edit away from that name, regardless of how many
        // letters are missing.
        if (!word.empty() && candidate.starts_with(word))
            distance.first = std::min(distance.first, std::size_t{1});
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

std::string shortened(std::string_view text, std::size_t max) {
    const std::string_view kept = first_characters(text, max);
    return std::string(kept) + (kept.size() < text.size() ? "…" : "");
}

std::string in_quotes(std::string_view text) { return fmt::format("\"{}\"", shortened(text)); }

int line_of(std::string_view text, std::size_t place) {
    const std::string_view before = text.substr(0, place);
    return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

void warn(Warnings& warnings, std::size_t count, std::string_view one, std::string_view many) {
    if (count > 0) warnings.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
}

void WarningList::add(const std::string& line) {
    if (known_.insert(std::hash<std::string>()(line)).second && first_.size() < max_lines)
        first_.push_back(line);
}

Warnings WarningList::take() {
    warn(first_, known_.size() - first_.size(), "more warning of this kind", "more warnings of this kind");
    known_.clear();
    return std::exchange(first_, {});
}

}  // namespace glint
