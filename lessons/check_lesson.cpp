#include "lessons/check_lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/fields/scene_numbers.h"
#include "models/json/json_pointer.h"

namespace glint {
namespace {

/// Nothing if it holds, else the reason why it does not.
using Shortfall = std::optional<std::string>;

Shortfall text_of(const Problem* problem) {
    if (problem == nullptr) return {};
    return with_expected(problem->what, problem->expected);
}

class Checker {
  public:
    Checker(LessonRunner& runner, const Lesson& lesson, SceneDocument document)
        : runner_(runner), lesson_(lesson), document_(document), tried_on_(std::move(document)) {}

    Shortfall operator()(const Claim& claim) {
        const Result<NamedValues> run = runner_.answers(document_, lesson_, claim.runs);
        if (const Problem* problem = problem_of(run)) return text_of(problem);
        for (const Expression& check : claim.checks)
            if (Shortfall shortfall = unless_holds(check, std::get<NamedValues>(run))) return shortfall;
        return {};
    }

    /// A task after a reveal starts with the reveal's scene, as in the window.
    void follow(const Reveal& reveal) {
        Result<SceneDocument> shown = LessonRunner::with(document_, reveal.set, lesson_, reveal.line);
        if (problem_of(shown) == nullptr) tried_on_ = std::get<SceneDocument>(std::move(shown));
    }

    Shortfall operator()(const Prediction& p) {
        tried_on_ = document_;
        const Result<RightAnswer> right = right_answer(runner_, document_, lesson_, p);
        if (const Problem* problem = problem_of(right)) return text_of(problem);
        const double tolerance = std::get<RightAnswer>(right).tolerance;
        if (p.kind == PredictionKind::Choice) return wrong_mistake(p);
        if (Shortfall wrong = wrong_tolerance(tolerance)) return wrong;
        return wrong_term(p);
    }

    Shortfall operator()(const Task& task) {
        if (task.solution.empty()) return "no solution is given; expected lines solution:";
        if (Shortfall wrong = wrong_control(task, tried_on_.scene)) return wrong;
        Shortfall before = done(task, tried_on_, false);
        if (before) return before;
        const Result<SceneDocument> solved = LessonRunner::with(tried_on_, task.solution, lesson_, task.line);
        if (const Problem* problem = problem_of(solved)) return text_of(problem);
        return done(task, std::get<SceneDocument>(solved), true);
    }

    Shortfall operator()(const Exercise& exercise) {
        for (const std::vector<double>& values : values_to_try(exercise, most_tries(exercise))) {
            const Result<PosedQuestion> posed = pose_with(runner_, document_, lesson_, exercise, values);
            if (const Problem* problem = problem_of(posed)) return text_of(problem);
            const auto& q = std::get<PosedQuestion>(posed);
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

    /// The number of values of an exercise to try, limited by the time of its runs.
    [[nodiscard]] std::size_t most_tries(const Exercise& exercise) const {
        constexpr std::size_t fewest = 8, most = 500, pixels = 4'000'000;
        std::vector<double> first;
        for (const Exercise::Variable& variable : exercise.variables)
            first.push_back(variable.values.front());
        const Result<ExerciseInstance> made = exercise_with(exercise, first, lesson_.path);
        if (problem_of(made) != nullptr) return fewest;  // posing it reports the problem
        std::size_t drawn = 1;
        for (const LessonRun& run : std::get<ExerciseInstance>(made).runs) drawn += pixels_worth(run);
        return std::clamp(pixels / drawn, fewest, most);
    }

    /// The approximate cost of a run, in pixels drawn in the same time.
    [[nodiscard]] std::size_t pixels_worth(const LessonRun& run) const {
        constexpr std::size_t of_ray = 100;
        return run.kind == RunKind::Microfacets ? of_ray * static_cast<std::size_t>(run.rays + run.facets)
                                                : run.size.value_or(lesson_.size).pixels();
    }

    Shortfall unless_holds(const Expression& condition, const NamedValues& values) const {
        const Result<bool> holds = condition.holds(values);
        if (const Problem* problem = problem_of(holds)) return text_of(problem);
        if (std::get<bool>(holds)) return {};
        return condition.text() + " is false: " + condition.with_values(values);
    }

    Shortfall done(const Task& task, const SceneDocument& document, bool expected) {
        const Result<NamedValues> run = runner_.answers(document, lesson_, task.runs);
        if (const Problem* problem = problem_of(run)) return text_of(problem);
        if (expected) return unless_holds(task.done, std::get<NamedValues>(run));
        const Result<bool> holds = task.done.holds(std::get<NamedValues>(run));
        if (const Problem* problem = problem_of(holds)) return text_of(problem);
        if (std::get<bool>(holds)) return "it is done before anything is dragged: " + task.done.text();
        return {};
    }

    /// Checks that an option holds under the mistake that it names.
    Shortfall wrong_mistake(const Prediction& p) {
        for (const LessonOption& option : p.options) {
            if (option.mistake.empty()) continue;
            std::vector<LessonRun> mistaken = p.runs;
            for (LessonRun& run : mistaken)
                run.set.push_back({"/shading/mistakes/" + option.mistake, "true"});
            const Result<NamedValues> run = runner_.answers(document_, lesson_, mistaken);
            if (const Problem* problem = problem_of(run)) return text_of(problem);
            if (Shortfall why = unless_holds(option.is_right, std::get<NamedValues>(run)))
                return option.mistake + " does not show \"" + option.text + "\": " + *why;
        }
        return {};
    }

    /// Checks that the answer's run of `explain` has the field that the window links to.
    Shortfall wrong_term(const Prediction& p) {
        const auto explains = [](const LessonRun& run) { return run.kind == RunKind::Explain; };
        const auto run = std::find_if(p.runs.begin(), p.runs.end(), explains);
        if (p.term.empty()) return {};
        if (run == p.runs.end()) return "term: no run explains a pixel; expected e = explain --pixel X,Y";
        const Result<Expression> field = Expression::parse(run->name + "." + p.term);
        if (const Problem* problem = problem_of(field)) return "term: " + *text_of(problem);
        const Result<NamedValues> values = runner_.answers(document_, lesson_, {*run});
        if (const Problem* problem = problem_of(values)) return text_of(problem);
        const Result<Json> value = std::get<Expression>(field).value(std::get<NamedValues>(values));
        if (const Problem* problem = problem_of(value)) return "term: " + *text_of(problem);
        return {};
    }

    /// Checks that each pointer refers to something that can be moved.
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
    SceneDocument document_, tried_on_;
};

/// The kind, the line and the text of a part that is checked. Nothing for text and reveals.
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

/// The assignments of a reveal must be valid.
std::optional<Problem> wrong_reveal(const Lesson& lesson, const LessonStep& step,
                                    const SceneDocument& document) {
    for (const LessonPart& part : step.parts) {
        const auto* reveal = std::get_if<Reveal>(&part);
        if (reveal == nullptr) continue;
        std::vector<Assignment> set = reveal->set;
        if (!reveal->play.empty())
            for (const double end : {reveal->play_from, reveal->play_to})
                set.push_back({reveal->play, fmt::format("{}", end)});
        const Result<SceneDocument> changed = LessonRunner::with(document, set, lesson, reveal->line);
        if (const Problem* problem = problem_of(changed)) return *problem;
    }
    return {};
}

}  // namespace

const char* name_of(CheckedKind kind) {
    switch (kind) {
    case CheckedKind::Prediction:
        return "prediction";
    case CheckedKind::Task:
        return "task";
    case CheckedKind::Claim:
        return "claim";
    case CheckedKind::Exercise:
        return "exercise";
    }
    return "";  // not reached
}

Result<std::vector<Checked>> check_lesson(LessonRunner& runner, const Lesson& lesson, bool claims_only) {
    const Result<SceneDocument> opened = runner.open(lesson);
    if (const Problem* problem = problem_of(opened)) return *problem;
    std::vector<Checked> all;
    for (const LessonStep& step : lesson.steps) {
        const Result<SceneDocument> set =
            LessonRunner::with(std::get<SceneDocument>(opened), step.set, lesson, step.line);
        if (const Problem* problem = problem_of(set)) return *problem;
        const auto& document = std::get<SceneDocument>(set);
        const Result<SceneDocument> shown = LessonRunner::for_paper(document, step, lesson, false);
        if (const Problem* problem = problem_of(shown)) return *problem;
        if (std::optional<Problem> problem = wrong_reveal(lesson, step, document)) return *problem;
        Checker checker(runner, lesson, document);
        for (const LessonPart& part : step.parts) {
            if (const auto* reveal = std::get_if<Reveal>(&part)) checker.follow(*reveal);
            std::optional<Checked> checked = described(part);
            if (!checked || (claims_only && checked->kind != CheckedKind::Claim)) continue;
            const Shortfall shortfall = std::visit(
                [&checker](const auto& p) -> Shortfall {
                    if constexpr (std::is_invocable_v<Checker&, decltype(p)>) return checker(p);
                    return {};
                },
                part);
            checked->holds = !shortfall;
            checked->why = shortfall.value_or("");
            all.push_back(std::move(*checked));
        }
    }
    return all;
}

}  // namespace glint
