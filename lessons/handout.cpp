#include "lessons/handout.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "lessons/page.h"
#include "models/io/markup.h"
#include "renderer/image/html_image.h"

namespace glint {
namespace {

constexpr int samples = 4;

/// A number for people.
std::string four_digits(double value) { return fmt::format("{:.4g}", std::abs(value) < 5e-13 ? 0.0 : value); }

std::string answer_text(const Prediction& p, const RightAnswer& right) {
    switch (p.kind) {
    case PredictionKind::Number:
        return four_digits(right.value.get<double>()) + (p.unit.empty() ? "" : " " + p.unit);
    case PredictionKind::Choice:
        return p.options[static_cast<std::size_t>(right.value.get<double>())].text;
    case PredictionKind::Click:
    case PredictionKind::Colour: {
        std::vector<std::string> numbers;
        for (const Json& v : elements_of(right.value)) numbers.push_back(four_digits(v.get<double>()));
        return fmt::format("({})", fmt::join(numbers, ", "));
    }
    case PredictionKind::Sketch:
        return "the curve";
    }
    return {};  // not reached
}

/// Empty axes, 600 x 160; with `values`, their curve.
std::string axes_svg(const Json::array_t& values) {
    std::string svg =
        "<svg width=\"620\" height=\"170\" viewBox=\"0 0 620 170\"><path d=\"M10 5V160H615\" fill=\"none\" "
        "stroke=\"#666\"/>";
    double low = 0, high = 0;
    for (const Json& v : values) {
        low = std::min(low, v.get<double>());
        high = std::max(high, v.get<double>());
    }
    if (values.size() > 1 && high > low) {
        std::string points;
        for (std::size_t i = 0; i < values.size(); ++i)
            points +=
                fmt::format("{:.1f},{:.1f} ",
                            10 + 600.0 * static_cast<double>(i) / static_cast<double>(values.size() - 1),
                            158 - 150 * (values[i].get<double>() - low) / (high - low));
        svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"#b4632a\" stroke-width=\"2\"/>",
                           points);
    }
    return svg + "</svg>\n";
}

class Handout {
  public:
    Handout(LessonRunner& runner, const Lesson& lesson, bool key)
        : runner_(runner), lesson_(lesson), key_(key) {}

    Result<std::string> made() {
        const Result<SceneDocument> opened = runner_.open(lesson_);
        if (const Problem* problem = problem_of(opened)) return *problem;
        html_ += fmt::format("<p class=\"topic\">{}</p>\n<h1>{}</h1>\n", html_escaped(lesson_.topic),
                             html_escaped(lesson_.title));
        for (const LessonStep& step : lesson_.steps)
            if (!add_step(step, std::get<SceneDocument>(opened))) return *problem_;
        return page_html(lesson_.title, html_);
    }

  private:
    /// False if there is a problem.
    template <class T> bool had(const Result<T>& result) {
        if (const Problem* problem = problem_of(result)) problem_ = *problem;
        return !problem_;
    }

    bool add_step(const LessonStep& step, const SceneDocument& opened) {
        if (!step.title.empty()) html_ += fmt::format("<h2>{}</h2>\n", html_escaped(step.title));
        const Result<SceneDocument> set = LessonRunner::with(opened, step.set, lesson_, step.line);
        if (!had(set)) return false;
        document_ = std::get<SceneDocument>(set);
        const Result<SceneDocument> shown = LessonRunner::for_paper(document_, step, lesson_, key_);
        if (!had(shown) || !add_picture(std::get<SceneDocument>(shown), "The scene of this step"))
            return false;
        told_ = true;
        for (const LessonPart& part : step.parts)
            if (!std::visit([this](const auto& p) { return add(p); }, part)) return false;
        return true;
    }

    bool add_picture(const SceneDocument& document, std::string_view alt) {
        if (shown_ && *shown_ == document.scene) return true;
        const Result<Picture> picture = runner_.picture(document, lesson_, handout_size(lesson_), samples);
        if (!had(picture)) return false;
        html_ += html_image(std::get<Picture>(picture), alt) + "\n";
        shown_ = document.scene;
        return true;
    }

    bool add(const std::vector<ProseBlock>& prose) {
        if (told_ || key_) html_ += prose_html(prose);
        return true;
    }

    bool add(const Prediction& p) {
        told_ = true;
        RightAnswer right;
        if (key_) {
            const Result<RightAnswer> found = right_answer(runner_, document_, lesson_, p);
            if (!had(found)) return false;
            right = std::get<RightAnswer>(found);
        }
        html_ += fmt::format("<div class=\"box\"><h3>Predict</h3><p>{}</p>\n", html_escaped(p.question));
        if (p.kind == PredictionKind::Choice) {
            html_ += "<ul class=\"options\">\n";
            for (std::size_t i = 0; i < p.options.size(); ++i) {
                const bool is_right = key_ && right.value == Json(i);
                html_ += fmt::format("<li{}>{} {}</li>\n", is_right ? " class=\"right\"" : "",
                                     is_right ? "☑" : "☐", html_escaped(p.options[i].text));
            }
            html_ += "</ul>\n";
        } else if (p.kind == PredictionKind::Sketch) {
            html_ += axes_svg(elements_of(right.value));
        } else if (key_) {
            html_ += fmt::format("<p class=\"right\">{}</p>\n", html_escaped(answer_text(p, right)));
        } else {
            html_ += fmt::format("<p class=\"answer\">{}</p>\n", html_escaped(p.unit));
        }
        html_ += "</div>\n";
        return true;
    }

    bool add(const Reveal& reveal) {
        told_ = false;
        if (!key_) {
            html_ += "<div class=\"lines\"></div>\n";
            return true;
        }
        const Result<SceneDocument> set = LessonRunner::with(document_, reveal.set, lesson_, reveal.line);
        return had(set) && add_picture(std::get<SceneDocument>(set), "What is revealed");
    }

    bool add(const Task& task) {
        told_ = true;
        html_ += fmt::format("<div class=\"box try\"><h3>Try</h3><p>Drag {}.</p></div>\n",
                             html_escaped(task.drag));
        return true;
    }

    bool add(const Claim& claim) {
        if (key_)
            html_ += fmt::format("<div class=\"box key\"><h3>Checked</h3><p>{}</p></div>\n",
                                 html_escaped(claim.says));
        return true;
    }

    bool add(const Exercise&) { return true; }  // glint exercise prints them

    LessonRunner& runner_;
    const Lesson& lesson_;
    bool key_;
    bool told_ = true;  // whether the next text may be read before the answer
    std::string html_;
    SceneDocument document_;
    std::optional<Scene> shown_;
    std::optional<Problem> problem_;
};

}  // namespace

PictureSize handout_size(const Lesson& lesson) {
    constexpr int least_width = 640;
    const int times = (least_width + lesson.size.width - 1) / lesson.size.width;
    const int fits = std::max(1, max_lesson_side / std::max(lesson.size.width, lesson.size.height));
    const int scale = std::min(times, fits);
    return {lesson.size.width * scale, lesson.size.height * scale};
}

Result<std::string> handout_html(LessonRunner& runner, const Lesson& lesson, bool key) {
    return Handout(runner, lesson, key).made();
}

}  // namespace glint
