// Tests of output to files and to the terminal, after errors and with hostile input.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

const char* const ball_text = R"({"glint": 1, "objects": [{"mesh": {"primitive": "sphere", "detail": 12}}]})";

}  // namespace

TEST_CASE("an output path that cannot be written is reported before work starts", "[cli][bad-input]") {
    const TemporaryDirectory directory;
    const std::string out = directory.path("none/a.png"), missing = directory.path("missing.json");
    const std::string line =
        "glint: error: " + out + ": cannot write: no such file or directory; expected a writable file\n";
    // The scene is missing as well, but the program stops before opening it.
    CHECK(run_glint({"render", missing, "-o", out}).err == line);
    CHECK(run_glint({"compare", missing, missing, "-o", out}).err == line);
    CHECK(run_glint({"sheet", missing, "--rows", "/display/exposure=1,2", "--cols",
                     "/display/transfer=none,srgb", "-o", out})
              .err == line);
    const std::string glb = directory.path("none/a.glb"), program = directory.path("none/program");
    CHECK(
        run_glint({"export", missing, "-o", glb}).err.starts_with("glint: error: " + glb + ": cannot write"));
    CHECK(run_glint({"code", missing, "--language", "cpp", "-o", program}).err ==
          "glint: error: " + program +
              ": cannot be created: no such file or directory; expected a new or an empty directory\n");
    // A new directory is removed again if nothing is written into it.
    CHECK(run_glint({"code", missing, "--language", "cpp", "-o", directory.path("new")}).status == 1);
    CHECK(directory.names().empty());
}

TEST_CASE("a missing file is reported as missing, with any extension", "[cli][bad-input]") {
    const TemporaryDirectory directory;
    for (const char* name : {"nope", "nope.xyz", "a.b/nope"}) {
        const std::string path = directory.path(name);
        CHECK(run_glint({"render", path, "-o", directory.path("x.png")}).err ==
              "glint: error: " + path +
                  ": cannot read: no such file or directory; expected a scene (.json, .png, .gltf, .glb) or "
                  "a mesh (.obj, .ply, .off, .stl)\n");
    }
    const std::string there = directory.file("there", "");
    CHECK(run_glint({"render", there, "-o", directory.path("x.png")}).err.find("has no extension") !=
          std::string::npos);
}

TEST_CASE("render --no-scene omits only the scene from a PNG", "[cli]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", ball_text), with = directory.path("with.png"),
                      without = directory.path("without.png");
    REQUIRE(run_glint({"render", scene, "-o", with, "--size", "32x24"}).status == 0);
    REQUIRE(run_glint({"render", scene, "-o", without, "--size", "32x24", "--no-scene"}).status == 0);
    CHECK(bytes_of(with).find("glint-scene") != std::string::npos);
    CHECK(bytes_of(without).find("glint-scene") == std::string::npos);
    CHECK(bytes_of(without).find("sphere") == std::string::npos);
    CHECK(run_glint({"compare", with, without, "--max-error", "0"}).status == 0);
    CHECK(run_glint({"info", without}).status == 1);
}

TEST_CASE("escape sequences in file names never reach the terminal", "[cli][window]") {
    const TemporaryDirectory directory;
    const std::string name = "a\x1b]0;PWNED\x07\nglint: error: fake.obj";
    const std::string mesh = directory.file(name, "v 0 0 0 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{mesh}, std::vector<std::string>{"info", mesh},
          std::vector<std::string>{"render", mesh, "-o", directory.path("x.png"), "--size", "8x8"}}) {
        const Ended ended = run_glint(arguments);
        INFO(ended.err);
        if (arguments[0] != "info") CHECK(ended.err.find("glint: warning: a\\x1b]0;PWNED\\x07\\n") == 0);
        CHECK(ended.err.find('\x1b') == std::string::npos);
        CHECK(ended.err.find("\nglint: error: fake") == std::string::npos);
        CHECK(ended.out.find('\x1b') == std::string::npos);
    }
}

TEST_CASE("a picture and text cannot both go to standard output, under any name", "[cli][bad-input]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", ball_text), a = directory.path("a.png");
    REQUIRE(run_glint({"render", scene, "-o", a, "--size", "8x8"}).status == 0);
    for (const char* const out : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
        CAPTURE(out);
        for (const std::vector<std::string>& words :
             std::vector<std::vector<std::string>>{{"render", scene, "--size", "8x8", "--stats", "-o", out},
                                                   {"compare", a, a, "-o", out},
                                                   {"diagnose", scene, a, "-o", out}}) {
            const Ended ended = run_glint(words, {}, "| cat");  // a pipe for a PNG may have any name
            CHECK(ended.status == 2);
            CHECK(ended.out.empty());
            CHECK(ended.err.find(": standard output is used for the ") != std::string::npos);
        }
    }
}
