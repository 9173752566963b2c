#include "lessons/exercise_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "lessons/page.h"
#include "models/io/markup.h"
#include "models/utf8.h"

namespace glint {
namespace {

/// Writes a number with as many digits as are meaningful within the tolerance.
std::string number_of(const PosedQuestion& q, double number) {
    const int digits = q.tolerance > 0 ? static_cast<int>(std::ceil(-std::log10(q.tolerance))) + 1 : 4;
    return fmt::format("{:.{}f}", std::abs(number) < 1e-12 ? 0 : number, std::min(std::max(digits, 0), 9));
}

/// The answer by the formula, if there is one, because values measured at a pixel have fewer digits. Both
/// answers if they disagree.
std::string answer_text(const PosedQuestion& q) {
    const std::string text = number_of(q, q.closed.value_or(q.answer)) + (q.unit.empty() ? "" : " ") + q.unit;
    return agrees(q) ? text : text + " by the formula, but " + number_of(q, q.answer) + " by the engine";
}

/// Escapes a name such as k_d and subscripts the index (one letter each).
std::string with_indices(std::string_view text) {
    constexpr std::string_view underline = "\\_";
    const auto is_letter = [&text](std::size_t i) {
        return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
    };
    std::string set;
    std::size_t done = 0;
    for (std::size_t at = text.find(underline); at != text.npos; at = text.find(underline, at + 1)) {
        const std::size_t after = at + underline.size();
        const bool one_before = at > 0 && is_letter(at - 1) && !(at > 1 && is_letter(at - 2));
        if (!one_before || !is_letter(after) || is_letter(after + 1)) continue;
        set += text.substr(done, at - done);
        set += fmt::format("\\textsubscript{{{}}}", text[after]);
        done = after + 1;
    }
    return set += text.substr(done);
}

/// Letters and signs that LaTeX's T1 encoding lacks.
std::string latex_text(std::string_view text) {
    constexpr std::array<std::array<std::string_view, 2>, 45> signs{{{"°", "\\textdegree{}"},
                                                                     {"·", "\\textperiodcentered{}"},
                                                                     {"√", "\\ensuremath{\\surd}"},
                                                                     {"²", "\\ensuremath{^2}"},
                                                                     {"ⁿ", "\\ensuremath{^n}"},
                                                                     {"ˢ", "\\ensuremath{^s}"},
                                                                     {"α", "\\ensuremath{\\alpha}"},
                                                                     {"β", "\\ensuremath{\\beta}"},
                                                                     {"γ", "\\ensuremath{\\gamma}"},
                                                                     {"δ", "\\ensuremath{\\delta}"},
                                                                     {"ε", "\\ensuremath{\\varepsilon}"},
                                                                     {"η", "\\ensuremath{\\eta}"},
                                                                     {"λ", "\\ensuremath{\\lambda}"},
                                                                     {"μ", "\\ensuremath{\\mu}"},
                                                                     {"ρ", "\\ensuremath{\\rho}"},
                                                                     {"τ", "\\ensuremath{\\tau}"},
                                                                     {"φ", "\\ensuremath{\\varphi}"},
                                                                     {"ψ", "\\ensuremath{\\psi}"},
                                                                     {"ω", "\\ensuremath{\\omega}"},
                                                                     {"Δ", "\\ensuremath{\\Delta}"},
                                                                     {"Σ", "\\ensuremath{\\Sigma}"},
                                                                     {"Φ", "\\ensuremath{\\Phi}"},
                                                                     {"Ω", "\\ensuremath{\\Omega}"},
                                                                     {"₀", "\\ensuremath{_0}"},
                                                                     {"₁", "\\ensuremath{_1}"},
                                                                     {"₂", "\\ensuremath{_2}"},
                                                                     {"³", "\\ensuremath{^3}"},
                                                                     {"⁴", "\\ensuremath{^4}"},
                                                                     {"∞", "\\ensuremath{\\infty}"},
                                                                     {"→", "\\ensuremath{\\to}"},
                                                                     {"≈", "\\ensuremath{\\approx}"},
                                                                     {"≠", "\\ensuremath{\\ne}"},
                                                                     {"∠", "\\ensuremath{\\angle}"},
                                                                     {"∥", "\\ensuremath{\\parallel}"},
                                                                     {"±", "\\ensuremath{\\pm}"},
                                                                     {"π", "\\ensuremath{\\pi}"},
                                                                     {"θ", "\\ensuremath{\\theta}"},
                                                                     {"σ", "\\ensuremath{\\sigma}"},
                                                                     {"−", "\\ensuremath{-}"},
                                                                     {"×", "\\ensuremath{\\times}"},
                                                                     {"≤", "\\ensuremath{\\le}"},
                                                                     {"≥", "\\ensuremath{\\ge}"},
                                                                     {"…", "\\dots{}"},
                                                                     {"–", "--"},
                                                                     {"½", "\\ensuremath{\\frac12}"}}};
    const std::string escaped = with_indices(latex_escaped(text));
    std::string set;
    for (std::size_t at = 0; at < escaped.size();) {
        const std::string_view letter = first_characters(std::string_view(escaped).substr(at), 1);
        const auto* const found =
            std::find_if(signs.begin(), signs.end(), [&](const auto& sign) { return sign[0] == letter; });
        set += letter.size() == 1 || found == signs.end() ? letter : (*found)[1];
        at += letter.size();
    }
    return set;
}

}  // namespace

Result<std::vector<ExerciseSheet>> exercise_sheets(LessonRunner& runner, const Lesson& lesson,
                                                   std::uint64_t seed, int count) {
    const Result<SceneDocument> opened = runner.open(lesson);
    if (const Problem* problem = problem_of(opened)) return *problem;
    std::vector<ExerciseSheet> sheets;
    for (int i = 0; i < count; ++i) {
        ExerciseSheet sheet{seed + static_cast<std::uint64_t>(i), {}};
        for (const LessonStep& step : lesson.steps) {
            const Result<SceneDocument> set =
                LessonRunner::with(std::get<SceneDocument>(opened), step.set, lesson, step.line);
            if (const Problem* problem = problem_of(set)) return *problem;
            for (const LessonPart& part : step.parts) {
                const auto* exercise = std::get_if<Exercise>(&part);
                if (exercise == nullptr) continue;
                Result<PosedQuestion> posed =
                    pose(runner, std::get<SceneDocument>(set), lesson, *exercise, sheet.seed);
                if (const Problem* problem = problem_of(posed)) return *problem;
                sheet.questions.push_back(std::get<PosedQuestion>(std::move(posed)));
            }
        }
        if (sheet.questions.empty())
            return Problem{lesson.path, "", "the lesson has no exercises", "a block \"exercise\""};
        sheets.push_back(std::move(sheet));
    }
    return sheets;
}

Warnings key_warnings(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets) {
    struct Missed {
        std::size_t count = 0;
        std::string first;
    };
    std::map<int, Missed> missed;  // by the exercise's line
    for (const ExerciseSheet& sheet : sheets)
        for (const PosedQuestion& q : sheet.questions) {
            if (agrees(q)) continue;
            Missed& one = missed[q.line];
            if (one.count++ == 0)
                one.first = fmt::format("sheet {}: {} by the formula, {} by the engine", sheet.seed,
                                        *q.closed, q.answer);
        }
    Warnings warnings;
    for (const auto& [line, one] : missed)
        warnings.push_back(
            fmt::format("{}:{}: the formula misses the engine's answer on {} of {} sheets, first on {}",
                        on_one_line(lesson.path), line, one.count, sheets.size(), one.first));
    return warnings;
}

std::string exercises_html(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets,
                           const std::string& picture) {
    std::string body;
    for (const ExerciseSheet& sheet : sheets) {
        body += fmt::format(
            "<section class=\"paper\"><p class=\"topic\">Sheet {} · {}</p>\n<h1>{}</h1>\n"
            "<p class=\"name\">Name:</p>\n{}\n<ol>\n",
            sheet.seed, html_escaped(lesson.topic), html_escaped(lesson.title), picture);
        for (const PosedQuestion& q : sheet.questions)
            body += fmt::format("<li>{}<p class=\"answer\">{}</p></li>\n", html_escaped(q.question),
                                html_escaped(q.unit));
        body += "</ol></section>\n";
    }
    body += fmt::format(
        "<section class=\"paper\"><h1>Keys: {}</h1>\n<table><tr><th>Sheet</th><th>Answers</th></tr>\n",
        html_escaped(lesson.title));
    for (const ExerciseSheet& sheet : sheets) {
        body += fmt::format("<tr><td>{}</td><td><ol>", sheet.seed);
        for (const PosedQuestion& q : sheet.questions)
            body += fmt::format("<li>{}</li>", html_escaped(answer_text(q)));
        body += "</ol></td></tr>\n";
    }
    body += "</table></section>\n";
    return page_html("Exercises: " + lesson.title, body);
}

std::string exercises_tex(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets) {
    std::string tex;
    tex +=
        "\\documentclass[11pt,a4paper]{article}\n\\usepackage[utf8]{inputenc}\n\\usepackage[T1]{fontenc}\n"
        "\\usepackage{amsmath,textcomp}\n\\setlength{\\parindent}{0pt}\n\\begin{document}\n";
    const std::string title = latex_text(lesson.title);
    for (const ExerciseSheet& sheet : sheets) {
        tex += fmt::format(
            "\\section*{{{}}}\nSheet {}\\hfill Name: \\underline{{\\hspace{{6cm}}}}\n"
            "\\begin{{enumerate}}\n",
            title, sheet.seed);
        for (const PosedQuestion& q : sheet.questions)
            // Without the empty group {}, LaTeX would take a question that begins with "[" as a label instead
            // of its number.
            tex += fmt::format("\\item {{}}{}\\par\\vspace{{2cm}}Answer: \\underline{{\\hspace{{4cm}}}} {}\n",
                               latex_text(q.question), latex_text(q.unit));
        tex += "\\end{enumerate}\n\\newpage\n";
    }
    tex += fmt::format("\\section*{{Keys: {}}}\n", title);
    for (const ExerciseSheet& sheet : sheets) {
        tex += fmt::format("Sheet {}:", sheet.seed);
        for (std::size_t i = 0; i < sheet.questions.size(); ++i)
            tex += fmt::format("\\quad {}. {}", i + 1, latex_text(answer_text(sheet.questions[i])));
        tex += "\\par\n";
    }
    tex += "\\end{document}\n";
    return tex;
}

std::string unset_letters(std::string_view tex) {
    constexpr std::string_view last_set = "\u017F";  // of the letters in T1
    constexpr std::string_view marks = "\u2013\u2014\u2018\u2019\u201C\u201D\u201E";
    constexpr std::size_t most_told = 20;
    std::set<std::string_view> unset;
    std::string told;
    for (std::size_t at = 0; at < tex.size();) {
        const std::string_view letter = first_characters(tex.substr(at), 1);
        const bool is_set = letter.size() < last_set.size() ||
                            (letter.size() == last_set.size() && letter <= last_set) ||
                            marks.find(letter) != marks.npos;
        if (!is_set && unset.insert(letter).second && unset.size() <= most_told) told += letter;
        at += letter.size();
    }
    return unset.size() > most_told ? fmt::format("{} and {} more", told, unset.size() - most_told) : told;
}

}  // namespace glint
