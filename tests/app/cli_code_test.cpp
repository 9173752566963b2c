// Tests of glint code as a user runs it.
#include <algorithm>
#include <filesystem>
#include <string>

#include "models/fields/choices.h"
#include "programs/program.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;
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
    refused(code(lit_ball, "cpp", folder.path("new"), {"--set", "/npr/creases=true"}), 1,
            "-: /npr: silhouettes or creases are drawn, which cpp cannot do; expected a scene without it");
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
