// Tests of glint shade and glint grade as a user runs them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "models/json/json.h"
#include "renderer/image/image_file.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

const std::string scene_path = project_file("assets/scenes/still-life.json");
constexpr const char* picture_size = "96x72";
constexpr const char* normals_as_color = "vec3 lit(vec3 p, vec3 n) { return 0.5 * n + 0.5; }\n";

Ended shade(const TemporaryDirectory& folder, const std::string& shader,
            const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"shade",  scene_path,  "--shader", shader, "-o", folder.path("out.png"),
                                   "--size", picture_size};
    words.insert(words.end(), more.begin(), more.end());
    if (std::find(more.begin(), more.end(), "--timeout") == more.end())
        words.insert(words.end(), {"--timeout", "300"});  // long enough even on a busy machine
    return run_glint(words);
}

/// The messages on standard error when this shader is drawn, without the folder's path.
std::string said_of(const std::string& text, const std::vector<std::string>& more = {}) {
    const TemporaryDirectory folder;
    std::string said = shade(folder, folder.file("a.glsl", text), more).err;
    for (std::size_t at; (at = said.find(folder.path() + "/")) != said.npos;)
        said.erase(at, folder.path().size() + 1);
    const std::vector<std::string> names = folder.names();
    const bool is_drawn = std::find(names.begin(), names.end(), "out.png") != names.end();
    CHECK(is_drawn == (said.find("error") == said.npos));
    return said;
}

std::string lighting(const TemporaryDirectory& folder, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"code", scene_path, "--language", "glsl", "-o", folder.path("code")};
    words.insert(words.end(), more.begin(), more.end());
    REQUIRE(run_glint(words).status == 0);
    return bytes_of(folder.path("code/lighting.glsl"));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != text.npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("glint shade with the shader from glint code matches glint render", "[cli][shader]") {
    const TemporaryDirectory folder;
    const Ended ended = shade(folder, folder.file("a.glsl", lighting(folder)));
    CHECK(ended.err == "");
    REQUIRE(ended.status == 0);
    REQUIRE(
        run_glint({"render", scene_path, "-o", folder.path("right.png"), "--size", picture_size}).status ==
        0);
    const Ended diagnosed = run_glint({"diagnose", scene_path, folder.path("out.png")});
    CHECK(diagnosed.out.starts_with("No mistake"));
    const auto mine = std::get<Picture>(read_png(folder.path("out.png"))),
               right = std::get<Picture>(read_png(folder.path("right.png")));
    const auto differs = [&](std::size_t i) { return std::abs(mine.rgba[i] - right.rgba[i]) > 2; };
    int unlike = 0;
    for (std::size_t i = 0; i < mine.rgba.size(); ++i) unlike += differs(i);
    CHECK(unlike < 200);  // out of 27,648 values; edge pixels may differ
}

TEST_CASE("errors in a shader name the user's file and line", "[cli][shader]") {
    CHECK(said_of("#version 330 core\nvec3 lit(vec3 p, vec3 n) {\n  float x = foo;\n  return bar(x);\n}\n") ==
          "glint: error: a.glsl:3: `foo' undeclared\n"
          "glint: error: a.glsl:4: no function with name 'bar'\n");
    CHECK(said_of("vec3 lit(vec3 p, vec3 n) {\n  float x = 1\n  return n;\n}\n") ==
          "glint: error: a.glsl:3: syntax error, unexpected RETURN, expecting ',' or ';'\n");
    for (const char* text : {"", "vec3 light(vec3 p, vec3 n) { return n; }", "vec3 lit(vec3 p) { return p; }",
                             "vec3 lit(vec3 p, vec3 n);"})
        CHECK(said_of(text) ==
              "glint: error: a.glsl: there is no function that can be called as lit(vec3 p, vec3 n); "
              "expected vec3 lit(vec3 p, vec3 n)\n");
    CHECK(said_of("vec3 lit(vec3 p, vec3 n) {\n  return n;\n") ==
          "glint: error: a.glsl:2: the file ends within a function, a declaration or a comment\n");
    CHECK(said_of("uniform vec3 light_count;\nvec3 lit(vec3 p, vec3 n) { return light_count; }") ==
          "glint: error: a.glsl: the uniform light_count is vec3; expected int\n");
}

TEST_CASE("a shader with an endless loop is reported at once", "[cli][shader]") {
    const std::string begin = "vec3 lit(vec3 p, vec3 n) {\n  float x = p.x;\n",
                      end = "\n  return vec3(x);\n}\n";
    for (const char* loop :
         {"while (true) x += 1.0;", "for (;;) { x = sin(x); }",
          "for (int i = 0; i < 1000000; ++i) x += sin(x);", "do x = cos(x); while (x < 2.0);"}) {
        INFO(loop);
        CHECK(said_of(std::string(begin).append(loop).append(end))
                  .starts_with(
                      "glint: error: a.glsl: its loops run more than 60000 times in a pixel, such as "));
    }
    CHECK(said_of(begin + "for (int i = 0; i < 1000; ++i) x += 0.001;" + end) == "");
}

TEST_CASE("a shader that takes too long is stopped", "[cli][shader]") {
    std::string bomb =
        "#define A x = sin(x) + cos(x * p.y);\n";  // 4^9 statements, which take minutes to compile
    for (char c = 'B'; c < 'K'; ++c)
        bomb += std::string("#define ") + c + std::string(4, ' ') + std::string(1, char(c - 1)) + " " +
                char(c - 1) + " " + char(c - 1) + " " + char(c - 1) + "\n";
    CHECK(said_of(bomb + "vec3 lit(vec3 p, vec3 n) { float x = p.x; J return vec3(x); }",
                  {"--timeout", "0.5"}) == "glint: error: a.glsl: it did not end within 0.5 s\n");
}

TEST_CASE("non-finite and discarded pixels are counted", "[cli][shader]") {
    CHECK(said_of("vec3 lit(vec3 p, vec3 n) { return sqrt(vec3(-1.0 - p.x * p.x)); }")
              .find("glint: warning: a.glsl: lit() returns NaN or an infinity in ") == 0);
    CHECK(said_of("vec3 lit(vec3 p, vec3 n) { if (p.x > 0.0) discard; return n; }")
              .find("glint: warning: a.glsl: nothing is drawn (discard) in ") == 0);
    CHECK(said_of("uniform float time;\nvec3 lit(vec3 p, vec3 n) { return time + n; }") ==
          "glint: warning: a.glsl: the uniform time is not set\n");
    CHECK(said_of("vec3 lit(vec3 p, vec3 n) { return -abs(n); }") ==
          "glint: warning: a.glsl: lit() returns black in all pixels, so nothing is lit yet. Begin with "
          "material.ambient * global_ambient, then add one light\n");
}

TEST_CASE("a file that is not a shader is reported in one line", "[cli][shader]") {
    const std::vector<char> spaces(10'000'000, ' ');
    CHECK(said_of({spaces.begin(), spaces.end()}) ==
          "glint: error: a.glsl: is too long; expected at most 1048576 bytes\n");
    CHECK(said_of(std::string("vec3\n\0\1\x7f", 8)) ==
          "glint: error: a.glsl:2: it is not text; expected a GLSL file\n");
    const TemporaryDirectory folder;
    CHECK(shade(folder, folder.path("none.glsl")).status == 1);
    CHECK(folder.names().empty());
}

TEST_CASE("glint shade writes linear pictures and buffers that glint check accepts", "[cli][shader]") {
    const TemporaryDirectory folder;
    const std::string file = folder.file("a.glsl", lighting(folder));
    REQUIRE(run_glint({"shade", scene_path, "--shader", file, "-o", folder.path("code/x.pfm"), "--buffers",
                       folder.path(), "--size", picture_size})
                .status == 0);
    for (const char* name : {"sum.pfm", "position.pfm", "normal.pfm"})
        CHECK(bytes_of(folder.path(name)).size() > 96 * 72 * 12);
    const Ended checked = run_glint({"check", scene_path, folder.path()});
    CHECK(checked.out.find("Nothing differs.") != checked.out.npos);
    CHECK(checked.status == 0);
}

TEST_CASE("a scene that shaders cannot draw is refused, with a JSON pointer to the cause", "[cli][shader]") {
    const TemporaryDirectory folder;
    const std::string file = folder.file("a.glsl", normals_as_color);
    CHECK(shade(folder, file, {"--set", "/shading/reflection=none"}).err ==
          "glint: error: " + scene_path +
              ": /shading/reflection: nothing is lit; expected a reflection model such as phong\n");
    CHECK(shade(folder, file, {"--set", "/shading/interpolation=scanline"}).status == 1);
}

TEST_CASE("glint code --blank leaves steps to fill in and works only for shaders", "[cli][programs]") {
    const TemporaryDirectory folder;
    const std::string text = lighting(folder, {"--blank"});
    CHECK(text.find("// Step: ") != text.npos);
    CHECK(text.find("power(dot(") == text.npos);
    CHECK(run_glint({"code", scene_path, "--blank", "--language", "cpp", "-o", folder.path("new")}).status ==
          2);
}

TEST_CASE("glint grade names the mistakes in shaders and pictures", "[cli][shader]") {
    const TemporaryDirectory folder;
    const std::string right = lighting(folder);
    const std::string wrong = replaced(right, "2.0 * n_l * n - l", "l - 2.0 * n_l * n");
    REQUIRE(run_glint({"render", scene_path, "--size", "160x120", "-o", folder.path("picture.png"),
                       "--no-scene", "--set", "/shading/mistakes/unnormalized_light=true"})
                .status == 0);
    const std::string rubric =
        folder.file("rubric.json",
                    R"({"points": 10, "mistakes": {"reflect_sign": {"points": 7, "hint": "Mind, the sign."}},
            "verdicts": {"does not compile": {"points": 1}}})");
    const auto grade = [&](const char* format) {
        return run_glint({"grade", scene_path, folder.file("right.glsl", right),
                          folder.file("wrong.glsl", wrong), folder.path("picture.png"),
                          folder.file("typo.glsl", "vec3 lit(vec3 p, vec3 n) { retrun n; }"),
                          folder.file("loop.glsl", "vec3 lit(vec3 p, vec3 n) { while (true); return n; }"),
                          "--size", "160x120", "--timeout", "300", "--rubric", rubric, "--format", format});
    };
    const Ended ended = grade("json");
    CHECK(ended.err == "");
    CHECK(ended.status == 0);
    std::vector<Json> rows;
    for (std::size_t at = 0, end; (end = ended.out.find('\n', at)) != ended.out.npos; at = end + 1)
        rows.push_back(Json::parse(ended.out.substr(at, end - at)));
    REQUIRE(rows.size() == 5);
    CHECK(rows[0]["verdict"] == "no mistake");
    CHECK(rows[0]["points"] == 10);
    CHECK(rows[1]["mistake"] == "specular term");  // the picture has no highlight
    CHECK(rows[1]["points"] == 7);
    CHECK(rows[1]["hint"] == "Mind, the sign.");
    CHECK(rows[1]["pixel"].size() == 2);
    CHECK(rows[2]["mistake"] == "unnormalized_light");
    CHECK(rows[2]["text"].get<std::string>().find(" Look in your program for l = unit(light - p).") !=
          std::string::npos);
    CHECK(rows[2]["points"] == 0);
    CHECK(rows[3]["verdict"] == "does not compile");
    CHECK(rows[3]["points"] == 1);
    CHECK(rows[3]["messages"][0].get<std::string>().find("typo.glsl:1: ") != std::string::npos);
    CHECK(rows[4]["verdict"] == "does not end");
    CHECK_FALSE(rows[0].contains("picture_html"));

    const std::string html = grade("html").out, csv = grade("csv").out, junit = grade("junit").out,
                      text = grade("text").out;
    for (const std::string& table : {html, csv, junit, text}) {
        CHECK(table.find("specular term") != table.npos);
        CHECK(table.find("Mind, the sign.") != table.npos);
    }
    const auto count = [&html](const std::string& word) {
        std::size_t n = 0;
        for (std::size_t at = 0; (at = html.find(word, at)) != html.npos; ++at) ++n;
        return n;
    };
    CHECK(count("<img ") == 6);  // a submitted and a correct picture for each of the three that were drawn
    CHECK(count("http") == 0);
    CHECK(csv.find("\"Mind, the sign.\"") != csv.npos);
    CHECK(junit.find("tests=\"5\" failures=\"4\" errors=\"0\"") != junit.npos);
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 6);
}

TEST_CASE("the verdict on a blank shader says that nothing is lit, and where to begin", "[cli][shader]") {
    const TemporaryDirectory folder;
    const std::string blank = folder.file("blank.glsl", lighting(folder, {"--blank"}));
    for (const auto& [scene, says] : {std::pair{"still-life", "nothing is lit yet"},
                                      {"every-term", "nothing is lit"},
                                      {"glossy-ball", "All lights are off"}}) {
        const std::string path = project_file("assets/scenes/" + std::string(scene) + ".json");
        const Json row =
            Json::parse(run_glint({"grade", path, blank, "--size", "160x120", "--format", "json"}).out);
        const auto text = row["text"].get<std::string>();
        INFO(scene << ": " << text);
        CHECK(text.find(says) != text.npos);
        CHECK(row["messages"][0].get<std::string>().find("Begin with material.ambient") != std::string::npos);
    }
}

TEST_CASE("glint grade exits with status 1 if a file cannot be graded", "[cli][shader]") {
    const TemporaryDirectory folder;
    const Ended ended =
        run_glint({"grade", scene_path, folder.file("a.png", "not a picture"),
                   folder.file("a.jpg", "not a shader"), folder.path("none.glsl"), "--format", "csv"});
    CHECK(ended.status == 1);
    CHECK(ended.err == "");
    CHECK(ended.out.find("a.png,not judged,") != ended.out.npos);
    CHECK(ended.out.find("none.glsl,not judged,") != ended.out.npos);
    CHECK(ended.out.find("a.jpg: cannot be read; expected a picture whose name ends in .png, .pfm or .exr") !=
          ended.out.npos);
}

TEST_CASE("a rubric with an unknown mistake is refused, as is an unreadable scene", "[cli][shader]") {
    const TemporaryDirectory folder;
    const std::string file = folder.file("a.glsl", normals_as_color),
                      rubric = folder.file("r.json", R"({"mistakes": {"reflect_sin": {"points": 1}}})");
    const Ended ended = run_glint({"grade", scene_path, file, "--rubric", rubric});
    CHECK(ended.status == 1);
    CHECK(ended.err ==
          "glint: error: " + rubric +
              ": /mistakes/reflect_sin: unknown key \"reflect_sin\"; expected \"reflect_sign\"\n");
    CHECK(run_glint({"grade", folder.path("none.json"), file}).status == 1);
    CHECK(run_glint({"grade", "-", file, "--format", "csv"}, bytes_of(scene_path)).status == 0);
    CHECK(run_glint({"grade", scene_path}).status == 2);
}
