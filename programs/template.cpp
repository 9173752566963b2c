#include "programs/template.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "models/scene/mistakes.h"

namespace glint {
namespace {

constexpr std::string_view wrong_prefix = "wrong.", calls_word = "calls";

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t at = text.find(separator);
        if (std::string_view part = text.substr(0, at); !part.empty()) parts.push_back(part);
        if (at == text.npos) return parts;
        text.remove_prefix(at + 1);
    }
}

/// A line of a text: the text before its directive, the directive's word, and the rest.
struct Line {
    std::string_view indent, comment;  // comment: "//" or "#"
    std::string_view word, rest;       // word: empty if the line is not a directive
};

Line parsed(std::string_view line) {
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    std::string_view body = line.substr(start);
    for (const std::string_view comment : {std::string_view("//"), std::string_view("#")}) {
        if (!body.starts_with(comment) || body.substr(comment.size(), 1) != "@") continue;
        body.remove_prefix(comment.size() + 1);
        const std::size_t end = std::min(body.find(' '), body.size());
        return {line.substr(0, start), comment, body.substr(0, end),
                body.substr(std::min(end + 1, body.size()))};
    }
    return {};
}

template <class Visit> void for_lines(std::string_view text, const Visit& visit) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1);
        visit(text.substr(0, text[end] == '\n' ? end : end + 1));
        text.remove_prefix(end + 1);
    }
}

bool holds(std::string_view condition, const Flags& on) {
    const auto term_holds = [&on](std::string_view term) {
        const bool negated = term.starts_with('!');
        return (on.find(term.substr(negated ? 1 : 0)) != on.end()) != negated;
    };
    const auto all_hold = [&](std::string_view terms) {
        const auto parts = split(terms, '&');
        return std::all_of(parts.begin(), parts.end(), term_holds);
    };
    const auto parts = split(condition, '|');
    return std::any_of(parts.begin(), parts.end(), all_hold);
}

/// The flags of a condition, negated ones with their "!".
std::vector<std::string_view> terms_of(std::string_view condition) {
    std::vector<std::string_view> all;
    for (const std::string_view part : split(condition, '|'))
        for (const std::string_view term : split(part, '&')) all.push_back(term);
    return all;
}

/// The line with its values. A value of several lines is indented like its placeholder.
std::string with_values(std::string_view line, const Values& values) {
    std::string out;
    while (true) {
        const std::size_t at = line.find('@'), end = line.find('@', at + 1);
        const auto value = end == line.npos ? values.end() : values.find(line.substr(at + 1, end - at - 1));
        if (end == line.npos) return out.append(line);
        out.append(line.substr(0, at));
        if (value != values.end()) {
            out.append(value->second);
            line.remove_prefix(end + 1);
        } else {
            out.append("@");
            line.remove_prefix(at + 1);
        }
    }
}

}  // namespace

Flags mentioned_flags(std::string_view text) {
    Flags flags;
    for_lines(text, [&flags](std::string_view raw) {
        const Line line = parsed(raw);
        if (line.word == "can")
            for (const std::string_view flag : split(line.rest, ' ')) flags.emplace(flag);
        if (line.word != "if") return;
        for (std::string_view term : terms_of(line.rest)) {
            if (term.starts_with('!')) term.remove_prefix(1);
            flags.emplace(term);
        }
    });
    return flags;
}

std::string_view lines_of_calls(std::string_view text, std::string_view name) {
    std::string_view lines;
    bool inside = false;
    for_lines(text, [&](std::string_view raw) {
        const Line line = parsed(raw);
        if (line.word == calls_word) inside = line.rest == name;
        if (!inside || line.word == calls_word) return;
        if (lines.empty()) lines = raw;
        lines = {lines.data(), static_cast<std::size_t>(raw.data() + raw.size() + 1 - lines.data())};
    });
    return lines;
}

std::string mistake_comment(std::string_view name) {
    for (const MistakeName& mistake : mistake_names())
        if (mistake.name == name) return fmt::format("MISTAKE {}: {}", name, mistake.what);
    return {};
}

std::string filled(std::string_view text, const Flags& on, const Values& values) {
    std::string out;
    std::vector<bool> shown{true};  // one for each open condition
    const auto all_shown = [&shown] { return std::find(shown.begin(), shown.end(), false) == shown.end(); };
    for_lines(text, [&](std::string_view raw) {
        const Line line = parsed(raw);
        if (line.word == "can" || line.word == calls_word) return;
        if (line.word == "if") {
            shown.push_back(holds(line.rest, on));
            if (!all_shown()) return;
            for (const std::string_view term : terms_of(line.rest))
                if (term.starts_with(wrong_prefix) && on.find(term) != on.end())
                    out += fmt::format("{}{} {}\n", line.indent, line.comment,
                                       mistake_comment(term.substr(wrong_prefix.size())));
        } else if (line.word == "else") {
            shown.back() = !shown.back();
        } else if (line.word == "end") {
            shown.pop_back();
        } else if (all_shown()) {
            const std::string whole = with_values(raw, values);
            if (whole.empty() && !raw.empty()) return;  // an empty value leaves no line
            out.append(whole).append("\n");
        }
    });
    return out;
}

}  // namespace glint
