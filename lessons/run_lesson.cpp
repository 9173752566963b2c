#include "lessons/run_lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/io/file.h"
#include "models/json/json.h"
#include "models/memory_limit.h"
#include "renderer/answers/answers.h"
#include "renderer/explain/equation_text.h"

namespace glint {
namespace {

/// Converts a command-line problem to a problem with a line of the lesson.
Problem in_lesson(Problem problem, const Lesson& lesson, int line) {
    if (problem.file.empty() || problem.file == "--set") {
        problem.file = lesson.path;
        problem.line = line;
    }
    return problem;
}

Problem problem_at(const Lesson& lesson, int line, std::string what, std::string expected) {
    return {lesson.path, "", std::move(what), std::move(expected), line};
}

bool is_inside(glm::ivec2 p, PictureSize size) {
    return p.x >= 0 && p.y >= 0 && p.x < size.width && p.y < size.height;
}

/// Returns a problem if the run names a pixel outside its picture.
std::optional<Problem> outside(const Lesson& lesson, const LessonRun& run, PictureSize size) {
    const bool asks = run.kind == RunKind::Explain || run.kind == RunKind::Profile;
    if (!asks || (is_inside(run.from, size) && (run.kind == RunKind::Explain || is_inside(run.to, size))))
        return {};
    return problem_at(lesson, run.line, "a pixel is outside the picture",
                      fmt::format("0 to {}, 0 to {}", size.width - 1, size.height - 1));
}

Result<Json> lobe_answer(const Scene& scene, const Lesson& lesson, const LessonRun& run) {
    const auto number = static_cast<std::size_t>(run.object);
    if (number >= scene.objects.size())
        return problem_at(lesson, run.line, "the scene has no object " + std::to_string(number),
                          std::to_string(scene.objects.size()) + " objects, counted from 0");
    const Object& object = scene.objects[number];
    const Reflector reflector = reflector_of(object.material, scene.shading);
    return lobe_json(reflector, object.name, run.angle_deg, lobe_slice(reflector, run.angle_deg, 180));
}

MicrofacetOptions microfacets_of(const LessonRun& run) {
    MicrofacetOptions options;
    options.roughness = run.roughness;
    options.light_deg = run.angle_deg;
    options.view_deg = run.view_deg.value_or(run.angle_deg);
    options.rays = run.rays;
    options.facets = run.facets;
    return options;
}

std::vector<double> numbers_of(const Json& value) {
    std::vector<double> numbers;
    for (const Json& element : elements_of(value)) numbers.push_back(element.get<double>());
    return numbers;
}

}  // namespace

Result<SceneDocument> LessonRunner::open(const Lesson& lesson) {
    if (opened_.path != lesson.scene || opened_.path.empty()) {
        if (const auto missing = why_not_there(lesson.scene, "a scene that can be read"))
            return Problem{lesson.path, "", fmt::format("its scene {}: {}", lesson.scene, missing->what),
                           missing->expected};
        Result<SceneDocument> opened = open_document(lesson.scene);
        if (problem_of(opened) != nullptr) return opened;
        opened_ = std::get<SceneDocument>(std::move(opened));
    }
    return opened_;
}

Result<SceneDocument> LessonRunner::with(const SceneDocument& document, const std::vector<Assignment>& set,
                                         const Lesson& lesson, int line) {
    if (set.empty()) return document;
    Result<Scene> scene = scene_variant(document, set);
    if (const Problem* problem = problem_of(scene)) return in_lesson(*problem, lesson, line);
    SceneDocument changed = document;
    changed.scene = std::get<Scene>(std::move(scene));
    return changed;
}

Result<SceneDocument> LessonRunner::for_paper(const SceneDocument& document, const LessonStep& step,
                                              const Lesson& lesson, bool key) {
    return key ? document : with(document, step.picture, lesson, step.line);
}

Result<Json> LessonRunner::answer(const SceneDocument& document, const Lesson& lesson, const LessonRun& run,
                                  NamedPictures& pictures) {
    const PictureSize size = run.size.value_or(lesson.size);
    if (std::optional<Problem> problem = outside(lesson, run, size)) return *problem;
    std::vector<Assignment> set = run.set;
    set.insert(set.end(), always_.begin(), always_.end());
    const Result<SceneDocument> changed = with(document, set, lesson, run.line);
    if (const Problem* problem = problem_of(changed)) return *problem;
    const Scene& scene = std::get<SceneDocument>(changed).scene;
    switch (run.kind) {
    case RunKind::Explain:
        (void)renderer_.render(scene, size);
        return explanation_json(renderer_.explain(run.from.x, run.from.y));
    case RunKind::Render:
        pictures[run.name] = renderer_.render(scene, size);
        return stats_json(renderer_, size);
    case RunKind::Profile: {
        const Picture& picture = renderer_.render(scene, size, true);
        return profile_json(profile(renderer_, picture, run.from, run.to));
    }
    case RunKind::Info:
        return info_json(scene, size);
    case RunKind::Lobe:
        return lobe_answer(scene, lesson, run);
    case RunKind::Microfacets:
        return microfacets_answer(microfacets_of(run));
    case RunKind::Compare:
        break;
    }
    const Result<Comparison> compared = compare(pictures[run.first], pictures[run.second]);
    if (const Problem* problem = problem_of(compared)) return in_lesson(*problem, lesson, run.line);
    return comparison_json(std::get<Comparison>(compared));
}

const Json& LessonRunner::microfacets_answer(const MicrofacetOptions& options) {
    constexpr std::size_t kept = 8;  // more than any lesson uses
    const auto known = std::find_if(microfacets_.begin(), microfacets_.end(),
                                    [&](const auto& one) { return one.options == options; });
    if (known != microfacets_.end()) return known->answer;
    if (microfacets_.size() == kept) microfacets_.clear();
    microfacets_.push_back({options, microfacets_json(options)});
    return microfacets_.back().answer;
}

Result<NamedValues> LessonRunner::answers(const SceneDocument& document, const Lesson& lesson,
                                          const std::vector<LessonRun>& runs) {
    NamedValues values;
    NamedPictures pictures;
    for (const LessonRun& run : runs) {
        try {
            Result<Json> answered = answer(document, lesson, run, pictures);
            if (const Problem* problem = problem_of(answered)) return *problem;
            values[run.name] = std::get<Json>(std::move(answered));
        } catch (const LimitExceeded& exceeded) {
            return in_lesson(exceeded.problem(), lesson, run.line);
        }
    }
    return values;
}

Result<Picture> LessonRunner::picture(const SceneDocument& document, const Lesson& lesson, PictureSize size,
                                      int samples) {
    const Result<SceneDocument> changed = with(document, always_, lesson, 0);
    if (const Problem* problem = problem_of(changed)) return *problem;
    return renderer_.render(std::get<SceneDocument>(changed).scene, size, false, samples);
}

namespace {

/// Describes the expected form of the answer to a question of this kind, if `value` has a different form.
std::optional<std::string> form_missed(const Prediction& p, const Json& value, PictureSize size) {
    const auto is_number = [](const Json& v) { return v.is_number() && std::isfinite(v.get<double>()); };
    if (p.kind == PredictionKind::Number) return is_number(value) ? std::nullopt : std::optional("a number");
    const int along = std::max(std::abs(p.to.x - p.from.x), std::abs(p.to.y - p.from.y)) + 1;
    const int count = p.kind == PredictionKind::Click ? 2 : p.kind == PredictionKind::Colour ? 3 : along;
    const Json::array_t& list = elements_of(value);
    if (std::ssize(list) != count || !std::all_of(list.begin(), list.end(), is_number))
        return fmt::format("a list of {} numbers", count);
    const auto is_shown = [](const Json& v) { return v.get<double>() >= 0 && v.get<double>() <= 1; };
    if (p.kind == PredictionKind::Colour && !std::all_of(list.begin(), list.end(), is_shown))
        return "three numbers from 0 to 1, as a picture shows them";
    if (p.kind != PredictionKind::Click) return std::nullopt;
    const double x = list[0].get<double>(), y = list[1].get<double>();
    if (x < 0 || y < 0 || x >= size.width || y >= size.height)
        return fmt::format("a pixel of {}x{}", size.width, size.height);
    return std::nullopt;
}

}  // namespace

Result<RightAnswer> right_answer(LessonRunner& runner, const SceneDocument& document, const Lesson& lesson,
                                 const Prediction& p) {
    return result_of("", [&] {
        const NamedValues values = value_or_throw(runner.answers(document, lesson, p.runs));
        const auto found = [&](auto result, int line) {
            if (const Problem* problem = problem_of(result))
                throw ProblemFound(in_lesson(*problem, lesson, line));
            return std::get<0>(std::move(result));
        };
        const auto answer = [&](const Expression& expression, int line) {
            Json value = found(expression.value(values), line);
            if (const auto form = form_missed(p, value, lesson.size))
                throw ProblemFound(
                    problem_at(lesson, line, "the answer is " + shortened(json_line(value)), *form));
            return value;
        };
        if (p.kind != PredictionKind::Choice) {
            RightAnswer right{answer(p.answer, p.line), found(p.tolerance.number(values), p.line), {}};
            for (const TypicalWrong& wrong : p.wrong) right.wrong.push_back(answer(wrong.answer, wrong.line));
            return right;
        }
        std::optional<std::size_t> right;
        for (std::size_t i = 0; i < p.options.size(); ++i) {
            if (!found(p.options[i].is_right.holds(values), p.options[i].line)) continue;
            if (right)
                throw ProblemFound(problem_at(lesson, p.options[i].line, "a second option is right", "one"));
            right = i;
        }
        if (!right)
            throw ProblemFound(problem_at(lesson, p.line, "no option is right", "one whose condition holds"));
        return RightAnswer{Json(*right), 0, {}};
    });
}

std::string thought_behind(const Prediction& question, const RightAnswer& right, const Json& given) {
    if (question.kind == PredictionKind::Choice)
        return given == right.value ? ""
                                    : question.options[static_cast<std::size_t>(given.get<double>())].thinks;
    if (how_far(question.kind, given, right.value) <= right.tolerance) return {};
    // Matches clicks and colours to a misconception less strictly than numbers.
    const double reach = question.kind == PredictionKind::Click    ? 2
                         : question.kind == PredictionKind::Colour ? 4
                                                                   : 1;
    for (std::size_t i = 0; i < right.wrong.size(); ++i)
        if (how_far(question.kind, given, right.wrong[i]) <= reach * right.tolerance)
            return question.wrong[i].thinks;
    return {};
}

double how_far(PredictionKind kind, const Json& given, const Json& right) {
    if (kind == PredictionKind::Number) return std::abs(given.get<double>() - right.get<double>());
    if (kind == PredictionKind::Choice) return given == right ? 0 : 1;
    const std::vector<double> a = numbers_of(given), b = numbers_of(right);
    double largest = 0, squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = std::abs(a[i] - b[i]);
        largest = std::max(largest, difference);
        squares += difference * difference;
    }
    if (kind == PredictionKind::Colour) return largest;
    return std::sqrt(kind == PredictionKind::Click || a.empty() ? squares
                                                                : squares / static_cast<double>(a.size()));
}

}  // namespace glint
