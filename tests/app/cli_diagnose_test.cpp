// Tests of glint diagnose and glint check as a user runs them.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "models/problem.h"
#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;
using nlohmann::json;

namespace {

const char* const balls = R"({"glint": 1, "objects": [
    {"mesh": {"primitive": "sphere", "detail": 24}, "transform": {"translate": [-1, 0, 0], "scale": [1, 0.7, 1]}},
    {"mesh": {"primitive": "torus", "detail": 24}, "transform": {"translate": [1.2, 0, 0], "rotate_deg": [60, 0, 0]}}],
    "lights": [{"name": "Bulb", "position": [2, 3, 4]}]})";

struct Files {
    TemporaryDirectory directory;
    std::string scene = directory.file("scene.json", balls);

    std::string drawn(const std::string& name, const std::vector<std::string>& options) const {
        std::vector<std::string> line{"render", scene, "--size", "160x120", "-o", directory.path(name)};
        line.insert(line.end(), options.begin(), options.end());
        REQUIRE(run_glint(line).status == 0);
        return directory.path(name);
    }
};

}  // namespace

TEST_CASE("glint diagnose names a mistake in a PNG, a PFM and an EXR", "[cli][diagnose]") {
    const Files files;
    for (const char* name : {"wrong.png", "wrong.pfm", "wrong.exr"}) {
        const std::string wrong = files.drawn(name, {"--set", "/shading/mistakes/normals_flipped=true"});
        const Ended ended = run_glint({"diagnose", files.scene, wrong, "--format", "json"});
        REQUIRE(ended.status == 0);
        CHECK(ended.err.empty());
        const json answer = json::parse(ended.out);
        CHECK(answer["verdict"] == "mistake");
        CHECK(answer["display"] == json::object());
        const json& first = answer["candidates"][0];
        CHECK(first["name"] == "normals_flipped");
        CHECK(first["also"].is_array());
        CHECK(first["explained"] == 1);
        CHECK(first["residual"] == 0);
        CHECK(first["mine"] == first["as_mistaken"]);
        CHECK(first["mine"] != first["reference"]);
        CHECK(answer["experiment"]["set"].size() == 1);
        CHECK(answer["experiment"]["shows"].size() >= 2);
    }
}

TEST_CASE("glint diagnose prints its result in at most five lines", "[cli][diagnose]") {
    const Files files;
    const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
    const std::string right = files.drawn("right.png", {"--set", "/display/exposure=0.8"});
    const Ended same = run_glint({"diagnose", files.scene, right});
    CHECK(same.status == 0);
    CHECK(same.out ==
          "No mistake: the picture shows the scene as Glint does.\n"
          "Set aside first, because it is not a lighting mistake: brightness multiplied by 0.8, in stored "
          "levels.\n");
    const std::string wrong = files.drawn("wrong.png", {"--set", "/shading/mistakes/normals_flipped=true"});
    const Ended mistake = run_glint({"diagnose", files.scene, wrong, "--pairs"});
    CHECK(mistake.status == 0);
    CHECK(mistake.out.starts_with("Mistake: normals_flipped. Every normal points inwards"));
    CHECK(lines(mistake.out) <= 5);
}

TEST_CASE("glint diagnose suggests searching for two mistakes if no single one matches", "[cli][diagnose]") {
    const Files files;
    const std::string other =
        files.drawn("other.png", {"--set", "/objects/0/material/diffuse=[0.1,0.9,0.2]"});
    const std::string hint = "Use --pairs to look for two mistakes at once.\n";
    const Ended single = run_glint({"diagnose", files.scene, other});
    CHECK(single.out.starts_with("Not in the catalogue: "));
    CHECK(single.out.ends_with(hint));
    CHECK_FALSE(run_glint({"diagnose", files.scene, other, "--pairs"}).out.ends_with(hint));
    CHECK_FALSE(run_glint({"diagnose", files.scene, files.drawn("right.png", {})}).out.ends_with(hint));
}

TEST_CASE("glint diagnose counts differing pixels in areas that it does not compare", "[cli][diagnose]") {
    const Files files;
    const TemporaryDirectory buffers;
    Picture depth, picture = std::get<Picture>(read_png(files.drawn("right.png", {})));
    (void)files.drawn("right.pfm", {"--buffers", buffers.path("")});
    depth = std::get<Picture>(read_picture(buffers.path("depth.pfm")));
    const auto paint = [&](int x, int y) {
        picture.rgba[4 * picture.size.index(x, y)] = 255;
        picture.rgba[4 * picture.size.index(x, y) + 1] ^= 0x80;
    };
    const auto shown = [&](int x, int y) { return depth.linear[3 * depth.size.index(x, y)] > 0; };
    std::size_t outline = 0;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x + 1 < picture.size.width; ++x)
            if (shown(x, y) && !shown(x + 1, y)) {
                paint(x, y);
                ++outline;
            }
    paint(0, 0);
    paint(2, 0);
    REQUIRE(outline > 20);
    const std::string painted = files.directory.file("painted.png", png_bytes(picture, {}));
    const json counts =
        json::parse(run_glint({"diagnose", files.scene, painted, "--format", "json"}).out)["pixels"];
    CHECK(counts["edge"]["unlike"] == outline);
    CHECK(counts["surface"]["unlike"] == 0);
    CHECK(counts["background"]["unlike"] == 2);
    std::size_t all = 0;
    for (const json& count : counts) all += count["pixels"].get<std::size_t>();
    CHECK(all == picture.size.pixels());
    CHECK(run_glint({"diagnose", files.scene, painted}).out ==
          fmt::format(
              "No mistake: the picture shows the scene as Glint does.\nPixels that differ by more than "
              "2 levels: {} of {} at edges, which are not compared; 2 of {} in the background, which is "
              "not compared.\n",
              outline, counts["edge"]["pixels"].get<std::size_t>(),
              counts["background"]["pixels"].get<std::size_t>()));
}

TEST_CASE("glint diagnose writes a sheet of four pictures", "[cli][diagnose]") {
    const Files files;
    const std::string wrong = files.drawn("wrong.png", {"--set", "/shading/mistakes/normals_flipped=true"});
    const std::string out = files.directory.path("sheet.png");
    REQUIRE(run_glint({"diagnose", files.scene, wrong, "-o", out}).status == 0);
    const auto sheet = read_png(out);
    REQUIRE(problem_of(sheet) == nullptr);
    CHECK(std::get<Picture>(sheet).size.width > 4 * 160);
    CHECK(std::get<Picture>(sheet).size.width < 5 * 160);
}

TEST_CASE("glint diagnose rejects bad input with a one-line error", "[cli][diagnose][bad-input]") {
    const Files files;
    const auto check = [](const Ended& ended, int status, const std::string& line) {
        CHECK(ended.status == status);
        CHECK(ended.out.empty());
        CHECK(ended.err == "glint: error: " + line + "\n");
    };
    check(run_glint({"diagnose", files.scene}), 2,
          "PICTURE: is missing; expected a picture of the scene that another program drew");
    check(run_glint({"diagnose", files.scene, files.scene}), 1,
          files.scene + ": cannot be read; expected a picture whose name ends in .png, .pfm or .exr");
    const std::string wrong = files.drawn("wrong.png", {});
    check(run_glint({"diagnose", files.scene, wrong, "--format", "latex"}), 2,
          "--format: latex is not known; expected text, json, csv, html");
    check(run_glint({"diagnose", files.scene, wrong, wrong, "-o", "sheet.png"}), 2,
          "-o: can write the sheet of only one picture, but 2 are given; expected one PICTURE, or --format "
          "html");
    check(run_glint({"diagnose", files.scene, wrong, "-o", "sheet.jpg"}), 2,
          "-o: sheet.jpg cannot be written; expected a name that ends in .png");
    const std::string printed =
        "-o: writes the .png sheet of one picture, but --format html prints a page; "
        "expected > PAGE.html in place of -o";
    check(run_glint({"diagnose", files.scene, wrong, wrong, "--format", "html", "-o", "sheet.png"}), 2,
          printed);
    check(run_glint({"diagnose", files.scene, wrong, "--format", "html", "-o", "page.html"}), 2, printed);
    const std::string bytes = bytes_of(wrong);
    const std::string cut = files.directory.file("cut.png", bytes.substr(0, bytes.size() / 2));
    const Ended corrupt = run_glint({"diagnose", files.scene, cut});
    CHECK(corrupt.status == 1);
    CHECK(corrupt.out.empty());
    CHECK(corrupt.err.starts_with("glint: error: " + cut + ": cannot be read as a PNG"));
    CHECK(std::count(corrupt.err.begin(), corrupt.err.end(), '\n') == 1);
}

TEST_CASE("glint diagnose prints a table for several pictures", "[cli][diagnose]") {
    const Files files;
    const std::string right = files.drawn("right.png", {});
    const std::string wrong =
        files.drawn("wrong, \x1b[2Jone.png", {"--set", "/shading/mistakes/normals_flipped=true"});
    const Ended csv = run_glint({"diagnose", files.scene, right, wrong, "--format", "csv"});
    REQUIRE(csv.status == 0);
    CHECK(csv.out.starts_with("picture,verdict,mistake,also,explained,residual,display,experiment,why\n" +
                              right + ",no mistake,,,,,,,\n\"" + on_one_line(wrong) +
                              "\",mistake,normals_flipped,"));
    CHECK(std::count(csv.out.begin(), csv.out.end(), '\n') == 3);
    const Ended text = run_glint({"diagnose", files.scene, right, wrong});
    CHECK(text.out.starts_with(right + "\nNo mistake: "));
    CHECK(text.out.find("\n\n" + on_one_line(wrong) + "\nMistake: normals_flipped.") != std::string::npos);
}

TEST_CASE("diagnose --format json prints one object per line, for any number of pictures",
          "[cli][diagnose]") {
    const Files files;
    const std::string right = files.drawn("right.png", {});
    const std::string wrong = files.drawn("wrong.png", {"--set", "/shading/mistakes/normals_flipped=true"});
    const auto answer = [&](std::vector<std::string> pictures) {
        pictures.insert(pictures.begin(), {"diagnose", files.scene, "--format", "json"});
        const Ended ended = run_glint(pictures);
        CHECK(ended.status == 0);
        return ended.out;
    };
    CHECK(answer({right, wrong}) == answer({right}) + answer({wrong}));
    for (const std::string& picture : {right, wrong}) {
        const json one = json::parse(answer({picture}));
        CHECK(one["picture"] == picture);
        CHECK(one["verdict"] == (picture == right ? "no mistake" : "mistake"));
        CHECK(one["width"] == 160);
    }
}

TEST_CASE("glint diagnose still reports the other pictures if one cannot be read", "[cli][diagnose]") {
    const Files files;
    const std::string right = files.drawn("right.png", {});
    const std::string wrong = files.drawn("wrong.png", {"--set", "/shading/mistakes/normals_flipped=true"});
    const std::string bytes = bytes_of(wrong);
    const std::string cut = files.directory.file("cut.png", bytes.substr(0, bytes.size() / 2));
    const auto diagnosed = [&](const std::string& format) {
        const Ended ended = run_glint({"diagnose", files.scene, right, cut, wrong, "--format", format});
        CHECK(ended.status == 1);
        CHECK(ended.err.starts_with("glint: warning: " + cut + ": cannot be read as a PNG"));
        CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
        return ended.out;
    };
    std::istringstream lines(diagnosed("json"));
    std::vector<json> answers;
    for (std::string line; std::getline(lines, line);) answers.push_back(json::parse(line));
    REQUIRE(answers.size() == 3);
    CHECK(answers[0]["verdict"] == "no mistake");
    CHECK(answers[1]["picture"] == cut);
    CHECK(answers[1]["verdict"] == "not readable");
    CHECK(answers[1]["why"].get<std::string>().starts_with("cannot be read as a PNG"));
    CHECK(answers[2]["candidates"][0]["name"] == "normals_flipped");
    const std::string csv = diagnosed("csv");
    CHECK(csv.find("\n" + right + ",no mistake,") != std::string::npos);
    CHECK(csv.find("\n" + cut + ",not readable,,,,,,,") != std::string::npos);
    CHECK(csv.find("\n" + wrong + ",mistake,normals_flipped,") != std::string::npos);
    const std::string text = diagnosed("text");
    CHECK(text.find(cut + "\nNot readable: cannot be read as a PNG") != std::string::npos);
    CHECK(text.find(wrong + "\nMistake: normals_flipped.") != std::string::npos);
    const std::string page = diagnosed("html");
    CHECK(page.find("<b>not readable</b><br>cannot be read as a PNG") != std::string::npos);
    CHECK(page.find("normals_flipped") != std::string::npos);
}

TEST_CASE("glint diagnose writes a self-contained HTML page", "[cli][diagnose]") {
    const Files files;
    const std::string wrong = files.drawn("a<b>.png", {"--set", "/shading/mistakes/normals_flipped=true"});
    const Ended page = run_glint({"diagnose", files.scene, wrong, "--format", "html"});
    REQUIRE(page.status == 0);
    CHECK(page.out.starts_with("<!DOCTYPE html>"));
    CHECK(page.out.find("a&lt;b&gt;.png") != std::string::npos);
    CHECK(page.out.find("normals_flipped") != std::string::npos);
    CHECK(page.out.find("http") == std::string::npos);
    // The beginning of a PNG in base 64: the signature is 89 50 4E 47 0D 0A 1A 0A.
    const std::string start = "src=\"data:image/png;base64,iVBORw0KGgo";
    const std::size_t first = page.out.find(start);
    REQUIRE(first != std::string::npos);
    CHECK(page.out.find(start, first + 1) != std::string::npos);
}

TEST_CASE("glint diagnose --apart finds a pixel that differs between two mistakes", "[cli][diagnose]") {
    const Files files;
    const std::string names[] = {"view_reversed", "viewer_at_origin_of_world"};
    const json found = json::parse(
        run_glint({"diagnose", files.scene, "--apart", names[0] + "," + names[1], "--format", "json"}).out);
    const std::string pixel = found["pixel"][0].dump() + "," + found["pixel"][1].dump();
    for (std::size_t i = 0; i < 2; ++i) {  // the pixel's colour with this mistake
        CHECK(found["shows"][i]["name"] == names[i]);
        const Ended drawn = run_glint({"explain", files.scene, "--size", "640x480", "--pixel", pixel, "--set",
                                       found["set"][0].get<std::string>(), "--set",
                                       "/shading/mistakes/" + names[i] + "=true", "--format", "json"});
        CHECK(json::parse(drawn.out)["byte"] == found["shows"][i]["color"]);
    }
    CHECK(run_glint({"diagnose", files.scene, "--apart", "view_reversed,missing_pi", "--set", "/objects=[]"})
              .out == "No change that was tried separates them by more than a level.\n");
    CHECK(run_glint({"diagnose", files.scene, "--apart", "view_reversed,missing_pi,view_reversed"}).err ==
          "glint: error: --apart: names view_reversed twice; expected each mistake once\n");
    CHECK(run_glint({"diagnose", files.scene, "--apart", "view_reversed"}).err ==
          "glint: error: --apart: number of mistakes: 1; expected two to four, separated by commas\n");
    CHECK(run_glint({"diagnose", files.scene, "--apart", "view_reversed,x"})
              .err.starts_with("glint: error: --apart: x is not known; expected "));
    CHECK(run_glint({"diagnose", files.scene, "a.png", "--apart", "view_reversed,missing_pi"}).err ==
          "glint: error: --apart: needs only a scene; expected no PICTURE\n");
    const std::string sheet = files.directory.path("sheet.png"), two = "view_reversed,missing_pi";
    CHECK(run_glint({"diagnose", files.scene, "--apart", two, "-o", sheet}).err ==
          "glint: error: -o: --apart draws no sheet; expected no -o\n");
    CHECK(run_glint({"diagnose", files.scene, "--apart", two, "--pairs"}).err ==
          "glint: error: --pairs: cannot be combined with --apart; expected no --pairs\n");
}

TEST_CASE("glint check names the first buffer that differs", "[cli][buffers][check]") {
    const Files files;
    const TemporaryDirectory buffers;
    (void)files.drawn("right.pfm", {"--buffers", buffers.path("")});
    CHECK(
        run_glint({"check", files.scene, buffers.path("")}).out ==
        "These agree: position, depth, normal, side, view, l_0, n_dot_l_0, distance_0, falloff_0, r_0, h_0, "
        "emission, global_ambient, ambient_0, diffuse_0, specular_0, ambient, diffuse, specular, "
        "sum.\nNothing differs.\n");
    const Ended wrong = run_glint({"check", files.scene, buffers.path(""), "--set",
                                   "/lights/0/diffuse=[0.5,0.5,0.5]", "--format", "json"});
    REQUIRE(wrong.status == 0);
    const json answer = json::parse(wrong.out);
    CHECK(answer["differs"]["buffer"] == "diffuse_0");
    CHECK(answer["agree"].size() == 14);
    CHECK(answer["differs"]["found"] == "ours times 2");
}

TEST_CASE("glint check fails if there is nothing to compare", "[cli][buffers][check]") {
    const Files files;
    const TemporaryDirectory buffers;
    (void)files.drawn("right.pfm", {"--buffers", buffers.path("")});
    CHECK(run_glint({"check", files.scene, buffers.path(""), "--set", "/objects=[]"}).err ==
          "glint: error: " + buffers.path("") +
              ": no pixel to compare; expected a size at which a surface covers more pixels\n");
}

TEST_CASE("glint check reads EXR buffers", "[cli][buffers][check]") {
    const Files files;
    const TemporaryDirectory buffers;
    (void)files.drawn("right.exr", {"--buffers", buffers.path("")});
    REQUIRE(std::filesystem::exists(buffers.path("sum.exr")));
    CHECK(run_glint({"check", files.scene, buffers.path("")}).out.find("Nothing differs.\n") !=
          std::string::npos);
}

TEST_CASE("glint check names the pictures that it does not compare", "[cli][buffers][check]") {
    const Files files;
    const TemporaryDirectory buffers;
    (void)files.drawn("right.pfm", {"--buffers", buffers.path("")});
    const auto warning = [&] { return run_glint({"check", files.scene, buffers.path("")}).err; };
    CHECK(warning().empty());  // face.pfm exists, but is not meant to be compared
    (void)buffers.file("notes.txt", "");
    (void)buffers.file("l_99.pfm", "");
    (void)buffers.file("normals.exr", "");
    CHECK(warning() == "glint: warning: " + buffers.path("") +
                           ": not compared, because the scene has no such buffers: l_99.pfm, normals.exr\n");
    for (int i = 0; i < 9; ++i) (void)buffers.file(fmt::format("a{}.pfm", i), "");
    CHECK(warning() ==
          "glint: warning: " + buffers.path("") +
              ": not compared, because the scene has no such buffers: a0.pfm, a1.pfm, a2.pfm, a3.pfm, "
              "a4.pfm and 6 more\n");
}

TEST_CASE("glint check rejects bad input with a one-line error", "[cli][check][bad-input]") {
    const Files files;
    const TemporaryDirectory buffers;
    const auto check = [&](const std::string& directory, int status, const std::string& line) {
        const Ended ended = run_glint({"check", files.scene, directory});
        CHECK(ended.status == status);
        CHECK(ended.out.empty());
        CHECK(ended.err.starts_with("glint: error: " + line));
        CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
    };
    check(buffers.path("none"), 2, "DIR: " + buffers.path("none") + " is not a directory; expected ");
    check(buffers.path(""), 1,
          buffers.path("") + ": contains none of the buffers; expected one of position, depth");
    (void)files.drawn("right.pfm", {"--buffers", buffers.path("")});
    for (const PictureSize size : {PictureSize{2, 120}, PictureSize{160, 2}}) {
        const std::string depth =
            buffers.file("depth.pfm", fmt::format("PF\n{} {}\n-1.0\n", size.width, size.height) +
                                          std::string(std::size_t{12} * size.width * size.height, '\0'));
        check(buffers.path(""), 1, depth + ": differs in size from position; expected 160x120");
    }
    const std::string position = buffers.file("position.pfm", "PF\n2 2\n-1.0\n");
    check(buffers.path(""), 1, position + ": ");
}

TEST_CASE("glint check reports unreadable buffers and duplicate names", "[cli][buffers][check][bad-input]") {
    const Files files;
    const TemporaryDirectory buffers;
    (void)files.drawn("right.pfm", {"--buffers", buffers.path("")});
    const std::string normal = buffers.path("normal.pfm"), beside = buffers.path("normal.exr");
    const auto error = [&] { return run_glint({"check", files.scene, buffers.path("")}).err; };
    (void)buffers.file("normal.exr", "");
    CHECK(error() ==
          "glint: error: " + beside + ": exists in addition to normal.pfm; expected only one of the two\n");
    std::filesystem::remove(beside);
    std::filesystem::remove(normal);
    std::filesystem::create_symlink("nowhere", normal);
    CHECK(error() == "glint: error: " + normal +
                         ": cannot read: no such file or directory; expected a readable regular file\n");
    std::filesystem::remove(normal);
    std::filesystem::create_symlink("normal.pfm", normal);
    CHECK(error().starts_with("glint: error: " + normal + ": cannot read: a loop of symbolic links"));
    std::filesystem::remove(normal);
    CHECK(error().empty());
}
