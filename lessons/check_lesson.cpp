#include "lessons/check_lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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
            return "it is done before anything is dragged: " + task.done.text();
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

}  // namespace glint
