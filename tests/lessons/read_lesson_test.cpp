// Tests for parsing lessons: the result of each block, the line of every error, and hostile files.
#include <fmt/format.h>

#include <random>

#include "lessons/lesson.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

const std::string every_block = R"(# Lambert's law

```lesson
topic: Diffuse reflection
scene: ../scenes/cosine-law.json
size: 320x180
rows: 13 14
answers: 1 2
```

A *plate* is **lit**; see [there](https://example.org) for `n·l`.

1. first
2. second
   - deeper

## Tilt it

```scene
set: /lights/0/position=[0,1,0]
picture: /lights/0/enabled=false
```

```predict number
question: How bright is the plate
  at 60 degrees?
e = explain --pixel 10,20 --set /shading/mode=flat --size 64x48
answer: e.lights[0].n_dot_l
tolerance: 0.02
unit: of the light
term: lights[0].n_dot_l
```

```reveal
set: /display/exposure=2
pick: 10,20
along: 0,9 63,9
play: /lights/0/position/1 1 to 2
```

Behind the reveal.

```predict choice
question: Brighter?
a = render
b = render --set /shading/mode=flat
c = compare a b
option: yes
if: c.max_error > 0
option: no
if: c.max_error = 0
```

```predict sketch
question: Draw it.
p = profile --from 0,9 --to 63,9
answer: p.intensity
tolerance: 0.1
along: 0,9 63,9
```

```try
drag: the sun
control: /lights/0/position
e = explain --pixel 1,1
done: e.hit
solution: /lights/0/position=[1,1,1]
```

```claim
says: It is so.
m = microfacets --roughness 0.2 --rays 100
l = lobe --object 1 --angle 30
check: m.shares.free > 0
check: l.light_deg = 30
falls_under: missing_pi absolute_cosine
```

```exercise
vary: deg = 10 to 30 step 10
vary: k = 0.5, 0.25
question: {deg} degrees and {k}?
set: /objects/0/transform={"rotate_deg":[{deg},{2 * deg},0]}
e = explain --pixel 1,1
answer: e.sum[0] * k
tolerance: 0.01
closed: k * cos(deg)
```
)";

Lesson read(const std::string& text) {
    const Result<Lesson> lesson = parse_lesson(text, "lessons/05-lambert.md");
    if (const Problem* problem = problem_of(lesson)) FAIL(problem->text());
    return std::get<Lesson>(lesson);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

std::string problem_of_text(const std::string& text) {
    const Result<Lesson> lesson = parse_lesson(text, "l.md");
    return problem_of(lesson) == nullptr ? "" : problem_of(lesson)->text();
}

/// The problem with the lesson above after one replacement in its text.
std::string with_edit(const std::string& from, const std::string& to) {
    return problem_of_text(replaced(every_block, from, to));
}

}  // namespace

TEST_CASE("a range includes its last value, however its step is rounded", "[lesson]") {
    const auto [range, count, last] =
        GENERATE(table<const char*, std::size_t, double>({{"0 to 0.3 step 0.1", 4, 0.3},
                                                          {"0.1 to 0.7 step 0.1", 7, 0.7},
                                                          {"1 to 2.1 step 0.1", 12, 2.1},
                                                          {"10 to 80 step 5", 15, 80},
                                                          {"0.05 to 0.95 step 0.3", 4, 0.95},
                                                          {"0 to 1 step 0.3", 4, 0.9}}));
    const Lesson lesson = read(replaced(every_block, "10 to 30 step 10", range));
    for (const LessonStep& step : lesson.steps)
        for (const LessonPart& part : step.parts)
            if (const auto* exercise = std::get_if<Exercise>(&part)) {
                REQUIRE(exercise->variables[0].values.size() == count);
                CHECK(exercise->variables[0].values.back() == Approx(last));
            }
}

TEST_CASE("a lesson's header and steps are parsed", "[lesson]") {
    const Lesson lesson = read(every_block);
    CHECK(lesson.title == "Lambert's law");
    CHECK(lesson.name == "05-lambert");
    CHECK(lesson.topic == "Diffuse reflection");
    CHECK(lesson.scene == "scenes/cosine-law.json");
    CHECK(lesson.size == PictureSize{320, 180});
    CHECK(lesson.rows == std::vector<int>{13, 14});
    CHECK(lesson.questions == std::vector<int>{1, 2});
    REQUIRE(lesson.steps.size() == 2);
    CHECK(lesson.steps[0].title.empty());
    CHECK(lesson.steps[1].title == "Tilt it");
    CHECK(lesson.steps[1].set == std::vector<Assignment>{{"/lights/0/position", "[0,1,0]"}});
    CHECK(lesson.steps[1].picture == std::vector<Assignment>{{"/lights/0/enabled", "false"}});
    CHECK(lesson.steps[1].parts.size() == 8);
}

TEST_CASE("a lesson's text keeps its styles, lists and links", "[lesson]") {
    const Lesson lesson = read(every_block);
    const auto& prose = std::get<std::vector<ProseBlock>>(lesson.steps[0].parts.at(0));
    REQUIRE(prose.size() == 4);
    std::string text;
    for (const ProseSpan& span : prose[0].spans)
        text += fmt::format("[{}{}{}{}|{}]", span.emphasis ? "e" : "", span.strong ? "s" : "",
                            span.code ? "c" : "", span.link, span.text);
    CHECK(text == "[|A ][e|plate][| is ][s|lit][|; see ][https://example.org|there][| for ][c|n·l][|.]");
    CHECK((prose[1].kind == ProseKind::Item && prose[1].level == 1 && prose[1].number == 1));
    CHECK((prose[2].kind == ProseKind::Item && prose[2].level == 1 && prose[2].number == 2));
    CHECK((prose[3].kind == ProseKind::Item && prose[3].level == 2 && prose[3].number == -1));
}

TEST_CASE("each block of a lesson is parsed into a part of the corresponding kind", "[lesson]") {
    const std::vector<LessonPart> parts = read(every_block).steps[1].parts;
    const auto& number = std::get<Prediction>(parts.at(0));
    CHECK(number.kind == PredictionKind::Number);
    CHECK(number.question == "How bright is the plate at 60 degrees?");
    REQUIRE(number.runs.size() == 1);
    CHECK(number.runs[0].kind == RunKind::Explain);
    CHECK(number.runs[0].from == glm::ivec2(10, 20));
    CHECK(number.runs[0].size == PictureSize{64, 48});
    CHECK(number.runs[0].set == std::vector<Assignment>{{"/shading/mode", "flat"}});
    CHECK(number.answer.text() == "e.lights[0].n_dot_l");
    CHECK((number.unit == "of the light" && number.term == "lights[0].n_dot_l"));
    const auto& reveal = std::get<Reveal>(parts.at(1));
    CHECK(reveal.pick == glm::ivec2(10, 20));
    CHECK(reveal.along == std::pair(glm::ivec2(0, 9), glm::ivec2(63, 9)));
    CHECK((reveal.play == "/lights/0/position/1" && reveal.play_from == 1 && reveal.play_to == 2));
    CHECK(std::holds_alternative<std::vector<ProseBlock>>(parts.at(2)));
    const auto& choice = std::get<Prediction>(parts.at(3));
    REQUIRE(choice.options.size() == 2);
    CHECK((choice.options[1].text == "no" && choice.options[1].is_right.text() == "c.max_error = 0"));
    CHECK((choice.runs[2].first == "a" && choice.runs[2].second == "b"));
    CHECK(std::get<Prediction>(parts.at(4)).to == glm::ivec2(63, 9));
    const auto& task = std::get<Task>(parts.at(5));
    CHECK(task.controls == std::vector<std::string>{"/lights/0/position"});
    const auto& claim = std::get<Claim>(parts.at(6));
    CHECK(claim.checks.size() == 2);
    CHECK(claim.falls_under == std::vector<std::string>{"missing_pi", "absolute_cosine"});
    CHECK((claim.runs[0].roughness == 0.2 && claim.runs[0].rays == 100));
}

TEST_CASE("an exercise replaces its variables with numbers everywhere", "[lesson]") {
    const auto exercise = std::get<Exercise>(read(every_block).steps[1].parts.at(7));
    REQUIRE(exercise.variables.size() == 2);
    CHECK(exercise.variables[0].values == std::vector<double>{10, 20, 30});
    CHECK(exercise.variables[1].values == std::vector<double>{0.5, 0.25});
    const auto made = exercise_with(exercise, {20, 0.25}, "l.md");
    REQUIRE(problem_of(made) == nullptr);
    const auto& instance = std::get<ExerciseInstance>(made);
    CHECK(instance.question == "20 degrees and 0.25?");
    CHECK(instance.set == std::vector<Assignment>{{"/objects/0/transform", R"({"rotate_deg":[20,40,0]})"}});
    CHECK(std::get<double>(instance.closed.number(instance.values)) == Approx(0.25 * 0.9396926));
}

TEST_CASE("an error in a lesson is reported on one line with its line number", "[lesson][bad-input]") {
    CHECK(with_edit("topic: Diffuse reflection\n", "") ==
          "l.md:3: the block has no line \"topic:\"; expected one");
    CHECK(with_edit("rows: 13 14", "rows: 13 x") == "l.md:7: \"x\" is not a number; expected a number");
    CHECK(with_edit("size: 320x180", "size: 320") ==
          "l.md:6: \"320\" is not a size; expected WIDTHxHEIGHT as in 640x360, at most 2048x2048");
    CHECK(with_edit("```predict number", "```predcit number") ==
          "l.md:24: there is no block \"predcit\"; expected \"predict\", or \"text\" for a block that "
          "is only shown");
    CHECK(with_edit("```predict number", "```predict numbers") ==
          "l.md:24: predict \"numbers\" is not known; expected number, choice, click, sketch, colour");
    CHECK(with_edit("tolerance: 0.02", "tolarance: 0.02") ==
          "l.md:29: unknown key \"tolarance\"; expected \"tolerance\"");
    CHECK(with_edit("e = explain --pixel 10,20", "e = explian --pixel 10,20") ==
          "l.md:27: \"explian\" is not a run; expected \"explain\"");
    CHECK(with_edit("--pixel 10,20", "--pixle 10,20") ==
          "l.md:27: \"--pixle\" is not an option of explain; expected \"--pixel\"");
    CHECK(with_edit("--pixel 10,20", "") == "l.md:27: explain has no --pixel; expected --pixel X,Y");
    CHECK(with_edit("answer: e.lights[0].n_dot_l", "answer: f.lights[0].n_dot_l") ==
          "l.md:28: \"f\" is not known; expected \"e\"");
    CHECK(with_edit("answer: e.lights[0].n_dot_l", "answer: e.lights[0") ==
          "l.md:28: \"e.lights[0\" ends too early; expected \"]\"");
    CHECK(with_edit("set: /display/exposure=2", "set: display=2").starts_with("l.md:35: "));
    CHECK(with_edit("play: /lights/0/position/1 1 to 2", "play: /a 1 2").starts_with("l.md:38: "));
    CHECK(with_edit("c = compare a b", "c = compare a z") ==
          "l.md:47: \"z\" is not a picture; expected an earlier render run");
    CHECK(with_edit("if: c.max_error > 0\n", "") ==
          "l.md:49: the option above has no condition; expected a line if: after it");
    CHECK(with_edit("along: 0,9 63,9", "along: 9,9 9,9")
              .ends_with("\"9,9 9,9\" is one pixel; expected two different pixels"));
    CHECK(with_edit("done: e.hit\n", "") == "l.md:62: the block has no line \"done:\"; expected one");
    CHECK(with_edit("falls_under: missing_pi", "falls_under: missing_p") ==
          "l.md:76: \"missing_p\" is not a mistake; expected \"missing_pi\"");
    CHECK(with_edit("vary: deg = 10 to 30 step 10", "vary: deg = 10 to 30 step -1").starts_with("l.md:80: "));
    CHECK(with_edit("vary: deg = 10 to 30 step 10", "vary: deg = 10 to 30 step 10\nvary: deg = 1") ==
          "l.md:81: \"deg\" is already varied; expected a different name");
    CHECK(with_edit("closed: k * cos(deg)", "closed: k * cos(dag)") ==
          "l.md:87: \"dag\" is not known; expected \"deg\"");
    CHECK(with_edit("{2 * deg}", "{2 * dag}") ==
          "l.md:83: \"2 * dag\": \"dag\" is not known; expected \"deg\"");
    CHECK(with_edit("option: no\n", "option: no\nmistake: missing_p\n") ==
          "l.md:51: \"missing_p\" is not a mistake; expected \"missing_pi\"");
    CHECK(with_edit("# Lambert's law", "Lambert") ==
          "l.md:1: the lesson has no title; expected a line # TITLE");
    CHECK(problem_of_text("# T\n\n## Step\n") ==
          "l.md:3: the block \"lesson\" is missing above; expected its topic and its scene");
    CHECK(problem_of_text("# T\n\n\xff\n") == "l.md:3: the text is not UTF-8; expected UTF-8");
    CHECK(with_edit("# Lambert's law\n", "# Lambert's law\r\n").empty());
}

TEST_CASE("a lesson's run accepts the command line's integers, and each option only once",
          "[lesson][bad-input]") {
    CHECK(with_edit("--object 1", "--object 0.7") ==
          "l.md:73: \"0.7\" is not a whole number; expected 0 to 9999");
    CHECK(with_edit("--object 1", "--object -1") == "l.md:73: \"-1\" is out of range; expected 0 to 9999");
    CHECK(with_edit("--object 1", "--object 99999999999") ==
          "l.md:73: \"99999999999\" is out of range; expected 0 to 9999");
    CHECK(with_edit("--rays 100", "--rays 1.9") ==
          "l.md:72: \"1.9\" is not a whole number; expected 1 to 100000");
    CHECK(with_edit("--rays 100", "--facets 10.5") ==
          "l.md:72: \"10.5\" is not a whole number; expected 4 to 100000");
    CHECK(with_edit("--angle 30", "--angle 89.9").empty());
    CHECK(with_edit("--angle 30", "--angle 89.95") ==
          "l.md:73: \"89.95\" is out of range; expected 0 to 89.9");
    CHECK(with_edit("--rays 100", "--angle 89 --view 89").empty());
    CHECK(with_edit("--rays 100", "--angle 89.5") == "l.md:72: \"89.5\" is out of range; expected 0 to 89");
    CHECK(with_edit("--pixel 10,20", "--pixel 10,20 --pixel 30,40") ==
          "l.md:27: --pixel is given twice; expected it only once");
    CHECK(with_edit("--size 64x48", "--set /display/exposure=2 --size 64x48").empty());
}

TEST_CASE("a line that does not apply to its kind of prediction is rejected", "[lesson][bad-input]") {
    CHECK(with_edit("unit: of the light", "along: 0,9 63,9") ==
          "l.md:30: \"along\" is not allowed in predict number; expected question, answer, tolerance, term, "
          "wrong, thinks, unit");
    CHECK(with_edit("answer: p.intensity", "unit: of the light\nanswer: p.intensity") ==
          "l.md:57: \"unit\" is not allowed in predict sketch; expected question, answer, tolerance, term, "
          "wrong, thinks, along");
    CHECK(with_edit("option: no\n", "option: no\nanswer: 1\n") ==
          "l.md:51: \"answer\" is not allowed in predict choice; expected question, option, if, thinks, "
          "mistake");
}

TEST_CASE("a lesson that cannot be read is reported with the reason", "[lesson][bad-input]") {
    const TemporaryDirectory directory;
    const Result<Lesson> missing = read_lesson(directory.path("none.md"));
    REQUIRE(problem_of(missing) != nullptr);
    CHECK(problem_of(missing)->text().find("no such file") != std::string::npos);
    const std::string path = directory.file("long.md", std::string(max_lesson_bytes + 1, 'x'));
    CHECK(problem_of(read_lesson(path)) != nullptr);
    CHECK(problem_of(lesson_files({directory.path("nowhere/")})) == nullptr);  // does not exist yet
}

TEST_CASE("a folder's lessons are listed by name, without other files", "[lesson]") {
    const TemporaryDirectory directory;
    for (const char* const name : {"10-b.md", "02-a.md", "notes.txt"}) (void)directory.file(name, "x");
    const auto files = std::get<std::vector<std::string>>(lesson_files({directory.path()}));
    CHECK(files == std::vector<std::string>{directory.path("02-a.md"), directory.path("10-b.md")});
}

TEST_CASE("no lesson file crashes the program", "[lesson][fuzz]") {
    CHECK(problem_of_text("# T\n" + std::string(60000, '>')).find("nested too deeply") != std::string::npos);
    std::string deep = "# T\n";
    for (int i = 0; i < 100; ++i) deep += std::string(static_cast<std::size_t>(i) * 2, ' ') + "- x\n";
    CHECK(problem_of_text(deep).find("nested too deeply") != std::string::npos);
    std::string many = "# T\n\n";
    for (int i = 0; i < 5000; ++i) many += "x\n\n";
    CHECK(problem_of_text(many).find("too long") != std::string::npos);
    std::mt19937 random(3);
    int read_well = 0;
    for (int i = 0; i < 1500; ++i) {
        std::string text = every_block;
        for (auto edits = random() % 8 + 1; edits > 0; --edits) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
            case 0:
                text[at] = static_cast<char>(random() % 256);
                break;
            case 1:
                text.erase(at, random() % 40);
                break;
            case 2:
                text.insert(at, text.substr(random() % text.size(), random() % 60));
                break;
            default:
                text.insert(at, std::string(random() % 200, "`>[(*-#\n \0"[random() % 10]));
            }
        }
        const Result<Lesson> lesson = parse_lesson(text, "l.md");
        if (const Problem* problem = problem_of(lesson))
            CHECK(problem->file == "l.md");
        else
            ++read_well;
    }
    CHECK(read_well > 20);
}
