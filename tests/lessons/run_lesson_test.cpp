// Tests for the results of a lesson's runs, prediction grading, handouts and exercises.
#include "lessons/run_lesson.h"

#include <algorithm>
#include <set>

#include "lessons/check_lesson.h"
#include "lessons/handout.h"
#include "renderer/answers/answers.h"
#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

/// A plate that faces the eye, and a sun at 60 degrees: n·l is one half. `rest` contains the lesson's steps.
struct Bench {
    explicit Bench(const std::string& rest) {
        scene = directory.file("plate.json", R"({"glint": 1, "global_ambient": [0, 0, 0],
          "camera": {"eye": [0, 0, 5], "projection": {"type": "orthographic", "height": 2}},
          "lights": [{"type": "directional", "position": [0.8660254, 0, 0.5]}],
          "objects": [{"name": "Plate", "mesh": {"primitive": "plane"}, "transform": {"rotate_deg": [90, 0, 0]},
                       "material": {"diffuse": [0.5, 0.5, 0.5], "specular": [0, 0, 0]}}]})");
        const std::string path = directory.file(
            "01-plate.md",
            "# A plate\n\n```lesson\ntopic: Light\nscene: plate.json\nsize: 32x32\n```\n\n" + rest);
        const Result<Lesson> read = read_lesson(path);
        if (const Problem* problem = problem_of(read)) FAIL(problem->text());
        lesson = std::get<Lesson>(read);
    }
    std::vector<Checked> checked(std::vector<Assignment> always = {}) const {
        LessonRunner runner(1);
        runner.set_always(std::move(always));
        const Result<std::vector<Checked>> result = check_lesson(runner, lesson);
        if (const Problem* problem = problem_of(result)) FAIL(problem->text());
        return std::get<std::vector<Checked>>(result);
    }
    std::string problem() const {
        LessonRunner runner(1);
        const Result<std::vector<Checked>> result = check_lesson(runner, lesson);
        return problem_of(result) == nullptr ? "" : problem_of(result)->text();
    }
    std::string page(PageKind kind) const {
        LessonRunner runner(1);
        return std::get<std::string>(handout_html(runner, lesson, kind));
    }
    std::vector<ExerciseSheet> sheets(std::uint64_t seed, int count) const {
        LessonRunner runner(1);
        return std::get<std::vector<ExerciseSheet>>(exercise_sheets(runner, lesson, seed, count));
    }

    TemporaryDirectory directory;
    std::string scene;
    Lesson lesson;
};

/// The first tag of a page that is not closed in order; empty if there is none.
std::string unclosed_in(const std::string& html) {
    std::vector<std::string> open;
    for (std::size_t at = html.find('<'); at < html.size(); at = html.find('<', at + 1)) {
        std::string name = html.substr(at + 1, html.find_first_of(" >", at) - at - 1);
        if (html[html.find('>', at) - 1] == '/' || name[0] == '!') continue;
        if (name == "img" || name == "br" || name == "meta") continue;
        if (name == "script" || name == "style")
            at = html.find("</" + name, at);
        else if (name[0] != '/')
            open.push_back(name);
        else if (open.empty() || "/" + open.back() != name)
            return name;
        else
            open.pop_back();
    }
    return open.empty() ? "" : open.back();
}

constexpr const char* half =
    "```claim\nsays: A half.\ne = explain --pixel 16,16\n"
    "check: e.lights[0].n_dot_l = 0.5 within 1e-5\ncheck: e.sum = 0.25 within 1e-5\n```\n";

}  // namespace

TEST_CASE("a claim holds with the engine's numbers and fails with a mistake", "[lesson]") {
    const Bench bench(half);
    REQUIRE(bench.checked().size() == 1);
    CHECK(bench.checked()[0].holds);
    const Checked fallen = bench.checked({{"/shading/mistakes/missing_pi", "true"}})[0];
    CHECK_FALSE(fallen.holds);
    CHECK(fallen.line == 9);
    CHECK(fallen.why.find("e.sum = 0.25 within 1e-5 is false: [0.0795") == 0);
}

TEST_CASE("each kind of run returns its command's result", "[lesson]") {
    const Bench bench(R"(```claim
says: All of them.
e = explain --pixel 16,16 --set /lights/0/position=[0,0,1]
r = render
s = render --set /objects/0/material/diffuse=[1,0.5,0.5]
p = profile --from 4,16 --to 27,16
i = info --size 64x32
l = lobe --object 0 --angle 0
m = microfacets --roughness 0 --angle 30
c = compare r s
check: e.sum = 0.5 within 1e-6
check: r.shaded_pixels = 1024 and r.width = 32
check: count(p.intensity) = 24 and p.intensity = 0.25 within 1e-6
check: i.lights = 1 and i.matrices.clip_from_view[0][0] = 0.5
check: l.light_deg = 0 and l.specular_energy = 0
check: m.shares.free = 1 within 1e-9 and m.h_deg = 0
check: c.max = [64, 0, 0] within 1
```
)");
    const Checked item = bench.checked().at(0);
    INFO(item.why);
    CHECK(item.holds);
}

TEST_CASE("a step starts with the lesson's scene, independently of earlier steps", "[lesson]") {
    const Bench bench(
        std::string("## One\n\n```scene\nset: /lights/0/position=[0,0,1]\n```\n\n"
                    "```claim\nsays: One.\ne = explain --pixel 16,16\ncheck: e.sum = 0.5 within 1e-5\n"
                    "```\n\n## Two\n\n") +
        half);
    for (const Checked& item : bench.checked()) CHECK(item.holds);
}

TEST_CASE("failures of predictions, tasks and exercises are reported", "[lesson][bad-input]") {
    const auto why = [](const std::string& block) {
        return Bench("```" + block + "\n```\n").checked().at(0).why;
    };
    const std::string run = "\ne = explain --pixel 16,16\n";
    CHECK(
        why("predict number\nquestion: ?" + run + "answer: e.sum\ntolerance: 1").find("expected a number") !=
        std::string::npos);
    CHECK(why("predict number\nquestion: ?" + run + "answer: 1\ntolerance: 0").find("more than 0") !=
          std::string::npos);
    CHECK(why("predict click\nquestion: ?" + run + "answer: e.sum\ntolerance: 1")
              .find("expected a list of 2 numbers") != std::string::npos);
    CHECK(
        why("predict click\nquestion: ?\nanswer: [32, 4]\ntolerance: 1").find("expected a pixel of 32x32") !=
        std::string::npos);
    CHECK(
        why("predict click\nquestion: ?\nanswer: [4, -1]\ntolerance: 1").find("expected a pixel of 32x32") !=
        std::string::npos);
    CHECK(why("predict click\nquestion: ?\nanswer: [31, 0]\ntolerance: 1").empty());
    CHECK(why("predict sketch\nquestion: ?\nalong: 0,0 1,0\nanswer: [[1, 2], [3, 4]]\ntolerance: 1")
              .find("]]; expected a list of 2 numbers") != std::string::npos);
    CHECK(why("predict number\nquestion: ?" + run + "term: lights[7].][(z\nanswer: 1\ntolerance: 1")
              .find("term: ") == 0);
    CHECK(why("predict number\nquestion: ?\nterm: nonsense\nanswer: 1\ntolerance: 1") ==
          "term: no run explains a pixel; expected e = explain --pixel X,Y");
    CHECK(why("predict number\nquestion: ?" + run + "term: lights[7].n_dot_l\nanswer: 1\ntolerance: 1")
              .find("no element 7") != std::string::npos);
    CHECK(why("predict number\nquestion: ?" + run + "term: lights[0].n_dot_l\nanswer: 1\ntolerance: 1")
              .empty());
    CHECK(why("try\ndrag: it\ncontrol: /foo/bar" + run + "done: e.sum[0] > 1\nsolution: /display/exposure=9")
              .find("no number at /foo/bar") != std::string::npos);
    CHECK(why("predict choice\nquestion: ?" + run + "option: a\nif: true\noption: b\nif: e.hit")
              .find("a second option is right") != std::string::npos);
    CHECK(why("predict choice\nquestion: ?" + run + "option: a\nif: false\noption: b\nif: not e.hit")
              .find("no option is right") != std::string::npos);
    CHECK(why("try\ndrag: it" + run + "done: e.hit\nsolution: /display/exposure=2")
              .find("done before anything is dragged") != std::string::npos);
    CHECK(why("try\ndrag: it" + run + "done: e.sum[0] > 1\nsolution: /display/exposure=2").find("is false") !=
          std::string::npos);
    CHECK(why("try\ndrag: it" + run + "done: e.sum[0] > 1").find("no solution") != std::string::npos);
    CHECK(why("exercise\nvary: k = 1 to 9 step 1\nquestion: ?" + run +
              "answer: k * e.sum[0]\ntolerance: 0.01\nclosed: k")
              .find("the engine says") != std::string::npos);
    CHECK(why("claim\nsays: ?\ne = explain --pixel 32,16\ncheck: e.hit").find("outside the picture") !=
          std::string::npos);
    CHECK(why("claim\nsays: ?\ne = explain --pixel 1,1 --set /lights/7/intensity=1\ncheck: e.hit")
              .find("is past the end") != std::string::npos);
    CHECK(why("claim\nsays: ?\nl = lobe --object 3\ncheck: true").find("no object 3") != std::string::npos);
}

TEST_CASE("an answer that does not fit its question is reported with its line", "[lesson][bad-input]") {
    for (const char* const block :
         {"predict number\nquestion: ?\nanswer: [1, 2]\ntolerance: 1",
          "predict number\nquestion: ?\nanswer: true\ntolerance: 1",
          "predict click\nquestion: ?\nanswer: [[1], [2]]\ntolerance: 1",
          "predict colour\nquestion: ?\nanswer: [\"a\", \"b\", \"c\"]\ntolerance: 1",
          "predict colour\nquestion: ?\nanswer: [0, 1.5, 1]\ntolerance: 1",
          "predict colour\nquestion: ?\nanswer: [0 - 0.1, 1, 1]\ntolerance: 1"}) {
        const Bench bench("```" + std::string(block) + "\n```\n");
        LessonRunner runner(1);
        const Result<std::string> page = handout_html(runner, bench.lesson, PageKind::Key);
        const Problem* problem = problem_of(page);
        CAPTURE(block);
        REQUIRE(problem != nullptr);
        CHECK(problem->text().find("01-plate.md:9: the answer is ") != std::string::npos);
        CHECK_FALSE(bench.checked().at(0).holds);
    }
}

TEST_CASE("an invalid assignment to the scene is reported with the lesson's line", "[lesson][bad-input]") {
    const Bench step("## S\n\n```scene\nset: /lights/0/intensity=many\n```\n\n" + std::string(half));
    CHECK(step.problem().find("01-plate.md:11: /lights/0/intensity: ") != std::string::npos);
    const Bench reveal(std::string(half) + "\n```reveal\nplay: /camera/eye 1 to 2\n```\n");
    CHECK(reveal.problem().find("01-plate.md:16: /camera/eye: ") != std::string::npos);
    Bench missing(half);
    missing.lesson.scene += "x.json";
    CHECK(missing.problem().find("no such file") != std::string::npos);
}

TEST_CASE("each kind of prediction has its own error measure", "[lesson]") {
    CHECK(how_far(PredictionKind::Number, 0.5, 0.75) == Approx(0.25));
    CHECK(how_far(PredictionKind::Choice, 1, 1) == 0);
    CHECK(how_far(PredictionKind::Choice, 0, 1) == 1);
    CHECK(how_far(PredictionKind::Click, {10, 10}, {13, 14}) == Approx(5));
    CHECK(how_far(PredictionKind::Colour, {0, 0.5, 1}, {0.1, 0.2, 1}) == Approx(0.3));
    CHECK(how_far(PredictionKind::Sketch, {0, 0, 0, 0}, {2, 0, 0, 0}) == Approx(1));
}

TEST_CASE("a handout shows answers, revealed text and claims only in its key", "[lesson][handout]") {
    const Bench bench(R"(Read *this* & <that>.

## Ask

```predict number
question: How bright?
e = explain --pixel 16,16
answer: e.sum[0]
tolerance: 0.1
unit: of it
```

```predict choice
question: Is it so?
option: yes
if: true
option: no
if: false
```

```reveal
set: /display/exposure=2
```

Explained later.

```claim
says: It is claimed.
check: true
```

```try
drag: the sun
done: true
```
)");
    const std::string without = bench.page(PageKind::Student), with = bench.page(PageKind::Key);
    for (const std::string& page : {without, with}) {
        CHECK(page.find("Read <em>this</em> &amp; &lt;that&gt;.") != std::string::npos);
        CHECK(page.find("How bright?") != std::string::npos);
        CHECK(page.find("Drag the sun.") != std::string::npos);
        CHECK(page.find("alt=\"The picture shows: Plate; lit by: ") != std::string::npos);
        CHECK(page.find("src=\"data:image/png;base64,iVBORw0KGgo") != std::string::npos);
        CHECK(page.find("http") == std::string::npos);
    }
    CHECK(without.find("Why do you think so?") != std::string::npos);
    for (const char* const secret : {"Explained later.", "It is claimed.", "0.25 of it", "class=\"right\""}) {
        CAPTURE(secret);
        CHECK(with.find(secret) != std::string::npos);
        CHECK(without.find(secret) == std::string::npos);
    }
    const auto pictures = [](const std::string& page) {
        std::size_t count = 0;
        for (std::size_t at = page.find("<img"); at != page.npos; at = page.find("<img", at + 1)) ++count;
        return count;
    };
    CHECK(pictures(without) == 1);  // the step has the same scene as the lesson
    CHECK(pictures(with) == 2);     // one more for the reveal
}

TEST_CASE("a seed determines the sheet, and the engine computes the key", "[lesson][exercise]") {
    const Bench bench(R"(```exercise
vary: k = 0.1 to 0.9 step 0.05
question: k_d is {k} & n·l a half. How bright?
set: /objects/0/material/diffuse=[{k},{k},{k}]
e = explain --pixel 16,16
answer: e.sum[0]
tolerance: 0.001
closed: k / 2
```
)");
    CHECK(bench.checked().at(0).holds);
    LessonRunner runner(1);
    const auto sheets = std::get<std::vector<ExerciseSheet>>(exercise_sheets(runner, bench.lesson, 5, 8));
    const auto again = std::get<std::vector<ExerciseSheet>>(exercise_sheets(runner, bench.lesson, 12, 1));
    REQUIRE(sheets.size() == 8);
    CHECK(sheets[7].seed == 12);
    CHECK(sheets[7].questions[0].question == again[0].questions[0].question);
    std::set<std::string> different;
    for (const ExerciseSheet& sheet : sheets) {
        const PosedQuestion& q = sheet.questions.at(0);
        CHECK(q.answer == Approx(*q.closed).margin(1e-4));
        const double k = std::stod(q.question.substr(std::string("k_d is ").size()));
        CHECK(q.answer == Approx(k / 2).margin(1e-4));
        different.insert(q.question);
        CHECK(q.working.front() == "k / 2");
        CHECK(q.working.at(1) == q.question.substr(std::string("k_d is ").size(),
                                                   q.question.find(" &") - std::string("k_d is ").size()) +
                                     " / 2");
    }
    CHECK(different.size() == 8);
    CHECK(key_warnings(bench.lesson, sheets).empty());
    const std::string tex = exercises_tex(bench.lesson, sheets),
                      html = exercises_html(bench.lesson, sheets, ""),
                      keys = exercise_keys_html(bench.lesson, sheets),
                      tex_keys = exercise_keys_tex(bench.lesson, sheets);
    CHECK(keys.find("by the engine") == std::string::npos);
    CHECK(tex.find("k\\textsubscript{d} is ") != std::string::npos);
    CHECK(tex.find("\\& n\\textperiodcentered{}l a half") != std::string::npos);
    CHECK(tex_keys.find("Sheet 12") != std::string::npos);
    CHECK(html.find("k<sub>d</sub> is ") != std::string::npos);
    CHECK(keys.find("Keys: A plate") != std::string::npos);
    // Only the keys contain the accepted answers.
    for (const std::string& sheet : {html, tex}) CHECK(sheet.find("accept") == std::string::npos);
    for (const std::string& key : {keys, tex_keys}) CHECK(key.find("accept") != std::string::npos);
}

TEST_CASE("a key shows both answers if the formula and the engine disagree", "[lesson][exercise]") {
    const Bench bench(R"(```exercise
vary: k = 0.25, 0.5
question: How much is {k}?
answer: k
tolerance: 0.01
unit: m
closed: max(k, 0.4)
```
)");
    const auto sheets = bench.sheets(1, 12);
    const auto is_wrong = [](const ExerciseSheet& sheet) { return sheet.questions[0].answer == 0.25; };
    const auto first = std::find_if(sheets.begin(), sheets.end(), is_wrong);
    REQUIRE(first != sheets.end());
    const auto wrong = std::count_if(sheets.begin(), sheets.end(), is_wrong);
    REQUIRE(wrong < 12);
    const std::string told = ":9: the formula misses the engine's answer on " + std::to_string(wrong) +
                             " of 12 sheets, first on sheet " + std::to_string(first->seed) +
                             ": 0.4 by the formula, 0.25 by the engine";
    CHECK(key_warnings(bench.lesson, sheets) ==
          Warnings{bench.lesson.path +
                       ":9: the exercise has 2 variants for 12 sheets: some sheets repeat a variant",
                   bench.lesson.path + told});
    for (const std::string& key :
         {exercise_keys_html(bench.lesson, sheets), exercise_keys_tex(bench.lesson, sheets)}) {
        CHECK(key.find("0.400 m by the formula, but 0.250 by the engine") != std::string::npos);
        CHECK(key.find("0.500 m by the formula") == std::string::npos);
        CHECK(key.find("(accept 0.390 to 0.410)") != std::string::npos);
    }
}

TEST_CASE("letters missing from LaTeX's usual fonts become commands or a warning", "[lesson][exercise]") {
    const Bench bench("");
    PosedQuestion question;
    question.question = "Is α₂ → ∞, or é “ſ” 漢漢 Ж?";
    const std::string tex = exercises_tex(bench.lesson, {{1, {question}}});
    CHECK(
        tex.find(
            "Is \\ensuremath{\\alpha}\\ensuremath{_2} \\ensuremath{\\to} \\ensuremath{\\infty}, or é “ſ”") !=
        std::string::npos);
    CHECK(unset_letters(tex) == "漢Ж");
    question.question = "[3 points] How much?";  // \\item would take this for a label instead of its number
    CHECK(exercises_tex(bench.lesson, {{1, {question}}}).find("\\item {}[3 points] How much?") !=
          std::string::npos);
    const std::string alphabet = "абвгдежзийклмнопрстуфхцчшщъыьэюя";
    CHECK(unset_letters(alphabet + alphabet) == "абвгдежзийклмнопрсту and 12 more");
}

TEST_CASE("a lesson without exercises is an error", "[lesson][exercise][bad-input]") {
    const Bench bench(half);
    LessonRunner runner(1);
    const auto sheets = exercise_sheets(runner, bench.lesson, 1, 1);
    REQUIRE(problem_of(sheets) != nullptr);
    CHECK(problem_of(sheets)->text().find("the lesson has no exercises") != std::string::npos);
}

TEST_CASE("the answer is visible only in the key's picture, not in the handout's", "[lesson][handout]") {
    const Bench bench(
        "## Dark\n\n```scene\nset: /display/exposure=2\npicture: /lights/0/enabled=false\n```\n");
    const Bench lit("## Lit\n\n```scene\nset: /display/exposure=2\n```\n");
    const Bench dark("## Dark\n\n```scene\nset: /display/exposure=2\nset: /lights/0/enabled=false\n```\n");
    const auto picture = [](const std::string& page) {
        const std::size_t at = page.find("<img");
        return page.substr(at, page.find('>', at) - at);
    };
    CHECK(picture(bench.page(PageKind::Key)) == picture(lit.page(PageKind::Key)));
    CHECK(picture(bench.page(PageKind::Student)) == picture(dark.page(PageKind::Student)));
    CHECK(picture(lit.page(PageKind::Student)) != picture(dark.page(PageKind::Student)));
}

TEST_CASE("the working in a key inserts the values, then evaluates from the inside out",
          "[lesson][exercise]") {
    const Bench bench(R"(```exercise
vary: deg = 60
vary: kd = 0.5
vary: z = -3
question: {deg} {kd} {z}?
answer: kd * cos(deg) / sqrt(z ^ 2 + 16)
tolerance: 0.01
closed: kd * cos(deg) / sqrt(z ^ 2 + 16)
```
)");
    const auto sheets = bench.sheets(1, 1);
    CHECK(sheets[0].questions[0].working == std::vector<std::string>{"kd · cos(deg) / √(z² + 16)",
                                                                     "0.5 · cos(60) / √((−3)² + 16)",
                                                                     "0.5 · 0.5 / 5"});
}

TEST_CASE("a printed sheet's picture is bright and its objects are not black", "[lesson][exercise]") {
    const Bench bench("```scene\nset: /lights/0/intensity=0.2\n```\n");
    LessonRunner runner(1);
    const auto html = std::get<std::string>(sheet_picture(runner, bench.lesson));
    CHECK(html.find("<img alt=\"The picture shows: Plate") == 0);
    const auto lit = [&](float factor) {
        SceneDocument document = std::get<SceneDocument>(runner.open(bench.lesson));
        document.scene.lights[0].intensity = 0.2f;
        document.scene.display.background = glm::vec3(0.9f);
        document.scene.display.exposure = factor;
        return html_image(
            std::get<Picture>(runner.picture(document, bench.lesson, handout_size(bench.lesson), 4)), "x");
    };
    const auto data = [](const std::string& image) { return image.substr(image.find("src=")); };
    CHECK(data(html) == data(lit(4)));  // an exposure of 4, which shows 0.05 as 0.2
    CHECK(data(html) != data(lit(1)));
}

TEST_CASE("every page of a lesson closes its tags in order, even with nested lists", "[lesson][handout]") {
    const Bench bench(R"(- one
- two
    1. deeper
    2. still
- three

1. first

## Ask

```predict number
question: How bright?
e = explain --pixel 16,16
answer: e.sum[0]
tolerance: 0.1
```

```reveal
set: /display/exposure=2
```

- told
)");
    for (const PageKind kind : {PageKind::Student, PageKind::Key, PageKind::Slides, PageKind::Instructor}) {
        const std::string page = bench.page(kind);
        CAPTURE(static_cast<int>(kind));
        CHECK(unclosed_in(page).empty());
        CHECK((page.find("addEventListener") != page.npos) == (kind == PageKind::Slides));
        if (kind == PageKind::Instructor) continue;
        CHECK(page.find("<ul>\n<li>one</li>\n<li>two</li>\n<ol>\n<li value=\"1\">deeper</li>\n"
                        "<li value=\"2\">still</li>\n</ol>\n<li>three</li>\n</ul>\n<ol>\n<li value=\"1\">") !=
              page.npos);
    }
}

TEST_CASE("slides show each question before its answer, notes say what students believe",
          "[lesson][handout]") {
    Bench bench(R"(## Ask

```predict number
question: How bright?
e = explain --pixel 16,16
answer: e.sum[0]
tolerance: 0.01
wrong: 0.5
thinks: Only k_d counts.
```

```reveal
set: /display/exposure=2
```

Explained later.
)");
    bench.lesson.teaching = {7, {"do it"}, "They believe.", "Somebody 1999", {"Ask this."}};
    LessonRunner runner(1);
    const auto slides = std::get<std::string>(handout_html(runner, bench.lesson, PageKind::Slides));
    const std::size_t question = slides.find("How bright?"), answer = slides.find("class=\"right\""),
                      told = slides.find("Explained later.");
    CHECK(question < answer);
    CHECK(answer < told);
    CHECK(slides.substr(question, answer - question).find("<section class=\"slide\">") != std::string::npos);
    CHECK(slides.find("Only k") == std::string::npos);
    const auto notes = std::get<std::string>(handout_html(runner, bench.lesson, PageKind::Instructor));
    for (const char* const note :
         {"7 minutes", "do it", "They believe.", "Somebody 1999", "Ask this.", "How bright?", "0.25",
          "If the answer was 0.5:", "Only k<sub>d</sub> counts."}) {
        CAPTURE(note);
        CHECK(notes.find(note) != std::string::npos);
    }
    CHECK(notes.find("<img") == std::string::npos);
}
