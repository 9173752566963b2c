#include "lessons/check_lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "models/fields/scene_fields.h"
#include "models/json/json.h"

namespace glint {
namespace {

/// Empty if the check succeeds, otherwise the reason for its failure.
using Shortfall = std::optional<std::string>;

std::string text_of(const Problem& problem) { return with_expected(problem.what, problem.expected); }

/// An exception in a check counts as a failure.
class Checker {
  public:
    Checker(LessonRunner& runner, const Lesson& lesson, StudentPage page)
        : runner_(runner),
          lesson_(lesson),
          page_(std::move(page)),
          document_(page_.document),
          tried_on_(document_) {}

    Shortfall operator()(const Claim& claim) {
        const NamedValues run = value_or_throw(runner_.answers(document_, lesson_, claim.runs));
        for (const Expression& check : claim.checks)
            if (Shortfall shortfall = unless_holds(check, run)) return shortfall;
        return {};
    }

    /// Appends to the page, or starts a new one: a question after a reveal is on a page of its own. Text
    /// after a question belongs to the answer.
    void read(const std::vector<ProseBlock>& text) {
        if (answered_) return;
        for (const ProseBlock& block : text) page_.text += plain_text(block) + '\n';
    }
    void read(const Prediction& question, const Reveal* reveal) {
        if (std::exchange(answered_, false)) page_.text.clear();
        page_.text += question.question + '\n';
        page_.reveal = reveal;
    }

    /// A task after a reveal starts with the reveal's scene, as in the window.
    void follow(const Reveal& reveal) {
        answered_ = true;
        Result<SceneDocument> shown = LessonRunner::with(document_, reveal.set, lesson_, reveal.line);
        if (problem_of(shown) == nullptr) tried_on_ = std::get<SceneDocument>(std::move(shown));
    }

    Shortfall operator()(const Prediction& p) {
        tried_on_ = document_;
        const RightAnswer right = value_or_throw(right_answer(runner_, document_, lesson_, p));
        Shortfall wrong =
            p.kind == PredictionKind::Choice ? wrong_option(p, right) : wrong_tolerance(right.tolerance);
        if (!wrong) wrong = wrong_term(p);
        if (!wrong) wrong = wrong_answers(p, right);
        return wrong ? wrong : value_or_throw(answer_shown(runner_, lesson_, p, right, page_));
    }

    Shortfall operator()(const Task& task) {
        if (task.solution.empty()) return "no solution is given; expected a line solution:";
        if (Shortfall wrong = wrong_control(task, tried_on_.scene)) return wrong;
        Shortfall before = done(task, tried_on_, false);
        if (before) return before;
        return done(task, value_or_throw(LessonRunner::with(tried_on_, task.solution, lesson_, task.line)),
                    true);
    }

    Shortfall operator()(const Exercise& exercise) {
        for (const std::vector<double>& values : values_to_try(exercise, most_tries(exercise))) {
            const PosedQuestion q = value_or_throw(pose_with(runner_, document_, lesson_, exercise, values));
            if (Shortfall wrong = wrong_tolerance(q.tolerance)) return wrong;
            if (!agrees(q))
                return fmt::format("{}: the engine says {}, the formula {}", q.question, q.answer, *q.closed);
        }
        return {};
    }

  private:
    static Shortfall wrong_tolerance(double tolerance) {
        if (tolerance > 0) return {};
        return "the tolerance is " + json_line(tolerance) + "; expected more than 0";
    }

    /// The number of variants of an exercise to try, limited by the cost of its runs.
    [[nodiscard]] std::size_t most_tries(const Exercise& exercise) const {
        constexpr std::size_t fewest = 8, most = 500, pixels = 4'000'000;
        std::vector<double> first;
        for (const Exercise::Variable& variable : exercise.variables)
            first.push_back(variable.values.front());
        const Result<ExerciseInstance> made = exercise_with(exercise, first, lesson_.path);
        if (problem_of(made) != nullptr) return fewest;  // the problem is reported when the exercise is posed
        std::size_t drawn = 1;
        for (const LessonRun& run : std::get<ExerciseInstance>(made).runs) drawn += pixels_worth(run);
        return std::clamp(pixels / drawn, fewest, most);
    }

    /// The approximate cost of a run, as the number of pixels that could be drawn in the same time.
    [[nodiscard]] std::size_t pixels_worth(const LessonRun& run) const {
        constexpr std::size_t of_ray = 100;
        return run.kind == RunKind::Microfacets ? of_ray * static_cast<std::size_t>(run.rays + run.facets)
                                                : run.size.value_or(lesson_.size).pixels();
    }

    Shortfall unless_holds(const Expression& condition, const NamedValues& values) const {
        if (value_or_throw(condition.holds(values))) return {};
        return condition.text() + " is false: " + condition.with_values(values);
    }

    Shortfall done(const Task& task, const SceneDocument& document, bool expected) {
        const NamedValues run = value_or_throw(runner_.answers(document, lesson_, task.runs));
        if (expected) return unless_holds(task.done, run);
        if (value_or_throw(task.done.holds(run)))
            return "the task is done before anything is dragged: " + task.done.text();
        return {};
    }

    /// Checks that the right option names no misconception, and that an option is right when the mistake that
    /// it names is switched on.
    Shortfall wrong_option(const Prediction& p, const RightAnswer& right) {
        const LessonOption& key = p.options[right.value.get<std::size_t>()];
        if (!key.thinks.empty()) return "\"" + key.text + "\" is right, but has a misconception (thinks:)";
        for (const LessonOption& option : p.options) {
            if (option.mistake.empty()) continue;
            std::vector<LessonRun> mistaken = p.runs;
            for (LessonRun& run : mistaken)
                run.set.push_back({"/shading/mistakes/" + option.mistake, "true"});
            const NamedValues run = value_or_throw(runner_.answers(document_, lesson_, mistaken));
            if (Shortfall why = unless_holds(option.is_right, run))
                return option.mistake + " does not show \"" + option.text + "\": " + *why;
        }
        return {};
    }

    /// Checks that each typical wrong answer is graded as wrong and matches only its own misconception.
    static Shortfall wrong_answers(const Prediction& p, const RightAnswer& right) {
        for (std::size_t i = 0; i < right.wrong.size(); ++i)
            if (thought_behind(p, right, right.wrong[i]) != p.wrong[i].thinks)
                return "wrong: " + json_line(right.wrong[i]) +
                       " counts as the right answer or as a different wrong one";
        return {};
    }

    /// Checks that the answer's `explain` run contains the field that the window links to.
    Shortfall wrong_term(const Prediction& p) {
        const auto explains = [](const LessonRun& run) { return run.kind == RunKind::Explain; };
        const auto run = std::find_if(p.runs.begin(), p.runs.end(), explains);
        if (p.term.empty()) return {};
        if (run == p.runs.end()) return "term: no run explains a pixel; expected e = explain --pixel X,Y";
        const Result<Expression> field = Expression::parse(run->name + "." + p.term);
        if (const Problem* problem = problem_of(field)) return "term: " + text_of(*problem);
        const NamedValues values = value_or_throw(runner_.answers(document_, lesson_, {*run}));
        const Result<Json> value = std::get<Expression>(field).value(values);
        if (const Problem* problem = problem_of(value)) return "term: " + text_of(*problem);
        return {};
    }

    /// Checks that each pointer refers to a number of the scene.
    static Shortfall wrong_control(const Task& task, const Scene& scene) {
        const std::vector<SceneNumber> numbers = numbers_of(scene);
        for (const std::string& control : task.controls) {
            const auto is_of = [&](const SceneNumber& n) { return is_within(n.pointer, control); };
            if (std::none_of(numbers.begin(), numbers.end(), is_of))
                return "control: the scene has no number at " + control;
        }
        return {};
    }

    LessonRunner& runner_;
    const Lesson& lesson_;
    StudentPage page_;
    SceneDocument document_, tried_on_;
    bool answered_ = false;  // the text that follows is shown after the answer
};

/// The scenes of all pictures on the student's printed handout.
std::vector<SceneDocument> on_paper(const Lesson& lesson, const SceneDocument& opened) {
    std::vector<SceneDocument> scenes;
    for (const LessonStep& step : lesson.steps) {
        const SceneDocument set = value_or_throw(LessonRunner::with(opened, step.set, lesson, step.line));
        scenes.push_back(value_or_throw(LessonRunner::for_paper(set, step, lesson, false)));
    }
    return scenes;
}

/// The first reveal in `parts` from `at` on, or null.
const Reveal* reveal_after(const std::vector<LessonPart>& parts, const LessonPart& at) {
    for (const LessonPart* part = &at; part != parts.data() + parts.size(); ++part)
        if (const auto* reveal = std::get_if<Reveal>(part)) return reveal;
    return nullptr;
}

/// The kind, line and text of a part to check; nothing for text and reveals.
std::optional<Checked> described(const LessonPart& part) {
    if (const auto* claim = std::get_if<Claim>(&part))
        return Checked{CheckedKind::Claim, claim->line, claim->says, false, {}};
    if (const auto* p = std::get_if<Prediction>(&part))
        return Checked{CheckedKind::Prediction, p->line, p->question, false, {}};
    if (const auto* task = std::get_if<Task>(&part))
        return Checked{CheckedKind::Task, task->line, task->drag, false, {}};
    if (const auto* exercise = std::get_if<Exercise>(&part))
        return Checked{CheckedKind::Exercise, exercise->line, "the exercise", false, {}};
    return {};
}

/// Throws if a reveal contains an invalid assignment.
void require_reveals(const Lesson& lesson, const LessonStep& step, const SceneDocument& document) {
    for (const LessonPart& part : step.parts) {
        const auto* reveal = std::get_if<Reveal>(&part);
        if (reveal == nullptr) continue;
        std::vector<Assignment> set = reveal->set;
        if (!reveal->play.empty())
            for (const double end : {reveal->play_from, reveal->play_to})
                set.push_back({reveal->play, fmt::format("{}", end)});
        (void)value_or_throw(LessonRunner::with(document, set, lesson, reveal->line));
    }
}

Shortfall shortfall_of(Checker& checker, const LessonPart& part) {
    try {
        return std::visit(
            [&checker](const auto& p) -> Shortfall {
                if constexpr (std::is_invocable_v<Checker&, decltype(p)>) return checker(p);
                return {};
            },
            part);
    } catch (const ProblemFound& found) {
        return text_of(found.problem);
    }
}

}  // namespace

const char* name_of(CheckedKind kind) {
    constexpr std::array names{"prediction", "task", "claim", "exercise"};
    return names[static_cast<std::size_t>(kind)];
}

Result<std::vector<Checked>> check_lesson(LessonRunner& runner, const Lesson& lesson, bool claims_only) {
    return result_of(lesson.path, [&] {
        const SceneDocument opened = value_or_throw(runner.open(lesson));
        const std::vector<SceneDocument> paper = on_paper(lesson, opened);
        std::vector<Checked> all;
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            const LessonStep& step = lesson.steps[i];
            const SceneDocument document =
                value_or_throw(LessonRunner::with(opened, step.set, lesson, step.line));
            require_reveals(lesson, step, document);
            Checker checker(runner, lesson,
                            {lesson.title + '\n' + step.title + '\n', document, paper[i], paper, nullptr});
            for (const LessonPart& part : step.parts) {
                if (const auto* text = std::get_if<std::vector<ProseBlock>>(&part)) checker.read(*text);
                if (const auto* p = std::get_if<Prediction>(&part))
                    checker.read(*p, reveal_after(step.parts, part));
                if (const auto* reveal = std::get_if<Reveal>(&part)) checker.follow(*reveal);
                std::optional<Checked> checked = described(part);
                if (!checked || (claims_only && checked->kind != CheckedKind::Claim)) continue;
                const Shortfall shortfall = shortfall_of(checker, part);
                checked->holds = !shortfall;
                checked->why = shortfall.value_or("");
                all.push_back(std::move(*checked));
            }
        }
        return all;
    });
}

// Checks whether a page shows an answer before its question, as a number in the text or in a picture.

namespace {

constexpr int seen_levels = 12;  // the smallest visible difference at a known pixel
constexpr int equal_levels = 2;  // the largest invisible difference
using Shown = std::optional<std::string>;

bool is_figure(char c) { return c >= '0' && c <= '9'; }
bool is_of_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Removes coordinates such as (0, 1, 0) and ranges such as (0–255), which are part of a question.
std::string without_coordinates(std::string_view text) {
    std::string rest;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::size_t end = text[at] == '(' ? text.find_first_of("()", at + 1) : text.npos;
        if (end != text.npos && text[end] == ')' &&
            (text.substr(at, end - at).find(',') != text.npos ||
             text.substr(at, end - at).find("–") != text.npos))
            at = end;
        else
            rest += text[at];
    }
    return rest;
}

/// Reads a number at `at` and advances `at` past it.
double take_number(std::string_view text, std::size_t& at) {
    double value = 0;
    const auto [end, error] =
        std::from_chars(text.data() + at, text.data() + text.size(), value, std::chars_format::fixed);
    at = error == std::errc{} ? static_cast<std::size_t>(end - text.data()) : at + 1;
    return value;
}

/// The pixels that a run reads, starting at the top left.
std::vector<glm::ivec2> pixels_of(const LessonRun& run, PictureSize size) {
    std::vector<glm::ivec2> pixels;
    if (run.kind == RunKind::Explain) return {run.from};
    if (run.kind == RunKind::Profile) {
        const int steps = std::max({std::abs(run.to.x - run.from.x), std::abs(run.to.y - run.from.y), 1});
        for (int i = 0; i <= steps; ++i) pixels.push_back(run.from + (run.to - run.from) * i / steps);
        return pixels;
    }
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) pixels.emplace_back(x, y);
    return pixels;
}

int levels_apart(const Picture& a, const Picture& b, glm::ivec2 at) {
    int apart = 0;
    for (std::size_t c = 0; c < 3; ++c)
        apart = std::max(apart,
                         std::abs(a.rgba[4 * a.pixel(at.x, at.y) + c] - b.rgba[4 * b.pixel(at.x, at.y) + c]));
    return apart;
}

/// Whether both pictures show the same objects from the same camera; lights may differ.
bool same_view(const Scene& a, const Scene& b) {
    const auto same = [](const Object& x, const Object& y) {
        return x.source == y.source && x.transform == y.transform && x.visible == y.visible;
    };
    return a.camera == b.camera &&
           std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(), same);
}

/// Whether a condition or an answer is computed from brightness, which a picture shows (it does not show
/// n·l).
bool reads_picture(const Prediction& question) {
    constexpr std::array<std::string_view, 10> members{
        ".sum",           ".displayed", ".byte", ".intensity", "_difference",
        ".shaded_pixels", ".max_error", ".rmse", ".diffuse",   ".specular"};
    const auto reads = [&](const Expression& e) {
        return std::any_of(members.begin(), members.end(),
                           [&](std::string_view m) { return e.text().find(m) != std::string::npos; });
    };
    return reads(question.answer) || std::any_of(question.options.begin(), question.options.end(),
                                                 [&](const LessonOption& o) { return reads(o.is_right); });
}

/// Compares the pictures of a page with the pictures drawn by a question's runs.
class Looker {
  public:
    Looker(LessonRunner& runner, const Lesson& lesson, const Prediction& question, const RightAnswer& right,
           const StudentPage& page)
        : runner_(runner),
          lesson_(lesson),
          question_(question),
          right_(right),
          page_(page),
          asked_(drawn(page.asked)) {}

    Shown found() const {
        switch (question_.kind) {
        case PredictionKind::Click:
            return click();
        case PredictionKind::Sketch:
            return sketch();
        case PredictionKind::Colour:
            return colour();
        case PredictionKind::Number:
        case PredictionKind::Choice:
            break;
        }
        return reads_picture(question_) ? all_runs() : Shown{};
    }

  private:
    Picture drawn(const SceneDocument& document) const {
        return value_or_throw(runner_.picture(document, lesson_, lesson_.size, 1));
    }
    SceneDocument set(const std::vector<Assignment>& assignments, int line) const {
        return value_or_throw(LessonRunner::with(page_.document, assignments, lesson_, line));
    }

    /// The reveal must change the picture at the answer.
    Shown click() const {
        if (page_.reveal == nullptr) return {};
        const Picture shown = drawn(set(page_.reveal->set, page_.reveal->line));
        const Json::array_t& answer = elements_of(right_.value);
        const glm::dvec2 at{answer[0].get<double>(), answer[1].get<double>()};
        int apart = 0;
        for (int y = 0; y < shown.size.height; ++y)
            for (int x = 0; x < shown.size.width; ++x)
                if (glm::length(glm::dvec2(x, y) - at) <= right_.tolerance)
                    apart = std::max(apart, levels_apart(asked_, shown, {x, y}));
        if (apart >= seen_levels) return {};
        return fmt::format(
            "the picture shows the position ({:.0f}, {:.0f}): it changes by only {} levels there", at.x, at.y,
            apart);
    }

    /// The brightness along the line must not match the expected curve, even scaled and shifted.
    Shown sketch() const {
        LessonRun line;
        line.kind = RunKind::Profile;
        line.from = question_.from;
        line.to = question_.to;
        const std::vector<glm::ivec2> pixels = pixels_of(line, lesson_.size);
        const Json::array_t& curve = elements_of(right_.value);
        const auto n = static_cast<double>(std::min(pixels.size(), curve.size()));
        double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
        for (std::size_t i = 0; i < std::min(pixels.size(), curve.size()); ++i) {
            const std::size_t p = 4 * asked_.pixel(pixels[i].x, pixels[i].y);
            const double shown = (asked_.rgba[p] + asked_.rgba[p + 1] + asked_.rgba[p + 2]) / 765.0,
                         asked = curve[i].get<double>();
            x += shown / n, y += asked / n, xx += shown * shown / n, xy += shown * asked / n,
                yy += asked * asked / n;
        }
        const double spread = xx - x * x, shared = std::max(xy - x * y, 0.0);
        const double left = yy - y * y - (spread > 1e-9 ? shared * shared / spread : 0);
        if (std::sqrt(std::max(left, 0.0)) > right_.tolerance) return {};
        return "the picture shows the curve: its brightness along the line, scaled, is the answer";
    }

    /// The picture must not show the answer's colour at the pixel that the question is about.
    Shown colour() const {
        const auto run = std::find_if(question_.runs.begin(), question_.runs.end(),
                                      [](const LessonRun& r) { return r.kind == RunKind::Explain; });
        if (run == question_.runs.end()) return {};
        const std::size_t p = 4 * asked_.pixel(run->from.x, run->from.y);
        const Json shown{asked_.rgba[p] / 255.0, asked_.rgba[p + 1] / 255.0, asked_.rgba[p + 2] / 255.0};
        if (how_far(question_.kind, shown, right_.value) > right_.tolerance) return {};
        return fmt::format("the picture shows the colour at {},{}", run->from.x, run->from.y);
    }

    /// The page shows the answer if each picture from which it is computed is visible somewhere.
    Shown all_runs() const {
        bool any = false;
        for (const LessonRun& run : question_.runs) {
            const bool draws =
                run.kind == RunKind::Explain || run.kind == RunKind::Profile || run.kind == RunKind::Render;
            if (!draws) continue;
            if (run.size && !(*run.size == lesson_.size)) return {};
            any = true;
            const SceneDocument of_run = set(run.set, run.line);
            const Picture picture = drawn(of_run);
            const auto shows = [&](const SceneDocument& document) {
                // A picture before a change does not show that the change has no effect.
                if (!run.set.empty()) return same_description(document.scene, of_run.scene);
                if (!same_view(document.scene, of_run.scene)) return false;
                const Picture shown = drawn(document);
                const std::vector<glm::ivec2> pixels = pixels_of(run, lesson_.size);
                return std::all_of(pixels.begin(), pixels.end(), [&](glm::ivec2 at) {
                    return levels_apart(shown, picture, at) <= equal_levels;
                });
            };
            if (!shows(page_.asked) && std::none_of(page_.paper.begin(), page_.paper.end(), shows)) return {};
        }
        if (!any) return {};
        return "the pictures show the answer: everything that its runs read is visible on the page";
    }

    LessonRunner& runner_;
    const Lesson& lesson_;
    const Prediction& question_;
    const RightAnswer& right_;
    const StudentPage& page_;
    Picture asked_;
};

/// Searches the text before the answer for the number or the right option.
Shown in_text(const Prediction& question, const RightAnswer& right, const std::string& text) {
    if (question.kind == PredictionKind::Choice) {
        const std::string& option =
            question.options[static_cast<std::size_t>(right.value.get<double>())].text;
        const bool is_sentence = std::count(option.begin(), option.end(), ' ') >= 2;
        if (is_sentence && text.find(option) != std::string::npos) return "the text says \"" + option + "\"";
        return {};
    }
    if (question.kind != PredictionKind::Number) return {};
    const double answer = right.value.get<double>();
    for (const double number : numbers_in(text, question.unit.find("degree") != std::string::npos))
        if (std::abs(number - answer) <= right.tolerance)
            return fmt::format("the text says {:.4g}, and the answer is {:.4g}", number, answer);
    return {};
}

}  // namespace

std::vector<double> numbers_in(std::string_view all, bool angles) {
    constexpr std::array<std::pair<std::string_view, double>, 7> names{{{"½", 0.5},
                                                                        {"¼", 0.25},
                                                                        {"⅓", 1.0 / 3},
                                                                        {"a half", 0.5},
                                                                        {"a quarter", 0.25},
                                                                        {"a third", 1.0 / 3},
                                                                        {"twice", 2}}};
    const std::string rest = without_coordinates(all);
    const std::string_view text = rest;
    std::vector<double> numbers;
    if (!angles)
        for (const auto& [name, value] : names)
            if (text.find(name) != text.npos) numbers.push_back(value);
    for (std::size_t at = 0; at < text.size();) {
        if (!is_figure(text[at])) {
            ++at;
            continue;
        }
        if (at > 0 && is_of_word(text[at - 1])) {  // a name such as x2
            while (at < text.size() && is_figure(text[at])) ++at;
            continue;
        }
        const std::string_view before = text.substr(0, at);
        const bool is_bound = before.ends_with("= ") || before.ends_with("≤ ") || before.ends_with("> ");
        const bool negative = before.ends_with("-") || before.ends_with("−");
        double value = take_number(text, at);
        if (text.substr(at).starts_with('/') && at + 1 < text.size() && is_figure(text[at + 1]))
            value /= take_number(text, ++at);
        if (negative) value = -value;
        const std::string_view after = text.substr(at);
        const bool is_angle = after.starts_with("°") || after.starts_with(" degree");
        if (value == 0 && is_bound) continue;  // part of a condition such as n·l = 0
        if (is_angle == angles) numbers.push_back(value);
        if (after.starts_with(" %") || after.starts_with("%")) numbers.push_back(value / 100);
    }
    return numbers;
}

Result<Shown> answer_shown(LessonRunner& runner, const Lesson& lesson, const Prediction& question,
                           const RightAnswer& right, const StudentPage& page) {
    if (Shown found = in_text(question, right, page.text)) return found;
    return result_of("", [&] { return Looker(runner, lesson, question, right, page).found(); });
}

}  // namespace glint
