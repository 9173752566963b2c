#include "lessons/handout.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "models/utf8.h"
#include "renderer/image/image_file.h"

namespace glint {
namespace {

constexpr int samples = 4;

/// Formats a number for display.
std::string four_digits(double value) { return fmt::format("{:.4g}", std::abs(value) < 5e-13 ? 0.0 : value); }

std::string answer_text(const Prediction& p, const Json& value) {
    switch (p.kind) {
    case PredictionKind::Number:
        return four_digits(value.get<double>()) + (p.unit.empty() ? "" : " " + p.unit);
    case PredictionKind::Choice:
        return p.options[static_cast<std::size_t>(value.get<double>())].text;
    case PredictionKind::Click:
    case PredictionKind::Colour: {
        std::vector<std::string> numbers;
        for (const Json& v : elements_of(value)) numbers.push_back(four_digits(v.get<double>()));
        return fmt::format("({})", fmt::join(numbers, ", "));
    }
    case PredictionKind::Sketch:
        return "the curve";
    }
    return {};  // unreachable
}

/// Draws axes labelled A and B, from 0 to 1 or to the largest value. If there are `values`, also draws their
/// curve and a tolerance band around it.
std::string axes_svg(const Json::array_t& values, double tolerance) {
    constexpr double left = 30, width = 580, bottom = 158, height = 150;
    double high = 1;
    for (const Json& v : values) high = std::max(high, v.get<double>());
    std::string svg = fmt::format(
        "<svg role=\"img\" aria-label=\"Axes for the sketch\" width=\"620\" height=\"180\" viewBox=\"0 0 620 "
        "180\">"
        "<path d=\"M30 5V158H612\" fill=\"none\" stroke=\"#666\"/><text x=\"28\" y=\"176\">A</text><text "
        "x=\"600\" y=\"176\">B</text><text x=\"8\" y=\"160\">0</text><text x=\"0\" y=\"14\">{:.2g}</text>",
        high);
    std::string points;
    for (std::size_t i = 0; i < values.size(); ++i)
        points += fmt::format("{:.1f},{:.1f} ",
                              left + width * static_cast<double>(i) / static_cast<double>(values.size() - 1),
                              bottom - height * values[i].get<double>() / high);
    for (const double thick : {2 * tolerance * height / high, 2.0})
        if (values.size() > 1)
            svg += fmt::format(
                "<polyline points=\"{}\" fill=\"none\" stroke=\"#b4632a\" stroke-width=\"{:.1f}\" "
                "stroke-opacity=\"{}\"/>",
                points, thick, thick > 2 ? 0.2 : 1.0);
    return svg + "</svg>\n";
}

class Handout {
  public:
    Handout(LessonRunner& runner, const Lesson& lesson, PageKind kind)
        : runner_(runner), lesson_(lesson), kind_(kind), key_(kind != PageKind::Student) {}

    std::string made() {
        const SceneDocument opened = value_or_throw(runner_.open(lesson_));
        begin_slide();
        html_ += fmt::format("<p class=\"topic\">{}</p>\n<h1>{}</h1>\n", lesson_html(lesson_.topic),
                             lesson_html(lesson_.title));
        if (kind_ == PageKind::Student) html_ += "<p class=\"name\">Name:</p>\n";
        if (kind_ == PageKind::Instructor) add(lesson_.teaching);
        for (const LessonStep& step : lesson_.steps) add_step(step, opened);
        if (kind_ != PageKind::Slides) return page_html(lesson_.title, html_);
        return page_html(lesson_.title, html_ + "</section>\n" + std::string(turning));
    }

  private:
    /// Moves between slides by key or click.
    static constexpr std::string_view turning = R"JS(<script>
const slides = [...document.querySelectorAll(".slide")];
let shown = 0;
const turn = n => {
  shown = Math.min(Math.max(n, 0), slides.length - 1);
  slides.forEach((s, i) => s.hidden = i !== shown);
};
addEventListener("keydown", e => {
  if (["ArrowRight", "ArrowDown", "PageDown", " ", "Enter"].includes(e.key)) turn(shown + 1);
  if (["ArrowLeft", "ArrowUp", "PageUp"].includes(e.key)) turn(shown - 1);
  if (e.key === "Home") turn(0);
});
addEventListener("click", () => turn(shown + 1));
addEventListener("beforeprint", () => slides.forEach(s => s.hidden = false));
turn(0);
</script>
)JS";

    void begin_slide(const std::string& title = {}) {
        if (kind_ != PageKind::Slides) return;
        html_ += fmt::format("{}<section class=\"slide\">\n", html_.empty() ? "" : "</section>\n");
        if (!title.empty()) html_ += fmt::format("<h2>{}</h2>\n", lesson_html(title));
        shown_.reset();
    }

    void add_step(const LessonStep& step, const SceneDocument& opened) {
        step_ = &step;
        if (!step.title.empty() && kind_ == PageKind::Slides) begin_slide(step.title);
        if (!step.title.empty() && kind_ != PageKind::Slides)
            html_ += fmt::format("<h2>{}</h2>\n", lesson_html(step.title));
        document_ = value_or_throw(LessonRunner::with(opened, step.set, lesson_, step.line));
        asked_ = value_or_throw(LessonRunner::for_paper(document_, step, lesson_, kind_ == PageKind::Key));
        add_picture(asked_);
        told_ = fresh_ = true;
        for (const LessonPart& part : step.parts) std::visit([this](const auto& p) { add(p); }, part);
    }

    void add_picture(const SceneDocument& document) {
        if (kind_ == PageKind::Instructor || (shown_ && *shown_ == document.scene)) return;
        const Picture picture =
            value_or_throw(runner_.picture(document, lesson_, handout_size(lesson_), samples));
        html_ += html_image(picture, alternative_text(*step_, document.scene)) + "\n";
        shown_ = document.scene;
    }

    void add(const Teaching& teaching) {
        const auto list = [this](const char* title, const std::vector<std::string>& items) {
            html_ += fmt::format("<h2>{}</h2>\n<ul>\n", title);
            for (const std::string& item : items) html_ += fmt::format("<li>{}</li>\n", lesson_html(item));
            html_ += "</ul>\n";
        };
        if (teaching.minutes > 0) html_ += fmt::format("<p>{} minutes in a lecture.</p>\n", teaching.minutes);
        list("Afterwards a student can", teaching.goals);
        html_ += fmt::format("<h2>What students believe</h2>\n<p>{}</p>\n<p>Source: {}</p>\n",
                             lesson_html(teaching.belief), lesson_html(teaching.source));
        list("What to say or ask next", teaching.says);
    }

    void add(const std::vector<ProseBlock>& prose) {
        if ((told_ || key_) && kind_ != PageKind::Instructor) html_ += prose_html(prose);
    }

    /// Adds the options or the number. Includes the right answer, and for the lecturer the typical wrong
    /// answers.
    void add_answer(const Prediction& p, const RightAnswer& right) {
        const bool told = kind_ == PageKind::Key || kind_ == PageKind::Instructor;
        const auto belief = [told](const std::string& thinks) {
            return told && !thinks.empty() ? "<br><small>" + lesson_html(thinks) + "</small>" : "";
        };
        html_ += "<ul class=\"options\">\n";
        for (std::size_t i = 0; i < p.options.size(); ++i)
            html_ += fmt::format("<li{}>{} {}{}</li>\n", right.value == Json(i) ? " class=\"right\"" : "",
                                 static_cast<char>('A' + i), lesson_html(p.options[i].text),
                                 belief(p.options[i].thinks));
        if (p.kind != PredictionKind::Choice && p.kind != PredictionKind::Sketch && right.value != Json())
            html_ += fmt::format("<li class=\"right\">{}</li>\n", lesson_html(answer_text(p, right.value)));
        for (std::size_t i = 0; told && i < right.wrong.size(); ++i)
            html_ += fmt::format("<li>{}{}</li>\n",
                                 lesson_html("If the answer was " + answer_text(p, right.wrong[i]) + ":"),
                                 belief(p.wrong[i].thinks));
        html_ += "</ul>\n";
        if (p.kind == PredictionKind::Sketch) html_ += axes_svg(elements_of(right.value), right.tolerance);
    }

    void add(const Prediction& p) {
        told_ = true;
        const bool asks = kind_ == PageKind::Slides;
        if (!std::exchange(fresh_, false)) begin_slide(step_->title);
        if (asks) add_picture(asked_);
        const RightAnswer right =
            key_ ? value_or_throw(right_answer(runner_, document_, lesson_, p)) : RightAnswer{};
        html_ += fmt::format("<div class=\"box\"><h3>Predict</h3><p>{}</p>\n", lesson_html(p.question));
        add_answer(p, asks ? RightAnswer{} : right);
        if (kind_ == PageKind::Student && p.kind != PredictionKind::Choice &&
            p.kind != PredictionKind::Sketch)
            html_ += fmt::format("<p class=\"answer\">{}</p>\n", lesson_html(p.unit));
        if (kind_ == PageKind::Student) html_ += "<p>Why do you think so?</p><div class=\"lines\"></div>\n";
        html_ += "</div>\n";
        questions_.emplace_back(&p, right);
    }

    void add(const Reveal& reveal) {
        told_ = fresh_ = false;
        if (!key_) return;
        if (kind_ == PageKind::Slides) begin_slide(step_->title);
        add_picture(value_or_throw(LessonRunner::with(document_, reveal.set, lesson_, reveal.line)));
        if (kind_ == PageKind::Slides)
            for (const auto& [question, right] : questions_) {
                html_ += fmt::format("<p>{}</p>\n", lesson_html(question->question));
                add_answer(*question, right);
            }
        questions_.clear();
    }

    void add(const Task& task) {
        told_ = true;
        html_ += fmt::format("<div class=\"box try window\"><h3>Try</h3><p>Drag {}.</p></div>\n",
                             lesson_html(task.drag));
    }

    void add(const Claim& claim) {
        if (kind_ == PageKind::Key)
            html_ += fmt::format("<div class=\"box key\"><h3>Checked</h3><p>{}</p></div>\n",
                                 lesson_html(claim.says));
    }

    void add(const Exercise&) {}  // printed by `glint exercise`

    LessonRunner& runner_;
    const Lesson& lesson_;
    PageKind kind_;
    bool key_;           // whether the page may contain answers
    bool told_ = true;   // whether the next text may be read before answering
    bool fresh_ = true;  // whether the slide does not contain a question yet
    std::string html_;
    const LessonStep* step_ = nullptr;
    SceneDocument document_, asked_;  // the step's scene; the same with its answer hidden
    std::optional<Scene> shown_;
    std::vector<std::pair<const Prediction*, RightAnswer>> questions_;  // those since the last reveal
};

}  // namespace

PictureSize handout_size(const Lesson& lesson) {
    constexpr int least_width = 640;
    const int times = (least_width + lesson.size.width - 1) / lesson.size.width;
    const int fits = std::max(1, max_lesson_side / std::max(lesson.size.width, lesson.size.height));
    const int scale = std::min(times, fits);
    return {lesson.size.width * scale, lesson.size.height * scale};
}

Result<std::string> handout_html(LessonRunner& runner, const Lesson& lesson, PageKind kind) {
    return result_of(lesson.path, [&] { return Handout(runner, lesson, kind).made(); });
}

std::string alternative_text(const LessonStep& step, const Scene& scene) {
    if (!step.shows.empty()) return step.shows;
    std::vector<std::string> objects, lights;
    for (const Object& object : scene.objects)
        if (object.visible && object.name != Object{}.name) objects.push_back(object.name);
    for (const Light& light : scene.lights)
        if (light.enabled) lights.push_back(light.name);
    const bool lit = !lights.empty() && scene.shading.reflection != Reflection::None;
    if (objects.empty()) return "A drawing for the question";
    return fmt::format("The picture shows: {}; {}{}", fmt::join(objects, ", "), lit ? "lit by: " : "unlit",
                       fmt::join(lit ? lights : std::vector<std::string>{}, ", "));
}

namespace {

constexpr std::string_view style =
    "body{font:17px/1.5 system-ui,'DejaVu Sans',sans-serif;max-width:46em;margin:2em auto;padding:0 1em;"
    "color:#1a1a1a;background:#fff}h1{font-size:1.7em;line-height:1.2;margin:.2em 0 .6em}"
    "h2{font-size:1.25em;margin:1.6em 0 .5em}img{display:block;max-width:100%;height:auto;margin:1em 0;"
    "border-radius:4px}code{font-size:.92em;background:#0001;padding:0 .2em;border-radius:3px}"
    "pre{background:#0001;padding:.6em .9em;overflow-x:auto}pre code{background:none}"
    ".topic{color:#595959;margin:0}.box{border:1px solid #bbb;border-left:5px solid "
    "#2a6fb0;border-radius:4px;"
    "padding:.5em 1em;margin:1em 0;break-inside:avoid}.box.try{border-left-color:#2b8a4b}"
    ".box.key{border-left-color:#b4632a}.box h3{margin:.1em 0 .4em;font-size:.85em;letter-spacing:.04em;"
    "text-transform:uppercase;color:#595959}.box ul.options{list-style:none;padding-left:.2em}"
    ".answer{border-bottom:1px solid #888;min-width:12em;width:40%;text-align:right;margin:.8em 0 1.2em;"
    "min-height:1.6em;color:#595959}.lines{height:4em;background:repeating-linear-gradient(#0000 0 "
    "1.9em,#888 1.9em 2em)}blockquote{margin:1em 0;"
    "border-left:5px solid #888;padding:.1em "
    "1em}.slide{font-size:28px;line-height:1.35;min-height:94vh}.slide[hidden]{display:none}"
    ".slide img{max-height:48vh;width:auto}body:has(.slide){max-width:60em;margin:0 "
    "auto}.right{font-weight:600}.room{height:4.5em}.name{border-bottom:1px solid #888;"
    "width:60%}table{border-collapse:collapse}td,th{text-align:left;vertical-align:top;padding:.3em .9em "
    ".3em 0;"
    "border-bottom:1px solid #ddd}td ol{margin:0}svg{display:block;margin:.6em 0;max-width:100%;height:auto}"
    "@media "
    "print{.window,button{display:none}.slide{break-after:page}body{margin:0;max-width:none;font-size:11pt}"
    "h2,h3{break-after:avoid}img{max-height:7.5cm;"
    "width:auto}.paper{break-after:page}}";

std::string span_html(const ProseSpan& span) {
    std::string html;
    std::string_view rest = span.text;
    while (true) {  // a line break that the author intended
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        html += span.code ? html_escaped(rest.substr(0, end)) : lesson_html(rest.substr(0, end));
        if (end == rest.size()) break;
        html += "<br>";
        rest.remove_prefix(end + 1);
    }
    if (span.code) html = "<code>" + html + "</code>";
    if (span.emphasis) html = "<em>" + html + "</em>";
    if (span.strong) html = "<strong>" + html + "</strong>";
    // Other links could execute code, or break when the page is moved.
    if (span.link.starts_with("https://") || span.link.starts_with("http://"))
        html = fmt::format("<a href=\"{}\">{}</a>", html_escaped(span.link), html);
    return html;
}

std::string spans_html(const ProseBlock& block) {
    std::string html;
    for (const ProseSpan& span : block.spans) html += span_html(span);
    return html;
}

/// The lines of a code block, with HTML characters escaped.
std::string code_html(const ProseBlock& block) {
    std::string html;
    const std::string whole = plain_text(block);
    for (std::size_t at = 0; at < whole.size();) {
        const std::size_t end = std::min(whole.find('\n', at), whole.size());
        html += html_escaped(std::string_view(whole).substr(at, end - at)) + "\n";
        at = end + 1;
    }
    return "<pre><code>" + html + "</code></pre>\n";
}

/// Writes the list tags before and after list items.
class Lists {
  public:
    void close_to(std::string& html, std::size_t depth) {
        while (open_.size() > depth) {
            html += open_.back() ? "</ol>\n" : "</ul>\n";
            open_.pop_back();
        }
    }
    void item(std::string& html, const ProseBlock& block) {
        const auto depth = static_cast<std::size_t>(block.level);
        const bool numbered = block.number >= 0;
        close_to(html, open_.size() == depth && open_.back() != numbered ? depth - 1 : depth);
        while (open_.size() < depth) {
            html += numbered ? "<ol>\n" : "<ul>\n";
            open_.push_back(numbered);
        }
        html += numbered ? fmt::format("<li value=\"{}\">", block.number) : "<li>";
        html += spans_html(block) + "</li>\n";
    }

  private:
    std::vector<bool> open_;  // whether each open list is numbered
};

}  // namespace

std::string with_indices(std::string_view text, std::string_view underline, const std::string& form) {
    const auto is_of_name = [&text](std::size_t i) {
        return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
    };
    std::string set;
    std::size_t done = 0;
    for (std::size_t at = text.find(underline); at != text.npos; at = text.find(underline, at + 1)) {
        const std::size_t after = at + underline.size();
        const bool one_before = at > 0 && is_of_name(at - 1) && !(at > 1 && is_of_name(at - 2));
        if (at <= done || !one_before || !is_of_name(after) || is_of_name(after + 1)) continue;
        set += text.substr(done, at - 1 - done);
        set += fmt::format(fmt::runtime(form), text[at - 1], text[after]);
        done = after + 1;
    }
    return set += text.substr(done);
}

std::string lesson_html(std::string_view text) {
    return with_indices(html_escaped(text), "_", "{0}<sub>{1}</sub>");
}

std::string page_html(std::string_view title, std::string_view body) {
    constexpr std::string_view end = "</body></html>\n";
    std::string page = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\"><title>{}</title><style>{}</style></head>\n<body>\n",
        html_escaped(title), style);
    page.reserve(page.size() + body.size() + end.size());  // avoids reallocations of a large page
    return page.append(body).append(end);
}

std::string prose_html(const std::vector<ProseBlock>& blocks) {
    std::string html;
    Lists lists;
    for (const ProseBlock& block : blocks) {
        if (block.kind == ProseKind::Item) {
            lists.item(html, block);
            continue;
        }
        lists.close_to(html, 0);
        switch (block.kind) {
        case ProseKind::Paragraph:
        case ProseKind::Item:
            html += "<p>" + spans_html(block) + "</p>\n";
            break;
        case ProseKind::Heading:
            html += fmt::format("<h{0}>{1}</h{0}>\n", block.level, spans_html(block));
            break;
        case ProseKind::Quote:
            html += fmt::format("<blockquote{}><p>{}</p></blockquote>\n",
                                plain_text(block).starts_with("In the window") ? " class=\"window\"" : "",
                                spans_html(block));
            break;
        case ProseKind::Code:
            html += code_html(block);
            break;
        }
    }
    lists.close_to(html, 0);
    return html;
}

}  // namespace glint
