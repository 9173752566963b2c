// Tests of shadows, bounced light and form factors on the command line.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "models/fields/choices.h"
#include "programs/program.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

const std::string two_plates = project_file("assets/scenes/two-plates.json");
const std::string shadow_hard = project_file("assets/scenes/shadow-hard.json");

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// The error message, which must be one line; empty if anything was printed on standard output.
std::string refusal(const std::vector<std::string>& arguments) {
    const Ended ended = run_glint(arguments);
    CHECK(ended.status != 0);
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
    return ended.out.empty() ? ended.err : "";
}

}  // namespace

TEST_CASE("an invalid number or word in /transport gives a one-line error", "[cli][transport]") {
    const auto with = [](const std::string& assignment) {
        return refusal({"render", shadow_hard, "-o", "-", "--set", assignment});
    };
    CHECK(contains(with("/transport/model=global"), "expected local, shadows or bounces"));
    CHECK(contains(with("/transport/paths=0"), "expected a whole number from 1 to 65536"));
    CHECK(contains(with("/transport/paths=65537"), "65537 is out of range"));
    CHECK(contains(with("/transport/bounces=65"), "expected a whole number from 0 to 64"));
    CHECK(contains(with("/transport/seed=-1"), "/transport/seed"));
}

TEST_CASE("Ctrl+C during a render with many paths leaves no file behind", "[cli][transport]") {
    const TemporaryDirectory folder;
    const Ended ended = run_glint({"render", shadow_hard, "-o", folder.path("x.png"), "--set",
                                   "/transport/model=bounces", "--set", "/transport/paths=65536"},
                                  {}, {}, {"/usr/bin/timeout", "--preserve-status", "-k9", "-sINT", "0.5"});
    CHECK(ended.status == 128 + SIGINT);
    CHECK(ended.out.empty());
    CHECK(folder.names().empty());
}

TEST_CASE("glint formfactor prints the estimate, its standard error and the ray count", "[cli][transport]") {
    const Ended text =
        run_glint({"formfactor", two_plates, "--from", "Lower", "--to", "Upper", "--rays", "100000"});
    CHECK(text.status == 0);
    CHECK(text.out.starts_with("Lower to Upper: 0."));
    CHECK(contains(text.out, "100000 rays"));
    const Ended answer = run_glint({"formfactor", two_plates, "--from", "0", "--to", "1", "--format", "json",
                                    "--rays", "100000", "--threads", "1"});
    REQUIRE(answer.status == 0);
    const auto json = nlohmann::json::parse(answer.out);
    const double factor = json.at("form_factor"), error = json.at("standard_error");
    CHECK(std::abs(factor - 0.199825) < 4 * error);
    CHECK(error == Approx(std::sqrt(0.2 * 0.8 / 1e5)).epsilon(0.05));
    CHECK(json.at("rays") == 100000);
    CHECK(json.at("from") == "Lower");
    const std::string unknown = refusal({"formfactor", two_plates, "--from", "Lowr", "--to", "Upper"});
    CHECK(contains(unknown, "no object is named \"Lowr\""));
    CHECK(contains(unknown, "Lower"));
    CHECK(contains(refusal({"formfactor", two_plates, "--from", "Lower"}), "--to"));
}

TEST_CASE("glint code refuses a scene with shadows in every language", "[cli][transport][programs]") {
    for (const char* language : {"gl1", "glsl", "cpp", "python"}) {
        const TemporaryDirectory folder;
        const std::string refused =
            refusal({"code", shadow_hard, "--language", language, "-o", folder.path("out")});
        CHECK(contains(refused, "/transport/model"));
        CHECK(contains(refused, language));
        CHECK(contains(refused, "no language supports it"));
    }
}

TEST_CASE("glint explain names the object that casts the shadow", "[cli][transport][explain]") {
    const std::vector<std::string> at = {"explain", shadow_hard, "--size", "480x270", "--pixel", "255,150"};
    const Ended text = run_glint(at);
    REQUIRE(text.status == 0);
    CHECK(contains(text.out, "in the shadow of Box"));
    CHECK(contains(text.out, " · reach 0"));
    CHECK(text.out.find("in the shadow of") == text.out.rfind("in the shadow of"));
    std::vector<std::string> as_json = at;
    as_json.insert(as_json.end(), {"--format", "json"});
    const auto light = nlohmann::json::parse(run_glint(as_json).out).at("lights").at(0);
    CHECK(light.at("reached") == 0);
    CHECK(light.at("blocked_by") == "Box");
    CHECK(light.at("blocker") == 0);
    CHECK(light.at("share") == nlohmann::json({0, 0, 0}));
    std::vector<std::string> as_latex = at;
    as_latex.insert(as_latex.end(), {"--format", "latex"});
    CHECK(contains(run_glint(as_latex).out, "in the shadow of Box"));
}

// Tests of glint code as a user runs it.
namespace fs = std::filesystem;

namespace {

const char* const lit_ball =
    R"({"glint": 1, "about": "a \\ ball /* ??/", "lights": [{"name": "for", "type": "point"},
    {"name": "9 ü\n lamps"}, {"name": "9"}], "objects": [{"name": "main"}, {"name": "int"}]})";

Ended code(const std::string& scene, const std::string& language, const std::string& out,
           std::vector<std::string> more = {}) {
    std::vector<std::string> words{"code", "-", "--language", language, "-o", out};
    words.insert(words.end(), more.begin(), more.end());
    return run_glint(words, scene);
}

}  // namespace

TEST_CASE("glint code writes the files of a program into a new or empty directory", "[cli][programs]") {
    const TemporaryDirectory folder;
    fs::create_directory(folder.path("empty"));
    for (const char* out : {"new", "empty"}) {
        const Ended ended = code(lit_ball, "cpp", folder.path(out), {"--size", "64x48"});
        CHECK(ended.err.empty());
        CHECK(ended.out.empty());
        REQUIRE(ended.status == 0);
        CHECK(fs::exists(folder.path(std::string(out) + "/sphere.mesh")));
        const std::string text = bytes_of(folder.path(std::string(out) + "/main.cpp"));
        CHECK(text.find("width = 64, height = 48;") != std::string::npos);
        CHECK(text.find('@') == std::string::npos);
    }
}

TEST_CASE("a program's names are the scene's names turned into valid identifiers", "[cli][programs]") {
    const TemporaryDirectory folder;
    REQUIRE(code(lit_ball, "cpp", folder.path("new")).status == 0);
    const std::string text = bytes_of(folder.path("new/main.cpp"));
    for (const char* line :
         {"const Light for_light = ", "const Light light_9_lamps = ", "const Light light_9 = ",
          "const Object main_object = ", "const Object int_object = "}) {
        INFO(line);
        CHECK(text.find(line) != std::string::npos);
    }
    CHECK(text.substr(0, text.find('\n')).find('\\') == std::string::npos);
}

TEST_CASE("glint code reports an error in one line and leaves no file behind", "[cli][programs]") {
    const TemporaryDirectory folder;
    const std::string file = folder.file("file", "full");
    const auto refused = [](const Ended& ended, int status, const std::string& line) {
        INFO(ended.err);
        CHECK(ended.status == status);
        CHECK(ended.out.empty());
        CHECK(ended.err.starts_with("glint: error: " + line));
        CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
    };
    refused(code(lit_ball, "pascal", folder.path("new")), 2, "--language: pascal is not known; expected ");
    refused(run_glint({"code", "-", "-o", folder.path("new")}, lit_ball), 2,
            "--language: is missing; expected ");
    refused(run_glint({"code", "-", "--language", "cpp"}, lit_ball), 2, "-o: is missing; expected ");
    refused(code(lit_ball, "cpp", file), 1, file + ": is not a directory; expected ");
    refused(code(lit_ball, "cpp", folder.path()), 1, folder.path() + ": is not empty; expected ");
    refused(code(lit_ball, "cpp", folder.path("a/b")), 1,
            folder.path("a/b") + ": cannot be created: no such file");
    refused(code(lit_ball, "cpp", "/proc/glint"), 1, "/proc/glint: cannot be created: ");
    refused(
        code(lit_ball, "cpp", folder.path("new"), {"--set", "/npr/creases=true"}), 1,
        "-: /npr: silhouettes or creases are drawn, which cpp does not support; expected a scene without it");
    std::string many = R"({"glint": 1, "objects": [{})";
    for (int i = 0; i < 300; ++i) many += ", {}";
    refused(code(many + "]}", "python", folder.path("new")), 1, "-: the program would have ");
    CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("generated programs have code for every reflection model", "[programs]") {
    for (const Reflection model : enumerators<Reflection>) {
        const ReflectionInfo& info = info_of(model);
        const std::string text = info.program;
        CAPTURE(std::string(info.choice.word));
        CHECK((text.find("diffuse = ") != std::string::npos) == info.is_lit);
        CHECK((text.find("S = ") != std::string::npos) == (info.is_lit && info.has_highlight));
    }
}
