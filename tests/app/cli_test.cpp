// Tests of the commands as a user runs them: the files they write, what they print, and that the two agree.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "renderer/image/image_file.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/gltf_triangle.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

using namespace glint;
using nlohmann::json;

namespace {

const char* const three_lights = R"({"glint": 1,
  "objects": [{"name": "Ball", "mesh": {"primitive": "bumpy-sphere"}},
              {"name": "Floor", "mesh": {"primitive": "cube", "detail": 3},
               "transform": {"translate": [0, -2, 0], "rotate_deg": [10, 20, 0], "scale": [3, 1, 2]}}],
  "lights": [{"name": "Sun", "type": "directional", "position": [1, 2, 1]},
             {"name": "Bulb", "space": "camera", "position": [-1, 1, 0], "falloff": {"quadratic": 0.1}},
             {"name": "Lamp", "type": "spot", "position": [0, 3, 1], "spot": {"cutoff_deg": 40, "exponent": 4}},
             {"name": "Window", "type": "area", "position": [-3, 2, 0], "area": {"samples": 4}}]})";

/// A pyramid with a square base and four triangular sides: V - E + F = 5 - 8 + 5 = 2.
const char* const pyramid =
    "v 0 0 0\nv 2 0 0\nv 2 0 2\nv 0 0 2\nv 1 3 1\nf 1 2 3 4\nf 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 5\n";

Ended must(const std::vector<std::string>& arguments, const std::string& input = {}) {
    Ended ended = run_glint(arguments, input);
    INFO(arguments[0] << ": " << ended.err);
    REQUIRE(ended.status == 0);
    return ended;
}

/// The pixel (x, y), counted from the top left, in the PFM bytes of a picture of this size.
std::array<float, 3> pfm_pixel(const std::string& pfm, int width, int height, int x, int y) {
    const auto from_end =
        static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(width) - static_cast<std::size_t>(x);
    REQUIRE(pfm.size() >= 12 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::array<float, 3> rgb{};
    std::memcpy(rgb.data(), pfm.data() + pfm.size() - 12 * from_end, 12);
    return rgb;
}

std::array<float, 3> rgb_of(const json& list) { return {list[0], list[1], list[2]}; }

void add(std::array<float, 3>& sum, const std::array<float, 3>& more) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += more[c];
}

/// The sum of a point's terms, added in the order that docs/explain.md gives.
std::array<float, 3> sum_of_terms(const json& point) {
    std::array<float, 3> sum = rgb_of(point["emission"]);
    add(sum, rgb_of(point["global_ambient"]));
    if (point.contains("cool_to_warm")) add(sum, rgb_of(point["cool_to_warm"]["color"]));
    const auto add_light = [&sum](const json& light) {
        std::array<float, 3> share = rgb_of(light["ambient"]);
        add(share, rgb_of(light["diffuse"]));
        add(share, rgb_of(light["specular"]));
        add(sum, share);
    };
    for (const json& light : point["lights"]) {
        if (!light.contains("samples")) add_light(light);
        for (const json& sample : light.value("samples", json::array())) add_light(sample);
    }
    return sum;
}

std::array<float, 3> drawn_over(const std::array<float, 3>& shaded, const json& stroke) {
    const float coverage = stroke["coverage"];
    const std::array<float, 3> color = rgb_of(stroke["color"]);
    std::array<float, 3> sum{};
    for (std::size_t c = 0; c < 3; ++c) sum[c] = (1 - coverage) * shaded[c] + coverage * color[c];
    return sum;
}

}  // namespace

TEST_CASE("an explanation's terms add up to the picture's pixel, bit for bit", "[cli][explain][release]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", three_lights), pfm = directory.path("out.pfm");
    const std::string wide_strokes =
        R"(/npr={"silhouettes": true, "stroke_width_px": 25.5, "stroke": [1, 0.3, 0.1]})";
    for (const auto& [mode, more] :
         std::vector<std::pair<std::string, std::string>>{{"phong", "/display/exposure=1"},
                                                          {"facet", "/shading/reflection=cook-torrance"},
                                                          {"gouraud", "/shading/reflection=oren-nayar"},
                                                          {"flat", "/shading/flat_point=provoking"},
                                                          {"phong", "/npr/cool_to_warm=true"},
                                                          {"phong", wide_strokes}}) {
        const std::vector<std::string> how{"--size", "96x64", "--set", "/shading/mode=" + mode,
                                           "--set",  more};
        std::vector<std::string> render{"render", scene, "-o", pfm};
        render.insert(render.end(), how.begin(), how.end());
        must(render);
        const std::string bytes = bytes_of(pfm);
        std::mt19937 random(11);
        int hits = 0, stroked = 0;
        for (int i = 0; i < 12; ++i) {
            const int x = static_cast<int>(random() % 96), y = static_cast<int>(random() % 64);
            std::vector<std::string> explain{
                "explain", scene, "--format", "json", "--pixel", std::to_string(x) + "," + std::to_string(y)};
            explain.insert(explain.end(), how.begin(), how.end());
            const json e = json::parse(must(explain).out);
            INFO(mode << " with " << more << " at " << x << ", " << y);
            CHECK(e["pixel"] == json({x, y}));
            CHECK(rgb_of(e["sum"]) == pfm_pixel(bytes, 96, 64, x, y));
            std::array<float, 3> shaded = rgb_of(e["sum"]);
            if (e.contains("stroke")) {
                ++stroked;
                shaded = rgb_of(e["stroke"]["shaded"]);
                CHECK(drawn_over(shaded, e["stroke"]) == rgb_of(e["sum"]));
            }
            if (!e["hit"].get<bool>()) continue;
            ++hits;
            CHECK(e["mode"] == mode);
            if (!e.contains("corners")) CHECK(sum_of_terms(e) == shaded);
            for (const json& corner : e.value("corners", json::array())) {
                CHECK(sum_of_terms(corner) == rgb_of(corner["sum"]));
            }
        }
        CHECK(hits > 2);
        CHECK((stroked > 0) == (more == wide_strokes));
    }
}

TEST_CASE("line breaks and escape sequences in a name are escaped in an explanation", "[cli][explain]") {
    const char* const scene = R"({"glint": 1, "lights": [{"name": "a\n\u001b[31mb"}],
                                  "objects": [{"name": "ball\u0007"}]})";
    const std::string out = must({"explain", "-", "--pixel", "640,360"}, scene).out;
    CHECK(out.find("Pixel 640, 360: ball\\x07, face ") == 0);
    CHECK(out.find("\na\\n\\x1b[31mb, point light\n") != std::string::npos);
    CHECK(out.find('\x1b') == std::string::npos);
}

TEST_CASE("eight samples per pixel change only the edges of a uniform square", "[cli][render]") {
    const TemporaryDirectory directory;
    // White on black, with no light; the edges of the rotated square cross pixels.
    const std::string scene =
        directory.file("scene.json", R"({"glint": 1, "display": {"background": [0, 0, 0]},
        "objects": [{"mesh": {"primitive": "plane"}, "transform": {"rotate_deg": [90, 0, 20]}}],
        "shading": {"reflection": "none"}})");
    const auto in_between = [&](const std::string& samples) {
        const std::string pfm = directory.path("a.pfm");
        must({"render", scene, "-o", pfm, "--size", "32x32", "--samples", samples});
        const std::string bytes = bytes_of(pfm);
        int count = 0;
        for (int i = 0; i < 32 * 32; ++i) {
            const float red = pfm_pixel(bytes, 32, 32, i % 32, i / 32)[0];
            count += red > 0.01f && red < 0.99f ? 1 : 0;
        }
        CHECK(pfm_pixel(bytes, 32, 32, 16, 16)[0] == Approx(1));
        return count;
    };
    CHECK(in_between("1") == 0);
    CHECK(in_between("8") > 20);
    const std::string bytes = bytes_of(directory.path("a.pfm"));
    int odd_eighths = 0;  // pixels with values that four samples cannot give
    for (int i = 0; i < 32 * 32; ++i) {
        const float eighths = 8 * pfm_pixel(bytes, 32, 32, i % 32, i / 32)[0];
        odd_eighths += std::abs(std::remainder(eighths - 1, 2.f)) < 0.01f ? 1 : 0;
    }
    CHECK(odd_eighths > 5);
}

TEST_CASE("the file name - means standard input or output", "[cli][render]") {
    const TemporaryDirectory directory;
    const std::string out = directory.path("a.png");
    must({"render", directory.file("scene.json", three_lights), "-o", out, "--size", "64x48"});
    const Ended piped = must({"render", "-", "-o", "-", "--size", "64x48"}, three_lights);
    CHECK(piped.out == bytes_of(out));
    CHECK(piped.err.empty());
}

TEST_CASE("a picture from Glint opens as its scene, which renders to the same picture", "[cli][render]") {
    const TemporaryDirectory directory;
    const std::string a = directory.path("a.png"), b = directory.path("b.png");
    must({"render", directory.file("scene.json", three_lights), "-o", a, "--size", "64x48", "--set",
          "/display/exposure=1.7"});
    must({"render", a, "-o", b, "--size", "64x48"});
    CHECK(bytes_of(a) == bytes_of(b));
    CHECK(json::parse(must({"info", a}).out)["lights"] == 4);
}

TEST_CASE("explain uses the size of the given picture, even if it is not 1280x720", "[cli][explain]") {
    const TemporaryDirectory directory;
    const std::string a = directory.path("a.png");
    must({"render", directory.file("scene.json", three_lights), "-o", a, "--size", "97x61"});
    const Picture picture = std::get<Picture>(read_png(a));
    for (const auto& [x, y] : {std::pair{48, 30}, {20, 45}, {96, 60}}) {
        const json pixel =
            json::parse(must({"explain", a, "--pixel", fmt::format("{},{}", x, y), "--format", "json"}).out);
        const std::uint8_t* const rgba = &picture.rgba[4 * picture.pixel(x, y)];
        CHECK(pixel["byte"] == json({rgba[0], rgba[1], rgba[2]}));
    }
    const Ended outside = run_glint({"explain", a, "--pixel", "97,0"});
    CHECK(outside.status == 2);
    CHECK(outside.err == "glint: error: --pixel: 97,0 is outside the picture; expected 0 to 96, 0 to 60\n");
    CHECK(run_glint({"explain", a, "--pixel", "97,0", "--size", "98x61"}).status == 0);
    const Ended profiled = must({"profile", a, "--from", "0,30", "--to", "96,30"});
    CHECK(std::count(profiled.out.begin(), profiled.out.end(), '\n') == 1 + 97);
    CHECK(run_glint({"profile", a, "--from", "0,30", "--to", "97,30"}).status == 2);
}

TEST_CASE("commands draw a picture's scene with the picture's size and sample count", "[cli][render]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", three_lights), a = directory.path("a.png"),
                      b = directory.path("b.png");
    must({"render", scene, "-o", a, "--size", "97x61", "--samples", "4"});
    must({"render", a, "-o", b});
    CHECK(bytes_of(a) == bytes_of(b));
    must({"render", a, "-o", b, "--size", "32x24", "--samples", "1"});
    must({"render", scene, "-o", a, "--size", "32x24"});
    CHECK(bytes_of(a) == bytes_of(b));

    must({"render", scene, "-o", a, "--size", "96x48", "--samples", "8"});
    const json matrices = json::parse(must({"info", a}).out)["matrices"];  // twice as wide as high
    CHECK(matrices["clip_from_view"][1][1].get<double>() ==
          Approx(2 * matrices["clip_from_view"][0][0].get<double>()));
    CHECK(json::parse(must({"bench", a, "--frames", "1"}).out)["width"] == 96);
    const std::vector<std::string> sheet{
        "--rows", "/shading/mode=flat", "--cols", "/display/exposure=1", "-o", "-", "--cell", "40x30"};
    const auto drawn = [&sheet](std::vector<std::string> line) {
        line.insert(line.end(), sheet.begin(), sheet.end());
        return must(line).out;
    };
    CHECK(drawn({"sheet", a}) == drawn({"sheet", scene, "--samples", "8"}));
    CHECK(drawn({"sheet", a}) != drawn({"sheet", scene}));
    const std::string edges = a +
                              ": the picture has 8 samples per pixel, but these numbers are for one "
                              "sample, so they differ at edges\n";
    CHECK(run_glint({"explain", a, "--pixel", "1,1"}).err == "glint: warning: " + edges);
    CHECK(run_glint({"profile", a, "--from", "1,1", "--to", "9,9"}).err == "glint: warning: " + edges);
    CHECK(run_glint({"render", a, "-o", b, "--buffers", directory.path("")}).err ==
          "glint: error: --buffers: a pixel with several samples may show several surfaces; expected "
          "--samples 1\n");
}

TEST_CASE("a picture's scene finds its meshes even from a different directory", "[cli][render]") {
    const TemporaryDirectory meshes, pictures;
    const std::string obj = meshes.file("pyramid.obj", pyramid);
    const std::string a = pictures.path("a.png"), b = pictures.path("b.png");
    must({"render", obj, "-o", a, "--size", "64x48"});
    must({"render", a, "-o", b, "--size", "64x48"});
    CHECK(bytes_of(a) == bytes_of(b));
    must({"render", "-", "-o", a, "--size", "64x48"},
         R"({"glint": 1, "objects": [{"mesh": {"file": ")" + obj + "\"}}]}");
    must({"render", a, "-o", b, "--size", "64x48"});
    CHECK(bytes_of(a) == bytes_of(b));
}

TEST_CASE("the option --set assigns exactly the values that are given", "[cli]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", R"({"glint": 1})"), pfm = directory.path("a.pfm");
    must({"render", scene, "-o", pfm, "--size", "1x1", "--set", "/display/background=[0.25,0.5,4]", "--set",
          "/display/exposure=2"});
    CHECK(pfm_pixel(bytes_of(pfm), 1, 1, 0, 0) == std::array<float, 3>{0.5f, 1, 8});
}

TEST_CASE("a PNG's bytes are read as stored, regardless of its gamma", "[cli][compare]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", R"({"glint": 1})"),
                      plain = directory.path("a.png");
    must({"render", scene, "-o", plain, "--size", "4x2", "--set", "/display/background=[0.2,0.4,0.6]"});
    std::string bytes = bytes_of(plain);
    constexpr std::size_t behind_header = 33;
    // A gAMA chunk of 1/1.0 (PNG specification, 11.3.2.2), with its CRC.
    bytes.insert(behind_header, std::string("\0\0\0\4gAMA\0\1\x86\xA0\x31\xE8\x96\x5F", 16));
    const std::string with_gamma = directory.file("b.png", bytes);
    const Ended ended = run_glint({"compare", plain, with_gamma});
    CAPTURE(ended.err);
    CHECK(json::parse(ended.out)["max_error"] == 0);
}

TEST_CASE("a sheet, a picture, a difference or an export never replaces one of its inputs",
          "[cli][compare][export]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file(
        "scene.json", R"({"glint": 1, "objects": [{"mesh": {"primitive": "sphere", "detail": 4}}]})");
    const std::string a = directory.path("a.png"), b = directory.path("b.png"),
                      model = directory.path("model.glb");
    for (const std::string& picture : {a, b}) must({"render", scene, "-o", picture, "--size", "64x48"});
    must({"export", scene, "-o", model});
    const std::string link = directory.path("link.png");
    std::filesystem::create_symlink(a, link);
    const std::string of_model =
        directory.file("of_model.json", R"({"glint": 1, "objects": [{"mesh": {"file": "model.glb"}}]})");
    const std::string scene_link = directory.path("scene.png");
    std::filesystem::create_symlink(scene, scene_link);
    const std::string lesson = directory.file("lesson.html", R"(# Mine

```lesson
topic: Own
scene: scene.json
size: 32x32
```

## One

```predict choice
question: What is one and one?
option: two
if: 1 + 1 = 2
option: three
if: 1 + 1 = 3
```

```exercise
vary: x = 1, 2
question: What is twice {x}?
i = info
answer: 2 * {x}
tolerance: 0.01
```
)");
    const std::string buffer = directory.file("triangle.bin", std::string(36, '\0'));
    const std::string gltf =
        directory.file("t.gltf", gltf_triangle::changed("data:application/octet-stream;base64,"
                                                        "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA",
                                                        "triangle.bin"));
    const std::string buffer_link = directory.path("link.glb"),
                      picture_link = directory.path("of_buffer.png");
    std::filesystem::create_symlink(buffer, buffer_link);
    std::filesystem::create_symlink(buffer, picture_link);
    std::filesystem::create_directory(directory.path("buffers"));
    std::filesystem::create_symlink(scene, directory.path("buffers/sum.pfm"));
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"compare", a, b, "-o", a},
          {"compare", b, a, "-o", link},
          {"diagnose", scene, a, "-o", a},
          {"diagnose", a, b, "-o", a},
          {"render", a, "--no-scene", "-o", a},
          {"render", scene, "-o", scene_link},
          {"sheet", a, "--rows", "/display/exposure=1", "--cols", "/camera/eye/0=1", "-o", link},
          {"export", of_model, "-o", model},
          {"lessons", lesson, "-o", lesson},
          {"exercise", lesson, "-o", lesson},
          {"quiz", "--of", lesson, "-o", lesson},
          {"export", gltf, "-o", buffer_link},
          {"render", gltf, "-o", picture_link},
          {"render", scene, "-o", directory.path("c.pfm"), "--buffers", directory.path("buffers")},
          {"export", model, "-o", model}}) {
        const bool of_buffers = arguments.back() == directory.path("buffers");
        const std::string lost = of_buffers ? scene : arguments.back(), before = bytes_of(lost);
        CAPTURE(arguments);
        const Ended ended = run_glint(arguments);
        CAPTURE(ended.err);
        CHECK(ended.status == 2);
        CHECK(ended.err.find("is an input file and would be overwritten; expected a different name") !=
              std::string::npos);
        CHECK(bytes_of(lost) == before);
    }
    must({"render", a, "-o", a, "--size", "32x24"});  // the picture still contains its scene
    CHECK(run_glint({"info", a}).status == 0);
}

TEST_CASE("compare prints JSON, and its status reports a difference above the limit", "[cli][compare]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", R"({"glint": 1})");
    const std::string a = directory.path("a.png"), b = directory.path("b.png"), d = directory.path("d.png");
    // 0.2 · 255 = 51 and 0.24 · 255 = 61.2: bytes 51 and 61.
    must({"render", scene, "-o", a, "--size", "4x2", "--set", "/display/background=[0.2,0,0]"});
    must({"render", scene, "-o", b, "--size", "4x2", "--set", "/display/background=[0.24,0,0]"});
    const Ended ended = run_glint({"compare", a, b, "-o", d, "--max-error", "9"});
    CHECK(ended.status == 1);
    CHECK(ended.err.empty());
    const json answer = json::parse(ended.out);
    CHECK(answer["max"] == json({10, 0, 0}));
    CHECK(answer["mean"] == json({10.0, 0.0, 0.0}));
    CHECK(answer["rmse"] == json({10.0, 0.0, 0.0}));
    CHECK(answer["differing_pixels"] == 8);
    CHECK(answer["gain"] == 25);
    CHECK(run_glint({"compare", a, b, "--max-error", "10"}).status == 0);
    CHECK(run_glint({"compare", a, b}).status == 0);
    CHECK(run_glint({"compare", a, a, "--max-error", "0"}).status == 0);
    // The difference picture is (250, 0, 0) everywhere, which differs from black by 250.
    must({"render", scene, "-o", b, "--size", "4x2", "--set", "/display/background=[0,0,0]"});
    CHECK(json::parse(run_glint({"compare", d, b}).out)["max"] == json({250, 0, 0}));
    must({"render", scene, "-o", b, "--size", "2x4"});
    CHECK(run_glint({"compare", a, b}).err ==
          "glint: error: " + b +
              ": the pictures have the sizes 4x2 and 2x4; expected two of the same size\n");
}

TEST_CASE("info counts the elements in a mesh file, and prints a scene's matrices", "[cli][info]") {
    const TemporaryDirectory directory;
    const std::string obj = directory.file("pyramid.obj", pyramid);
    const json mesh = json::parse(must({"info", obj}).out);
    CHECK(mesh["vertices"] == 5);
    CHECK(mesh["faces"] == 5);
    CHECK(mesh["triangles"] == 4);
    CHECK(mesh["quads"] == 1);
    CHECK(mesh["edges"] == 8);
    CHECK(mesh["boundary_edges"] == 0);
    CHECK(mesh["bounds"]["max"] == json({2.0, 3.0, 2.0}));
    const json scene =
        json::parse(must({"info", directory.file("scene.json", three_lights), "--size", "200x100"}).out);
    CHECK(scene["lights"] == 4);
    CHECK(scene["objects"][1]["name"] == "Floor");
    CHECK(scene["objects"][1]["mesh"]["quads"] == 54);
    // The default camera is on the +z axis at a distance of 5. Half its vertical field of view is 22.5°:
    // 1 / tan(22.5°) = 1 + √2, halved because the picture is twice as wide as high.
    CHECK(scene["matrices"]["view_from_world"][2] == json({0.0, 0.0, 1.0, -5.0}));
    CHECK(scene["matrices"]["clip_from_view"][1][1].get<double>() == Approx(1 + std::sqrt(2.0)));
    CHECK(scene["matrices"]["clip_from_view"][0][0].get<double>() == Approx((1 + std::sqrt(2.0)) / 2));
}

TEST_CASE("info reports which normals each object is drawn with", "[cli][info]") {
    const TemporaryDirectory directory;
    const std::string obj = directory.file("pyramid.obj", pyramid);
    CHECK(json::parse(must({"info", obj}).out)["normals"] == "vertex");
    CHECK(json::parse(must({"info", obj, "--set", "/objects/0/normals/source=facet"}).out)["normals"] ==
          "facet");
    const json scene = json::parse(must({"info", directory.file("scene.json", R"({"glint": 1, "objects": [
        {"mesh": {"file": "pyramid.obj"}, "normals": {"source": "facet"}},
        {"mesh": {"file": "pyramid.obj"}, "normals": {"source": "file"}},
        {"mesh": {"primitive": "cube"}}, {"mesh": {"primitive": "cube"}, "normals": {"source": "vertex"}}]})")})
                                       .out);
    std::vector<std::string> normals;
    for (const json& object : scene["objects"]) normals.push_back(object["mesh"]["normals"]);
    CHECK(normals == std::vector<std::string>{"facet", "vertex", "analytic", "vertex"});
}

TEST_CASE("a tolerated problem in a mesh gives a one-line warning, and the command succeeds", "[cli]") {
    const TemporaryDirectory directory;
    const std::string obj = directory.file("odd.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\nf 1 2 3\n");
    const Ended ended = must({"render", obj, "-o", directory.path("a.png"), "--size", "8x8"});
    CHECK(ended.err.rfind("glint: warning: ", 0) == 0);
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
}

TEST_CASE("a small mesh far from the origin is shifted before drawing, with a warning", "[cli]") {
    const TemporaryDirectory directory;
    const auto box = [&](const std::string& name, const std::string& x, const std::string& y) {
        std::string text;
        for (int i = 0; i < 8; ++i)
            text += fmt::format("v {}{} {}{} 0.{}\n", x, 1 + 2 * (i & 1), y, 1 + (i & 2), 1 + (i >> 1 & 2));
        return directory.file(name,
                              text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
    };
    const auto warnings = [&](const std::string& file) {
        return must({"render", file, "-o", directory.path("a.png"), "--size", "8x8"}).err;
    };
    CHECK(warnings(box("near.obj", "0.", "0.")).empty());
    // Between 2^22 and 2^23, neighbouring floats are 0.5 apart: y is 5400000 or 5400000.5.
    const std::string far = box("far.obj", "500000.", "5400000.");
    const std::string said =
        "the coordinates are far from the origin: the offset (500000, 5400000, 0) is subtracted";
    CHECK(warnings(far) == "glint: warning: far.obj: " + said + "\n");
    const json info = json::parse(must({"info", far}).out);
    CHECK(info["warnings"].back() == said);
    CHECK(info["offset"] == json({500000, 5400000, 0}));
    CHECK(info["bounds"]["max"][0] == Approx(0.3).epsilon(1e-6));
}

TEST_CASE("info reports, as JSON or text, flaws that make programs draw a mesh wrongly", "[cli]") {
    const TemporaryDirectory directory;
    const std::string obj =
        directory.file("turned.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n");
    const json findings = json::parse(must({"info", obj}).out)["findings"];
    REQUIRE(findings.size() == 2);
    CHECK(findings[0]["name"] == "opposite_winding");
    CHECK(findings[0]["count"] == 1);
    CHECK(findings[0]["places"] == json({{0.5, 0.5, 0}}));
    const std::string text = must({"info", obj, "--format", "text"}).out;
    CHECK(text.find(
              "turned.obj: 4 vertices, 2 faces, 5 edges; normals: vertex\n"
              "  1 edge joins faces that are wound in opposite directions: culling leaves holes there, ") !=
          std::string::npos);
    CHECK(text.find("\n    at 0.5 0.5 0\n") != std::string::npos);
    const std::string scene = must({"info", project_file("assets/scenes/bulb.json"), "--format", "text"}).out;
    CHECK(scene.find(" vertices, ") != std::string::npos);
}

TEST_CASE("vertex colours under a lit model are reported in one warning", "[cli]") {
    const TemporaryDirectory directory;
    const std::string obj =
        directory.file("red.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n");
    const std::vector<std::string> info{"info", obj};
    CHECK(must(info).err ==
          "glint: warning: 1 object has vertex colours, which only the reflection \"none\" shows\n");
    CHECK(must({"info", obj, "--set", "/shading/reflection=\"none\""}).err.empty());
}

TEST_CASE("a warning names each mesh with missing normals once, even if objects share it", "[cli]") {
    const TemporaryDirectory directory;
    const char* const halves = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf 2 4 3\n";
    (void)directory.file("a.obj", halves);
    (void)directory.file("b.obj", halves);
    const std::string scene = directory.file("scene.json", R"({"glint": 1, "objects": [
        {"mesh": {"file": "a.obj"}}, {"mesh": {"file": "b.obj"}}, {"mesh": {"file": "a.obj"}},
        {"mesh": {"primitive": "cube"}, "normals": {"source": "file"}},
        {"mesh": {"primitive": "cone"}, "normals": {"source": "file"}}]})");
    const Ended ended = must({"render", scene, "-o", directory.path("a.png"), "--size", "8x8"});
    const std::string missing = "3 corners have no normal; their vertex normals are used\n",
                      none = R"(the mesh has no "file" normals; "analytic" normals are used)";
    CHECK(ended.err == "glint: warning: a.obj: " + missing + "glint: warning: b.obj: " + missing +
                           "glint: warning: cube: " + none + "\nglint: warning: cone: " + none + "\n");
}

TEST_CASE("bench measures the requested number of frames", "[cli][bench]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", three_lights);
    for (const std::string drag : {"light", "material", "camera", "object"}) {
        const json answer = json::parse(
            must({"bench", scene, "--size", "64x48", "--frames", "5", "--drag", drag, "--relight", "-j", "2"})
                .out);
        CHECK(answer["frames"] == 5);
        CHECK(answer["drag"] == drag);
        CHECK(answer["threads"] == 2);
        CHECK(answer["width"] == 64);
        CHECK(answer["ms"]["median"].get<double>() > 0);
        CHECK(answer["ms"]["median"].get<double>() <= answer["ms"]["p90"].get<double>());
        CHECK(answer["ms"]["p99"].get<double>() <= answer["ms"]["max"].get<double>());
        CHECK(answer["stages"]["lighting"].get<double>() > 0);
        CHECK((answer["stages"]["geometry"].get<double>() > 0) == (drag == "camera" || drag == "object"));
        CHECK(answer["redone"]["lighting"] == 5);
        CHECK(answer["redone"]["geometry"] == (drag == "camera" || drag == "object" ? 5 : 0));
        CHECK(answer["peak_bytes"].get<double>() > 1e6);
    }
    const std::string dark = directory.file("dark.json", R"({"glint": 1})");
    CHECK(json::parse(must({"bench", dark, "--size", "8x8", "--frames", "1"}).out)["drag"] == "camera");
    CHECK(run_glint({"bench", dark, "--drag", "light"}).err ==
          "glint: error: --drag: the scene has no lights; expected material, camera or object, or a scene "
          "with a "
          "light\n");
}

TEST_CASE("a text explanation says why a light contributes nothing", "[cli][explain]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("scene.json", R"({"glint": 1,
        "objects": [{"name": "Wall", "mesh": {"primitive": "plane"}, "transform": {"rotate_deg": [90, 0, 0]}}],
        "lights": [{"name": "Behind", "position": [0, 0, -2]},
                   {"name": "Lamp", "type": "spot", "position": [1, 0, 1],
                    "spot": {"direction": [0, 0, -1], "cutoff_deg": 30}},
                   {"name": "Sun", "type": "directional", "position": [0, 0, 1], "diffuse": [2, 1, 1]}]})");
    // The centre pixel shows the origin, which is 45° from the Lamp's axis, 15° outside its cone.
    const Ended ended = must({"explain", scene, "--pixel", "50,50", "--size", "101x101"});
    CHECK(ended.out.rfind("Pixel 50, 50: Wall, face 0, front side; phong shading, phong reflection\n", 0) ==
          0);
    CHECK(ended.out.find("Behind, point light (behind the surface: n·l < 0)\n") != std::string::npos);
    CHECK(ended.out.find("Lamp, spot light (outside the cone by 15.0°)\n") != std::string::npos);
    CHECK(ended.out.find("red clips: ") != std::string::npos);
    CHECK(must({"explain", scene, "--pixel", "0,0"}).out.rfind("Pixel 0, 0: background\n", 0) == 0);
}
