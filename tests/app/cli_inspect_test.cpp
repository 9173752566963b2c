// Tests of the commands that inspect pictures and surfaces, as a user runs them: profile, sheet, lobe.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

const char* const ball = R"({"glint": 1, "objects": [{"mesh": {"primitive": "sphere", "detail": 12}}],
                            "lights": [{"name": "Bulb", "position": [2, 3, 4]}]})";

void check_wrong(const std::vector<std::string>& arguments, const std::string& line) {
    const Ended ended = run_glint(arguments, ball);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(ended.err == "glint: error: " + line + "\n");
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields(1);
    for (const char c : line) {
        if (c == ',')
            fields.emplace_back();
        else
            fields.back() += c;
    }
    return fields;
}

Picture opened(const std::string& path) {
    auto picture = read_png(path);
    REQUIRE(problem_of(picture) == nullptr);
    return std::get<Picture>(std::move(picture));
}

}  // namespace

TEST_CASE("glint profile lists a line's pixels as CSV, with the same values as explain", "[cli][profile]") {
    const Ended ended =
        run_glint({"profile", "-", "--from", "0,24", "--to", "63,24", "--size", "64x48"}, ball);
    REQUIRE(ended.status == 0);
    const auto lines = lines_of(ended.out);
    REQUIRE(lines.size() == 65);
    CHECK(lines[0] == "position,r,g,b,intensity,first_difference,second_difference,face,object,x,y");
    for (const std::string& line : lines) CHECK(fields_of(line).size() == 11);
    CHECK(fields_of(lines[1])[7].empty());  // background
    const auto middle = fields_of(lines[33]);
    CHECK(middle[0] == "32");
    const Ended explained =
        run_glint({"explain", "-", "--pixel", "32,24", "--size", "64x48", "--format", "json"}, ball);
    CHECK(explained.out.find("\"face\": " + middle[7] + ",") != std::string::npos);
    const double before = std::stod(fields_of(lines[32])[4]), here = std::stod(middle[4]);
    CHECK(std::stod(middle[5]) == Approx(here - before));
}

TEST_CASE("glint profile can write its columns as JSON arrays", "[cli][profile]") {
    const std::vector<std::string> words{"profile", "-",     "--from", "0,24",
                                         "--to",    "63,24", "--size", "64x48"};
    std::vector<std::string> as_json = words;
    as_json.insert(as_json.end(), {"--format", "json"});
    const std::vector<std::string> csv = lines_of(run_glint(words, ball).out);
    const auto json = nlohmann::json::parse(run_glint(as_json, ball).out);
    const std::vector<std::string> names = fields_of(csv.at(0));
    REQUIRE(json.size() == names.size());
    for (std::size_t line = 1; line < csv.size(); ++line)
        for (std::size_t column = 0; column < names.size(); ++column) {
            const std::string field = fields_of(csv[line])[column];
            const auto& value = json.at(names[column]).at(line - 1);
            CAPTURE(names[column], line, field);
            CHECK(value.is_null() == field.empty());
            if (!field.empty()) CHECK(value.get<float>() == std::stof(field));
        }
}

TEST_CASE("glint profile reports invalid end points", "[cli][profile][bad-input]") {
    check_wrong({"profile", "-", "--to", "1,1"}, "--from: is missing; expected X,Y as in --from 0,360");
    check_wrong({"profile", "-", "--from", "1,1", "--to", "64,1", "--size", "64x48"},
                "--to: 64,1 is outside the picture; expected 0 to 63, 0 to 47");
    check_wrong({"profile", "-", "--from", "a", "--to", "1,1"},
                "--from: a is not a pixel; expected X,Y as in 640,360");
}

TEST_CASE("glint sheet draws each cell as glint render does", "[cli][sheet]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("ball.json", ball), out = directory.path("sheet.png");
    const Ended ended =
        run_glint({"sheet", scene, "--rows", "/shading/mode=flat,phong", "--cols",
                   "/lights/0/position=[2,3,4],[-2,0,4]", "--cell", "40x30", "--samples", "4", "-o", out});
    CHECK(ended.err.empty());
    REQUIRE(ended.status == 0);
    const Picture sheet = opened(out);
    const std::string one = directory.path("one.png");
    REQUIRE(run_glint({"render", scene, "--size", "40x30", "--samples", "4", "-o", one, "--set",
                       "/shading/mode=phong", "--set", "/lights/0/position=[-2,0,4]"})
                .status == 0);
    const Picture cell = opened(one);
    const int left = sheet.size.width - 14 - 40, top = sheet.size.height - 14 - 30;  // the last cell
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                REQUIRE(sheet.rgba[4 * sheet.pixel(left + x, top + y) + c] ==
                        cell.rgba[4 * cell.pixel(x, y) + c]);
}

TEST_CASE("glint sheet names the axis with an invalid value", "[cli][sheet][bad-input]") {
    const std::string rows = "/shading/mode=flat", out = "/dev/null";
    check_wrong({"sheet", "-", "--cols", "/a=1", "-o", "a.png"},
                "--rows: is missing; expected POINTER=A,B,C, such as /objects/0/material/shininess=8,32,128");
    check_wrong({"sheet", "-", "--rows", rows, "--cols", "/objects/0/material/shininess=8,-1", "-o", out},
                "--cols: /objects/0/material/shininess: -1 is out of range; expected 0 to 10000");
    check_wrong({"sheet", "-", "--rows", "/shading/mode=flt", "--cols", "/display/exposure=1", "-o", out},
                "--rows: /shading/mode: \"flt\" is not known; expected flat, facet, gouraud or phong");
    check_wrong({"sheet", "-", "--rows", rows, "--cols", "/display/exposure=1", "-o", "a.pfm"},
                "-o: a.pfm cannot be written; expected a name that ends in .png, or - for standard output");
    const std::string again = ": it overwrites what --rows sets; expected a different parameter";
    check_wrong(
        {"sheet", "-", "--rows", "/display/exposure=1,no", "--cols", "/display/exposure=1", "-o", out},
        "--cols: /display/exposure" + again);
    check_wrong({"sheet", "-", "--rows", "/objects/0/material/shininess=1", "--cols",
                 "/objects/0/material={}", "-o", out},
                "--cols: /objects/0/material" + again);
    const Ended large = run_glint(
        {"sheet", "-", "--rows", rows, "--cols", "/display/exposure=1,2", "-o", out, "--cell", "9000x9"},
        ball);
    CHECK(large.status == 2);
    CHECK(large.err.starts_with("glint: error: --cell: the sheet would be 180"));
    CHECK(large.err.ends_with(" pixels; expected at most 16384x16384\n"));
}

TEST_CASE("glint lobe reports how an object's surface reflects light", "[cli][lobes]") {
    const std::vector<std::string> arguments{"lobe",    "-",  "--angle", "25",
                                             "--steps", "36", "--set",   "/objects/0/material/shininess=20"};
    const Ended csv = run_glint(arguments, ball);
    REQUIRE(csv.status == 0);
    CHECK(lines_of(csv.out).size() == 1 + 37);
    std::vector<std::string> with_format = arguments;
    with_format.insert(with_format.end(), {"--format", "json"});
    const auto json = nlohmann::json::parse(run_glint(with_format, ball).out);
    const auto along_r = json["slice"][(90 + 25) / 5];
    CHECK(along_r["view_deg"] == 25);
    CHECK(along_r["specular"][0].get<double>() == Approx(1));
    CHECK(along_r["diffuse"][0].get<double>() == Approx(0.8 * 0.906308));
    CHECK(json["reflection"] == "phong");
    const Ended second =
        run_glint({"lobe", "-", "--object", "1", "--format", "json"},
                  R"({"glint": 1, "objects": [{"name": "First", "mesh": {"primitive": "cube"}},
                                    {"name": "Second", "mesh": {"primitive": "cube"}}]})");
    CHECK(second.out.find("\"Second\"") != std::string::npos);
    CHECK(json["specular_energy"][0].get<double>() == Approx(2 * 3.14159265 / 22 * 0.906308).epsilon(1e-3));
}

TEST_CASE("glint microfacets prints the same JSON for the same seed", "[cli][microfacets]") {
    const std::vector<std::string> arguments{"microfacets", "--roughness", "0.3",    "--angle", "60",
                                             "--rays",      "500",         "--seed", "9"};
    const Ended ended = run_glint(arguments);
    REQUIRE(ended.status == 0);
    CHECK(run_glint(arguments).out == ended.out);
    const auto json = nlohmann::json::parse(ended.out);
    CHECK(json["rays"].size() == 500);
    CHECK(json["profile"].size() == 401);
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"microfacets", "--roughness", "0.3", "--angle", "60", "--rays", "500"});
        return run_glint(more).out;
    };
    CHECK(with({"--seed", "10"}) != ended.out);
    CHECK(with({"--seed", "9", "--view", "60"}) == ended.out);  // the viewer is at the mirror angle
    CHECK(with({"--seed", "9", "--view", "0"}) != ended.out);
    CHECK(json["sigma_deg"].get<double>() == Approx(27));
    double all = 0;
    for (const auto& share : json["shares"]) all += share.get<double>();
    CHECK(all == Approx(1));
    check_wrong({"microfacets", "--roughness", "2"}, "--roughness: 2 is out of range; expected 0 to 1");
    check_wrong({"microfacets", "--angle", "90"}, "--angle: 90 is out of range; expected 0 to 89");
    check_wrong({"microfacets", "--rays", "0"}, "--rays: 0 is out of range; expected 1 to 100000");
}

TEST_CASE("glint render --stats counts the evaluations in each shading mode", "[cli][stats]") {
    const TemporaryDirectory directory;
    const std::string out = directory.path("a.png");
    const auto evaluations = [&](const std::string& mode) {
        const Ended ended = run_glint(
            {"render", "-", "-o", out, "--size", "64x48", "--stats", "--set", "/shading/mode=" + mode,
             "--set", R"(/objects/0/mesh={"primitive":"plane","detail":2})", "--set", "/camera/eye=[0,3,0]",
             "--set", "/camera/up=[0,0,-1]"},
            ball);
        INFO(ended.err);
        REQUIRE(ended.status == 0);
        return nlohmann::json::parse(ended.out);
    };
    CHECK(evaluations("flat")["evaluations"] == 4);     // one per face
    CHECK(evaluations("gouraud")["evaluations"] == 9);  // one per corner
    const auto phong = evaluations("phong");            // one per pixel
    CHECK(phong["evaluations"] == phong["shaded_pixels"]);
    CHECK(phong["stages"].size() == 5);
    check_wrong({"render", "-", "-o", "-", "--stats"},
                "--stats: standard output is used for the picture; expected a file after -o");
}

TEST_CASE("glint render --buffers writes the values that pixels are computed from", "[cli][buffers]") {
    const TemporaryDirectory directory;
    const std::string out = directory.path("a.pfm");
    REQUIRE(run_glint({"render", "-", "-o", out, "--size", "32x24", "--buffers", directory.path("")}, ball)
                .status == 0);
    CHECK(directory.names() ==
          std::vector<std::string>{"a.pfm",       "ambient.pfm",   "ambient_0.pfm",      "depth.pfm",
                                   "diffuse.pfm", "diffuse_0.pfm", "distance_0.pfm",     "emission.pfm",
                                   "face.pfm",    "falloff_0.pfm", "global_ambient.pfm", "h_0.pfm",
                                   "l_0.pfm",     "n_dot_l_0.pfm", "normal.pfm",         "position.pfm",
                                   "r_0.pfm",     "side.pfm",      "specular.pfm",       "specular_0.pfm",
                                   "sum.pfm",     "view.pfm"});
    CHECK(bytes_of(directory.path("sum.pfm")) == bytes_of(out));
    const TemporaryDirectory beside_exr;
    const std::string exr = beside_exr.path("a.exr");
    REQUIRE(run_glint({"render", "-", "-o", exr, "--size", "32x24", "--buffers", beside_exr.path("")}, ball)
                .status == 0);
    CHECK(beside_exr.names().size() == 22);
    CHECK(bytes_of(beside_exr.path("sum.exr")) == bytes_of(exr));
    check_wrong({"render", "-", "-o", out, "--buffers", "/nowhere"},
                "--buffers: /nowhere is not a directory; expected an existing directory");
    check_wrong({"render", "-", "-o", out, "--buffers", directory.path(""), "--samples", "4"},
                "--buffers: a pixel with several samples may show several surfaces; expected --samples 1");
}

TEST_CASE("glint explain --sensitivity lists the numbers that affect the pixel", "[cli][sensitivity]") {
    const std::vector<std::string> arguments{"explain", "-",     "--pixel",      "32,24",
                                             "--size",  "64x48", "--sensitivity"};
    const Ended text = run_glint(arguments, ball);
    REQUIRE(text.status == 0);
    CHECK(text.out.find("Numbers with no effect on the pixel:\n") != std::string::npos);
    std::vector<std::string> as_json = arguments;
    as_json.insert(as_json.end(), {"--format", "json"});
    const auto json = nlohmann::json::parse(run_glint(as_json, ball).out);
    CHECK(json["pixel"] == nlohmann::json({32, 24}));
    CHECK(json["sensitivity"].size() > 20);
    CHECK(json["sensitivity"][0].contains("pointer"));
    CHECK(json["no_effect"].size() > 20);
}

TEST_CASE("a light's red, green and blue change only the channel of the same name", "[cli][sensitivity]") {
    const auto json = nlohmann::json::parse(run_glint({"explain", "-", "--pixel", "32,24", "--size", "64x48",
                                                       "--sensitivity", "--format", "json"},
                                                      ball)
                                                .out);
    int seen = 0;
    for (const auto& number : json["sensitivity"])
        for (int channel = 0; channel < 3; ++channel) {
            if (number["pointer"] != fmt::format("/lights/0/diffuse/{}", channel)) continue;
            CAPTURE(number.dump());
            ++seen;
            for (int c = 0; c < 3; ++c) CHECK((number["change"][c] > 0) == (c == channel));
        }
    CHECK(seen == 3);
}
