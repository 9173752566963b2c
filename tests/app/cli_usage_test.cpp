// Tests of errors for invalid command lines: the exact message, the exit status, and no standard output.
// The messages are from docs/command_line.md or follow its form.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

const char* const sphere = R"({"glint": 1, "objects": [{"mesh": {"primitive": "sphere", "detail": 12}}],
                              "lights": [{"name": "Bulb", "position": [2, 3, 4]}]})";

struct WrongUsage {
    std::vector<std::string> arguments;
    std::string line;  // without "glint: error: "
};

void check_error(const Ended& ended, int status, const std::string& line) {
    CHECK(ended.status == status);
    CHECK(ended.out.empty());
    CHECK(ended.err == "glint: error: " + line + "\n");
}

}  // namespace

TEST_CASE("incorrect usage gives a one-line error and status 2", "[cli][bad-input]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", sphere), out = directory.path("out.png");
    const std::string sizes = "; expected WIDTHxHEIGHT as in 1280x720, 1x1 to 16384x16384";
    const std::string formats = "; expected a name that ends in .png, .pfm or .exr, or - for standard output";
    const std::vector<WrongUsage> table{
        {{"rendr", "a", "-o", "b"},
         "rendr: neither a command nor a file; expected render or another one listed by glint --help"},
        {{"--size", "10x10"},
         "--size: unknown option of glint; expected --set or another one listed by glint --help"},
        {{""}, "FILE: is empty; expected a scene, a mesh, or - for a scene on standard input"},
        {{"render"}, "FILE: is missing; expected a scene, a mesh, or - for a scene on standard input"},
        {{"render", scene},
         "-o: is missing; expected a file to write, .png, .pfm or .exr, or - for a PNG on standard output"},
        {{"render", scene, "-o"}, "-o: has no value; expected a value after it"},
        {{"render", scene, "-o", "a.bmp"}, "-o: a.bmp cannot be written" + formats},
        {{"render", scene, "-o", "noextension"}, "-o: noextension cannot be written" + formats},
        {{"render", scene, "-o", out, "--sze", "3x3"},
         "--sze: unknown option of glint render; expected --size or another one listed by glint render "
         "--help"},
        {{"render", scene, "-o", out, "--sze=3x3"},
         "--sze: unknown option of glint render; expected --size or another one listed by glint render "
         "--help"},
        {{"explain", scene, "--pixel", "1,1", "--sensitivity", "--format", "latex"},
         "--sensitivity: is not available as LaTeX; expected --format text or json"},
        {{"render", scene, "-o", out, "--size", "640x"}, "--size: 640x is not a picture size" + sizes},
        {{"render", scene, "-o", out, "--size", "0x5"}, "--size: 0x5 is not a picture size" + sizes},
        {{"render", scene, "-o", out, "--size", "1e3x2"}, "--size: 1e3x2 is not a picture size" + sizes},
        {{"render", scene, "-o", out, "--size", "640x480x3"},
         "--size: 640x480x3 is not a picture size" + sizes},
        {{"render", scene, "-o", out, "--size", " 640x480"},
         "--size:  640x480 is not a picture size" + sizes},
        {{"render", scene, "-o", out, "--size", "+640x480"},
         "--size: +640x480 is not a picture size" + sizes},
        {{"render", scene, "-o", out, "--size", "16385x1"}, "--size: 16385x1 is not a picture size" + sizes},
        {{"render", scene, "-o", out, "--size=3x3", "--size", "3x3"},
         "--size: is given twice; expected it only once"},
        {{"render", scene, "-o", out, "--size=99999999999x1"},
         "--size: 99999999999x1 is not a picture size" + sizes},
        {{"render", scene, "again.json", "-o", out},
         "again.json: unexpected argument for glint render; expected the arguments shown by glint render "
         "--help"},
        {{"render", "-o", out, "--", scene, "-o"},
         "-o: unexpected argument for glint render; expected the arguments shown by glint render --help"},
        {{"-j", "2", "render", scene, "-o", out, "-j", "3"},
         "--threads: is given twice; expected it only once"},
        {{"render", scene, "-o", out, "-j", "two"},
         "--threads: two is not a whole number; expected 0 to 1024"},
        {{"render", scene, "-o", out, "-j-1"}, "--threads: -1 is out of range; expected 0 to 1024"},
        {{"render", scene, "-o", out, "--samples", "3"}, "--samples: 3 is not known; expected 1, 2, 4, 8"},
        {{"explain", scene}, "--pixel: is missing; expected X,Y as in --pixel 640,360"},
        {{"explain", scene, "--pixel", "900,20", "--size", "640x480"},
         "--pixel: 900,20 is outside the picture; expected 0 to 639, 0 to 479"},
        {{"explain", scene, "--pixel", "0,480", "--size", "640x480"},  // rows are 0 to 479
         "--pixel: 0,480 is outside the picture; expected 0 to 639, 0 to 479"},
        {{"explain", scene, "--pixel", "640,0", "--size", "640x480"},
         "--pixel: 640,0 is outside the picture; expected 0 to 639, 0 to 479"},
        {{"explain", scene, "--pixel", "-1,5"},
         "--pixel: -1,5 is outside the picture; expected 0 to 1279, 0 to 719"},
        {{"explain", scene, "--pixel", "1.5,2"}, "--pixel: 1.5,2 is not a pixel; expected X,Y as in 640,360"},
        {{"explain", scene, "--pixel", "1,2,3"}, "--pixel: 1,2,3 is not a pixel; expected X,Y as in 640,360"},
        {{"explain", scene, "--pixel", "1,1", "--format", "xml"},
         "--format: xml is not known; expected text, json, latex"},
        {{"bench", scene, "--frames", "0"}, "--frames: 0 is out of range; expected 1 to 100000"},
        {{"bench", scene, "--drag", "mouse"},
         "--drag: mouse is not known; expected light, material, camera, object"},
        {{"compare", "a.png"}, "B.png: is missing; expected a second picture to compare with"},
        {{"compare", "a.png", "b.png", "-o", "c.jpg"},
         "-o: c.jpg cannot be written; expected a name that ends in .png"},
        {{"compare", "a.png", "b.png", "-o", "-"},
         "-o: standard output is used for the result; expected a name that ends in .png"},
        {{"compare", "a.png", "b.png", "-o", ""}, "-o: is empty; expected DIFF.png"},
        {{"compare", "", "b.png"}, "A.png: is empty; expected a PNG picture"},
        {{"render", scene, "-o", out, "--buffers", ""}, "--buffers: is empty; expected DIR"},
        {{"info", scene, "--memory", ""}, "--memory: is empty; expected SIZE"},
        {{"exercise", ""}, "NAME: is empty; expected a lesson: its name, number or file"},
        {{"quiz", ""}, "ANSWERS: is empty; expected answers saved from the page, to be evaluated"},
        {{"compare", "a.png", "b.png", "--max-error", "much"},
         "--max-error: much is not a number; expected 0 to 255"},
        {{"compare", "a.png", "b.png", "--max-error", "inf"},
         "--max-error: inf is out of range; expected 0 to 255"},
        {{"compare", "a.png", "b.png", "--max-error", "256"},
         "--max-error: 256 is out of range; expected 0 to 255"},
        {{"render", scene, "-o=-z.png"},
         "-o: =-z.png begins with \"=\"; expected a value after a space, as in -o OUT"},
        {{"render", scene, "-o", "=z.png"},
         "-o: =z.png begins with \"=\"; expected a value after a space, as in -o OUT"},
    };
    for (const WrongUsage& wrong : table) {
        std::string line = "glint";
        for (const auto& argument : wrong.arguments) line += " " + argument;
        INFO(line);
        check_error(run_glint(wrong.arguments), 2, wrong.line);
    }
    CHECK(directory.names() == std::vector<std::string>{"scene.json"});
}

TEST_CASE("an existing file is opened even if its name resembles a command", "[cli][bad-input]") {
    const TemporaryDirectory directory;
    (void)directory.file("rendr", "no scene");
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(directory.path());
    const Ended ended = run_glint({"rendr"});
    std::filesystem::current_path(before);
    CHECK(ended.status == 1);
    CHECK(ended.err.rfind("glint: error: rendr: ", 0) == 0);
}

TEST_CASE("after --, a command's name is treated as a file", "[cli][bad-input]") {
    const Ended ended = run_glint({"--", "render"});
    CHECK(ended.status == 1);
    CHECK(ended.err.rfind("glint: error: render: cannot read: no such file", 0) == 0);
}

TEST_CASE("extensions may be uppercase, and a picture is read from a pipe without one", "[cli]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", sphere), picture = directory.path("a.png");
    REQUIRE(run_glint({"render", scene, "-o", picture, "--size", "8x8"}).status == 0);
    const std::string upper = directory.path("DIFFERENCE.PNG"), pipe = directory.path("pipe");
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const int reader = ::open(pipe.c_str(), O_RDWR);  // so that a writer does not block
    REQUIRE(reader >= 0);
    CHECK(run_glint({"compare", picture, picture, "-o", upper}).status == 0);
    CHECK(run_glint({"compare", "-", picture}, bytes_of(picture)).status == 0);
    check_error(run_glint({"compare", "-", "-"}, bytes_of(picture)), 1,
                "-: standard input has already been read; expected only one use of it");
    CHECK(run_glint({"compare", picture, picture, "-o", pipe}).status == 0);
    std::string head(4, ' ');
    CHECK(::read(reader, head.data(), head.size()) == 4);
    ::close(reader);
    CHECK(head == "\x89PNG");
    CHECK(bytes_of(upper).substr(0, 4) == "\x89PNG");
}

TEST_CASE("an invalid --set is a usage error that names the option instead of the file", "[cli][bad-input]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", sphere);
    for (const std::string set : {"nothing", "/display/exposure", "/display/exposure=two words",
                                  "/display/exposure=-1", "/nosuchkey=1", "/lights/7/position=[1,2,3]"}) {
        const Ended ended = run_glint({"info", scene, "--set", set});
        INFO(set << ": " << ended.err);
        CHECK(ended.status == 2);
        CHECK(ended.out.empty());
        CHECK(ended.err.rfind("glint: error: --set: ", 0) == 0);
        CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
    }
}

TEST_CASE("an unusable input gives exit status 1 and an error that names the file", "[cli][bad-input]") {
    const TemporaryDirectory directory;
    const std::string broken = directory.file("broken.json", "{\"glint\": 1,");
    for (const std::string& file :
         {directory.path("missing.json"), directory.path(""), broken, directory.file("empty.obj", ""),
          directory.file("odd.txt", "?"), directory.file("plain.png", "\x89PNG"), std::string("/dev/zero")}) {
        for (const char* command : {"render", "info", "explain", "bench"}) {
            std::vector<std::string> arguments{command, file};
            if (arguments[0] == "render") arguments.insert(arguments.end(), {"-o", directory.path("o.png")});
            if (arguments[0] == "explain") arguments.insert(arguments.end(), {"--pixel", "1,1"});
            const Ended ended = run_glint(arguments);
            INFO(command << ": " << ended.err);
            CHECK(ended.status == 1);
            CHECK(ended.out.empty());
            CHECK(ended.err.rfind("glint: error: " + file, 0) == 0);
            CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
        }
    }
    CHECK_FALSE(std::filesystem::exists(directory.path("o.png")));
}

TEST_CASE("numbers use a decimal point even in a locale with decimal commas", "[cli]") {
    const TemporaryDirectory folder;
    const std::string make = "localedef -i de_DE -f UTF-8 '" + folder.path("de_DE.UTF-8") + "' 2>/dev/null";
    if (std::system(make.c_str()) != 0) return;  // Debian's package "locales" is not installed
    const std::string scene = folder.file("scene.json", R"({"glint": 1, "lights": [{"intensity": 0.625}]})");
    const std::vector<std::string> arguments{"explain", scene,   "--pixel",
                                             "640,360", "--set", "/global_ambient=[0.5,0.25,0.125]"};
    const Ended german =
        run_glint(arguments, {}, {}, {"/usr/bin/env", "LOCPATH=" + folder.path(), "LC_ALL=de_DE.UTF-8"});
    INFO(german.err);
    CHECK(german.status == 0);
    CHECK(german.out == run_glint(arguments).out);
}

TEST_CASE("an empty picture file is reported as empty", "[cli][bad-input]") {
    const TemporaryDirectory directory;
    const std::string empty = directory.file("empty.png", "");
    check_error(run_glint({"compare", empty, empty}), 1,
                empty + ": is empty; expected a PNG picture of 1x1 to 16384x16384");
}

TEST_CASE("an error is one line of at most 4096 bytes, for any file name", "[cli][bad-input]") {
    const Ended hostile = run_glint({"info", "a\nb\x1b[31m\x07.json"});
    CHECK(hostile.status == 1);
    CHECK(std::count(hostile.err.begin(), hostile.err.end(), '\n') == 1);
    CHECK(hostile.err.find('\x1b') == std::string::npos);
    const Ended lengthy = run_glint({"info", std::string(20000, 'x') + ".json"});
    CHECK(lengthy.status == 1);
    CHECK(lengthy.err.rfind("glint: error: xxx", 0) == 0);
    CHECK(lengthy.err.size() <= 4096 + 1);
}

TEST_CASE("without a display, the error suggests a command that needs no display", "[cli]") {
    const Ended ended = run_glint({});
    CHECK(ended.status == 1);
    CHECK(ended.out.empty());
    CHECK(ended.err.find("glint render FILE -o OUT.png") != std::string::npos);
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
}

TEST_CASE("the options --help and --version print to standard output and return status 0", "[cli]") {
    const Ended help = run_glint({"--help"}), version = run_glint({"--version"});
    CHECK(help.status == 0);
    CHECK(help.err.empty());
    CHECK(version.out.rfind("glint ", 0) == 0);
    for (const std::string command :
         {"render", "explain", "profile", "sheet", "lobe", "microfacets", "info", "compare", "bench"}) {
        CHECK(help.out.find("glint " + command) != std::string::npos);
        const Ended one = run_glint({command, "--help"});
        CHECK(one.status == 0);
        CHECK(one.out.find("Usage: glint " + command) != std::string::npos);
        CHECK(one.out.find(command + "  [") == std::string::npos);  // no gap where a command has no FILE
    }
}

TEST_CASE("a count's minimum and maximum are accepted, values beyond them are rejected", "[cli]") {
    CHECK(run_glint({"microfacets", "--rays", "1", "--facets", "4", "--seed", "2147483647"}).status == 0);
    CHECK(run_glint({"microfacets", "--rays", "0"}).err ==
          "glint: error: --rays: 0 is out of range; expected 1 to 100000\n");
    CHECK(run_glint({"microfacets", "--rays", "100001"}).err ==
          "glint: error: --rays: 100001 is out of range; expected 1 to 100000\n");
    CHECK(run_glint({"microfacets", "--facets", "3"}).status == 2);
}
