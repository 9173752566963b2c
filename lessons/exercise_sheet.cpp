#include "lessons/exercise_sheet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

#include "lessons/handout.h"
#include "lessons/lesson_source.h"
#include "models/utf8.h"
#include "renderer/image/image_file.h"

namespace glint {
namespace {

/// Formats a number with as many digits as the tolerance makes meaningful.
std::string number_of(const PosedQuestion& q, double number) {
    const int digits = q.tolerance > 0 ? static_cast<int>(std::ceil(-std::log10(q.tolerance))) + 1 : 4;
    return fmt::format("{:.{}f}", std::abs(number) < 1e-12 ? 0 : number, std::min(std::max(digits, 0), 9));
}

/// Prefers the result of the formula, because values measured at a pixel have fewer digits. Includes
/// both results if they disagree.
std::string answer_text(const PosedQuestion& q) {
    const std::string text = number_of(q, q.closed.value_or(q.answer)) + (q.unit.empty() ? "" : " ") + q.unit;
    return agrees(q) ? text : text + " by the formula, but " + number_of(q, q.answer) + " by the engine";
}

std::string accepted_text(const PosedQuestion& q) {
    const double right = q.closed.value_or(q.answer);
    return number_of(q, right - q.tolerance) + " to " + number_of(q, right + q.tolerance);
}

constexpr float paper_grey = 0.9f;  // background of printed pictures, light enough to use little toner

/// The exposure factor, 1 to 4, that prints everything in front of the background as middle grey on average.
float print_exposure(const Picture& picture) {
    constexpr double wanted = 0.45, most = 4;
    constexpr int paper_level = 225;
    double sum = 0, count = 0;
    for (std::size_t p = 0; p + 3 < picture.rgba.size(); p += 4) {
        const auto* const pixel = &picture.rgba[p];
        if (pixel[0] == pixel[1] && pixel[1] == pixel[2] && pixel[0] >= paper_level) continue;
        sum += (picture.rgba[p] + picture.rgba[p + 1] + picture.rgba[p + 2]) / 765.0;
        ++count;
    }
    return count == 0 || sum == 0 ? 1 : static_cast<float>(std::clamp(wanted * count / sum, 1.0, most));
}

/// Replaces characters that LaTeX's T1 encoding lacks.
std::string latex_text(std::string_view text) {
    // Pairs of a character and its command, in mathematics and in text.
    static const std::vector<std::string> math = words_of(
        "√ \\surd ² ^2 ⁿ ^n ˢ ^s α \\alpha β \\beta γ \\gamma δ \\delta ε \\varepsilon η \\eta λ \\lambda μ "
        "\\mu ρ \\rho τ \\tau φ \\varphi ψ \\psi ω \\omega Δ \\Delta Σ \\Sigma Φ \\Phi Ω \\Omega ₀ _0 ₁ _1 ₂ "
        "_2 ³ ^3 ⁴ ^4 ∞ \\infty → \\to ≈ \\approx ≠ \\ne ∠ \\angle ∥ \\parallel ± \\pm π \\pi θ \\theta σ "
        "\\sigma − - × \\times ≤ \\le ≥ \\ge ½ \\frac12");
    static const std::vector<std::string> plain =
        words_of("° \\textdegree{} · \\textperiodcentered{} … \\dots{} – --");
    const auto command = [](const std::vector<std::string>& pairs, std::string_view letter) {
        const auto found = std::find(pairs.begin(), pairs.end(), letter);
        return found == pairs.end() ? std::string() : *(found + 1);
    };
    const std::string escaped = with_indices(latex_escaped(text), "\\_", "{0}\\textsubscript{{{1}}}");
    std::string set;
    for (std::size_t at = 0; at < escaped.size();) {
        const std::string_view letter = first_characters(std::string_view(escaped).substr(at), 1);
        const std::string in_math = command(math, letter), in_text = command(plain, letter);
        if (letter.size() == 1 || (in_math.empty() && in_text.empty()))
            set += letter;
        else
            set += in_math.empty() ? in_text : "\\ensuremath{" + in_math + "}";
        at += letter.size();
    }
    return set;
}

}  // namespace

Result<std::vector<ExerciseSheet>> exercise_sheets(LessonRunner& runner, const Lesson& lesson,
                                                   std::uint64_t seed, int count) {
    return result_of(lesson.path, [&] {
        const SceneDocument opened = value_or_throw(runner.open(lesson));
        std::vector<ExerciseSheet> sheets;
        for (int i = 0; i < count; ++i) {
            ExerciseSheet sheet{seed + static_cast<std::uint64_t>(i), {}};
            for (const LessonStep& step : lesson.steps) {
                const SceneDocument set =
                    value_or_throw(LessonRunner::with(opened, step.set, lesson, step.line));
                for (const LessonPart& part : step.parts)
                    if (const auto* exercise = std::get_if<Exercise>(&part))
                        sheet.questions.push_back(value_or_throw(
                            pose_with(runner, set, lesson, *exercise, drawn_values(*exercise, sheet.seed))));
            }
            if (sheet.questions.empty())
                throw ProblemFound({lesson.path, "", "the lesson has no exercises", "a block \"exercise\""});
            sheets.push_back(std::move(sheet));
        }
        return sheets;
    });
}

Warnings key_warnings(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets) {
    struct Missed {
        std::size_t count = 0;
        std::string first;
    };
    std::map<int, Missed> missed;  // by the exercise's line number
    for (const ExerciseSheet& sheet : sheets)
        for (const PosedQuestion& q : sheet.questions) {
            if (agrees(q)) continue;
            Missed& one = missed[q.line];
            if (one.count++ == 0)
                one.first = fmt::format("sheet {}: {} by the formula, {} by the engine", sheet.seed,
                                        *q.closed, q.answer);
        }
    Warnings warnings;
    for (const LessonStep& step : lesson.steps)
        for (const LessonPart& part : step.parts) {
            const auto* exercise = std::get_if<Exercise>(&part);
            if (exercise == nullptr) continue;
            std::size_t variants = 1;
            for (const Exercise::Variable& variable : exercise->variables) variants *= variable.values.size();
            if (variants < sheets.size())
                warnings.push_back(fmt::format(
                    "{}:{}: the exercise has {} variants for {} sheets: some sheets repeat a variant",
                    on_one_line(lesson.path), exercise->line, variants, sheets.size()));
        }
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
            sheet.seed, lesson_html(lesson.topic), lesson_html(lesson.title), picture);
        for (const PosedQuestion& q : sheet.questions)
            body += fmt::format(
                "<li>{}<div class=\"room\"></div><p class=\"answer\">{} <small>(within "
                "{:.2g})</small></p></li>\n",
                lesson_html(q.question), lesson_html(q.unit), q.tolerance);
        body += "</ol></section>\n";
    }
    return page_html("Exercises: " + lesson.title, body);
}

std::string exercise_keys_html(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets) {
    std::string body = fmt::format("<h1>Keys: {}</h1>\n", lesson_html(lesson.title));
    for (const ExerciseSheet& sheet : sheets) {
        body += fmt::format("<h2>Sheet {}</h2>\n<ol>\n", sheet.seed);
        for (const PosedQuestion& q : sheet.questions) {
            body += fmt::format("<li>{}<br>{}", lesson_html(q.question),
                                lesson_html(fmt::format("{}", fmt::join(q.working, " = "))));
            body += fmt::format("<br><strong>{}</strong> <small>(accept {})</small></li>\n",
                                lesson_html(answer_text(q)), accepted_text(q));
        }
        body += "</ol>\n";
    }
    return page_html("Keys: " + lesson.title, body);
}

namespace {

std::string tex_document(const std::string& body) {
    return "\\documentclass[11pt,a4paper]{article}\n\\usepackage[utf8]{inputenc}\n\\usepackage[T1]{fontenc}\n"
           "\\usepackage{amsmath,textcomp}\n\\setlength{\\parindent}{0pt}\n\\begin{document}\n" +
           body + "\\end{document}\n";
}

}  // namespace

std::string exercises_tex(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets) {
    std::string tex;
    for (const ExerciseSheet& sheet : sheets) {
        tex += fmt::format(
            "\\section*{{{}}}\nSheet {}\\hfill Name: \\underline{{\\hspace{{6cm}}}}\n"
            "\\begin{{enumerate}}\n",
            latex_text(lesson.title), sheet.seed);
        for (const PosedQuestion& q : sheet.questions)
            // Without the empty group {}, LaTeX would treat a question that begins with "[" as the item's
            // label.
            tex += fmt::format(
                "\\item {{}}{}\\par\\vspace{{2cm}}Answer: \\underline{{\\hspace{{4cm}}}} {} (within "
                "{:.2g})\n",
                latex_text(q.question), latex_text(q.unit), q.tolerance);
        tex += "\\end{enumerate}\n\\newpage\n";
    }
    return tex_document(tex);
}

std::string exercise_keys_tex(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets) {
    std::string tex = fmt::format("\\section*{{Keys: {}}}\n", latex_text(lesson.title));
    for (const ExerciseSheet& sheet : sheets) {
        tex += fmt::format("\\subsection*{{Sheet {}}}\n\\begin{{enumerate}}\n", sheet.seed);
        for (const PosedQuestion& q : sheet.questions)
            tex += fmt::format("\\item {{}}{} \\\\ \\textbf{{{}}} (accept {})\n",
                               latex_text(fmt::format("{}", fmt::join(q.working, " = "))),
                               latex_text(answer_text(q)), latex_text(accepted_text(q)));
        tex += "\\end{enumerate}\n";
    }
    return tex_document(tex);
}

Result<std::string> sheet_picture(LessonRunner& runner, const Lesson& lesson) {
    return result_of(lesson.path, [&] {
        const LessonStep& step = lesson.steps.front();
        const SceneDocument set = value_or_throw(
            LessonRunner::with(value_or_throw(runner.open(lesson)), step.set, lesson, step.line));
        SceneDocument shown = value_or_throw(LessonRunner::for_paper(set, step, lesson, false));
        shown.scene.display.background = glm::vec3(paper_grey);
        shown.scene.display.exposure *=
            print_exposure(value_or_throw(runner.picture(shown, lesson, lesson.size, 1)));
        const Picture picture = value_or_throw(runner.picture(shown, lesson, handout_size(lesson), 4));
        return html_image(picture, alternative_text(step, shown.scene));
    });
}

std::vector<ExportedQuestion> sheet_questions(const std::vector<ExerciseSheet>& sheets) {
    std::vector<ExportedQuestion> questions;
    for (const ExerciseSheet& sheet : sheets)
        for (const PosedQuestion& q : sheet.questions)
            questions.push_back(
                {.title = fmt::format("Sheet {}, question {}", sheet.seed, &q - sheet.questions.data() + 1),
                 .text = q.question,
                 .picture = {},
                 .alt = {},
                 .options = {},
                 .answer = q.closed.value_or(q.answer),
                 .tolerance = q.tolerance,
                 .unit = q.unit,
                 .feedback = fmt::format("{}", fmt::join(q.working, " = "))});
    return questions;
}

std::string unset_letters(std::string_view tex) {
    constexpr std::string_view last_set = "\u017F";  // the last letter in T1
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

namespace {

/// SplitMix64. Source: G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", 2014.
std::uint64_t next_random(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

Problem in_exercise(Problem problem, const Lesson& lesson, const Exercise& exercise) {
    if (problem.file.empty()) {
        problem.file = lesson.path;
        problem.line = exercise.line;
    }
    return problem;
}

bool in_name(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

// Writes −3 as ~3 in a working, because parentheses mark the parts that have not been computed yet.
std::string as_atom(double value) { return fmt::format("{}{:.5g}", value < 0 ? "~" : "", std::abs(value)); }
std::string without_atoms(const std::string& text, std::string_view minus) {
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] != '~') {
            plain += text[at++];
            continue;
        }
        const std::size_t end = std::min(text.find_first_not_of("0123456789.e", at + 1), text.size());
        plain += fmt::format("({}{})", minus, text.substr(at + 1, end - at - 1));
        at = end;
    }
    return plain;
}

/// Substitutes the values of the variables.
std::string with_numbers(const std::string& formula, const NamedValues& values) {
    std::string text;
    for (std::size_t at = 0; at < formula.size();) {
        std::size_t end = at;
        while (end < formula.size() && in_name(formula[end])) ++end;
        const std::string name = formula.substr(at, std::max<std::size_t>(end - at, 1));
        const auto value = values.find(name);
        text += value == values.end() ? name : as_atom(value->second.get<double>());
        at += name.size();
    }
    return text;
}

/// Evaluates the innermost parentheses and the function in front of them. Returns the text unchanged if there
/// are none.
std::string reduced(const std::string& formula) {
    std::string text;
    for (std::size_t at = 0; at < formula.size();) {
        std::size_t open = at;
        while (open < formula.size() && in_name(formula[open])) ++open;
        const bool opens = open < formula.size() && formula[open] == '(';
        const std::size_t end = opens ? formula.find_first_of("()", open + 1) : std::string::npos;
        const bool is_innermost = end != std::string::npos && formula[end] == ')';
        const std::string part =
            formula.substr(at, is_innermost ? end + 1 - at : std::max<std::size_t>(open - at, 1));
        const Result<Expression> parsed = Expression::parse(without_atoms(part, "-"));
        const Result<double> value = is_innermost && problem_of(parsed) == nullptr
                                         ? std::get<Expression>(parsed).number({})
                                         : Result<double>(Problem{});
        text += problem_of(value) == nullptr ? as_atom(std::get<double>(value)) : part;
        at += part.size();
    }
    return text;
}

/// Converts operators to mathematical symbols.
std::string in_signs(const std::string& working) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> signs{
        {{" * ", " · "}, {"sqrt(", "√("}, {" ^ 2", "²"}, {"-", "−"}, {"pi()", "π"}}};
    std::string text = without_atoms(working, "-");
    for (const auto& [from, to] : signs)
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    return text;
}

std::vector<std::string> working_of(const std::string& formula, const NamedValues& values) {
    constexpr std::size_t most_lines = 8;
    std::string text = with_numbers(formula, values);
    std::vector<std::string> lines{in_signs(formula), in_signs(text)};
    for (std::string next = reduced(text); next != text && lines.size() < most_lines; next = reduced(text)) {
        text = next;
        lines.push_back(in_signs(text));
    }
    return lines;
}

/// All combinations of values, at most the given number.
std::vector<std::vector<double>> drawn_values(const std::vector<Exercise::Variable>& variables,
                                              std::size_t most) {
    std::vector<std::vector<double>> all{{}};
    for (const Exercise::Variable& variable : variables) {
        std::vector<std::vector<double>> longer;
        for (const double value : variable.values)
            for (std::vector<double> values : all) {
                if (longer.size() == most) break;
                values.push_back(value);
                longer.push_back(std::move(values));
            }
        all = std::move(longer);
    }
    return all;
}

}  // namespace

/// Steps through all combinations with a stride that is coprime to their number.
std::vector<double> drawn_values(const Exercise& exercise, std::uint64_t seed) {
    constexpr double golden = 0.6180339887;  // makes successive sheets differ as much as possible
    std::uint64_t count = 1, state = static_cast<std::uint64_t>(exercise.line);
    for (const Exercise::Variable& variable : exercise.variables) count *= variable.values.size();
    auto stride = static_cast<std::uint64_t>(golden * static_cast<double>(count)) + 1;
    while (std::gcd(stride, count) != 1) ++stride;
    std::uint64_t index = (next_random(state) % count + seed % count * stride) % count;
    std::vector<double> drawn;
    for (const Exercise::Variable& variable : exercise.variables) {
        drawn.push_back(variable.values[index % variable.values.size()]);
        index /= variable.values.size();
    }
    return drawn;
}

bool agrees(const PosedQuestion& posed) {
    return !posed.closed || std::abs(*posed.closed - posed.answer) <= posed.tolerance;  // false for NaN
}

std::vector<std::vector<double>> values_to_try(const Exercise& exercise, std::size_t most) {
    std::vector<std::vector<double>> tries = drawn_values(exercise.variables, most + 1);
    if (tries.size() <= most) return tries;
    std::vector<Exercise::Variable> ends = exercise.variables;
    for (Exercise::Variable& variable : ends)
        if (variable.values.size() > 2) variable.values = {variable.values.front(), variable.values.back()};
    tries = drawn_values(ends, most / 2);
    for (std::uint64_t seed = 1; tries.size() < most; ++seed) tries.push_back(drawn_values(exercise, seed));
    return tries;
}

Result<PosedQuestion> pose_with(LessonRunner& runner, const SceneDocument& document, const Lesson& lesson,
                                const Exercise& exercise, const std::vector<double>& chosen) {
    return result_of("", [&] {
        const ExerciseInstance instance = value_or_throw(exercise_with(exercise, chosen, lesson.path));
        const SceneDocument set =
            value_or_throw(LessonRunner::with(document, instance.set, lesson, exercise.line));
        NamedValues values = value_or_throw(runner.answers(set, lesson, instance.runs));
        values.insert(instance.values.begin(), instance.values.end());
        const auto number = [&](const Expression& expression) {
            const Result<double> found = expression.number(values);
            if (const Problem* problem = problem_of(found))
                throw ProblemFound(in_exercise(*problem, lesson, exercise));
            return std::get<double>(found);
        };
        PosedQuestion posed{
            instance.question, instance.unit, number(instance.answer), number(instance.tolerance), {},
            exercise.line};
        if (!instance.closed.text().empty()) {
            posed.closed = number(instance.closed);
            posed.working = working_of(instance.closed.text(), instance.values);
        }
        return posed;
    });
}

}  // namespace glint
