// All errors in a scene file, and their one-line messages.
#include <fmt/format.h>

#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

struct Wrong {
    std::string text, line;
};

std::string line_of(const std::string& text) {
    const Result<Scene> result = parse_scene(text, "s");
    return problem_of(result) != nullptr ? problem_of(result)->text() : "no problem";
}

/// Each scene text follows `"glint": 1`; each expected message follows the file's name.
void check_members(const std::vector<Wrong>& table) {
    for (const Wrong& wrong : table) {
        const std::string text = std::string(R"({"glint": 1, )").append(wrong.text).append("}");
        CHECK(line_of(text) == std::string("s: ").append(wrong.line));
    }
}

}  // namespace

TEST_CASE("text that is not JSON is reported with its line and the expected input", "[scene_error]") {
    const std::vector<Wrong> table{
        {"", R"(1: the text is empty; expected an object, such as {"glint": 1})"},
        {"  \n  ", R"(1: the text is empty; expected an object, such as {"glint": 1})"},
        {"\xEF\xBB\xBF", R"(1: the text is empty; expected an object, such as {"glint": 1})"},
        {"\xEF\xBB\xBF\xEF\xBB\xBF{\"glint\": 1}",
         "1: a second byte-order mark; expected at most one before the text"},
        {"{", R"(1: the text ends too early; expected a key in quotes or "}")"},
        {R"({"glint": 1)", R"(1: the text ends too early; expected "," or "}")"},
        {R"({"glint": 1,})", R"(1: unexpected "}"; expected a key in quotes)"},
        {R"({"glint" 1})", R"(1: unexpected "1"; expected ":" after the key)"},
        {R"({"glint": })", R"(1: unexpected "}"; expected a value)"},
        {R"({"glint": 1, "lights": [,]})", R"(1: unexpected ","; expected a value or "]")"},
        {"{\"glint\": 1,\n \"lights\": [{}\n {}]}", R"(3: unexpected "{"; expected "," or "]")"},
        {"{glint: 1}", R"(1: unexpected "glint"; expected a key in quotes or "}")"},
        {"{'glint': 1}", R"(1: unexpected "'"; expected a key in quotes or "}")"},
        {R"({"glint": 1} x)", R"(1: unexpected "x"; expected the end of the text)"},
        {R"({"glint": 1}})", R"(1: unexpected "}"; expected the end of the text)"},
        {std::string("{\"glint\": 1}\n\0}", 15),
         "2: the byte 0x00; expected JSON text, which never contains it"},
        {"{\"glint\": 1,\n\n // c\n}", "3: a comment or a stray slash; expected JSON, which has no comments"},
        {R"(/* c */ {"glint": 1})", "1: a comment or a stray slash; expected JSON, which has no comments"},
        {"{\"glint\": 1,\n\"npr\": tru}", R"(2: unexpected "tru"; expected a value)"},
        {R"({"glint": NaN})", R"(1: unexpected "NaN"; expected a value)"},
        {R"({"glint": -Infinity})", R"(1: unexpected "-Infinity"; expected a value)"},
        {R"({"glint": 01})", R"(1: unexpected "1"; expected "," or "}")"},
        {R"({"glint": .5})", R"(1: unexpected ".5"; expected a value)"},
        {R"({"glint": 1.})", R"(1: unexpected "1."; expected a value)"},
        {R"({"glint": +1})", R"(1: unexpected "+1"; expected a value)"},
        {R"({"glint": 0x1})", R"(1: unexpected "x1"; expected "," or "}")"},
        {"{\"glint\": \"a\nb\"}",
         R"(1: a control character in a string; expected an escape: \n, \t, or \u and four hex digits)"},
        {R"({"glint": "\q"})",
         R"(1: an escape that JSON does not have; expected \", \\, \/, \b, \f, \n, \r, \t, or \u and four hex digits, surrogates in pairs)"},
        {R"({"glint": "\ud800"})",
         R"(1: an escape that JSON does not have; expected \", \\, \/, \b, \f, \n, \r, \t, or \u and four hex digits, surrogates in pairs)"},
        {R"({"glint": "abc)", R"(1: a string that does not end; expected " after it)"},
        {R"({"glint": 1 "npr": {}})", R"(1: unexpected "npr"; expected "," or "}")"},
        {R"({"glint": 1, "npr" {}})", R"(1: unexpected "{"; expected ":" after the key)"},
        {R"({"glint": 1e999})", "1: /glint: 1e999 is out of range; expected a number between -1e7 and 1e7"},
        {R"({"glint": 1, "camera": {"eye": [0, 0, -1e400]}})",
         "1: /camera/eye/2: -1e400 is out of range; expected a number between -1e7 and 1e7"},
        {"{\"glint\": 1,\n \"npr\": {\"alpha\":\n 1, \"alpha\": 1}}",
         R"(3: /npr: duplicate key "alpha"; expected it only once)"},
        {R"({"glint": 1, "glint": 1})", R"(1: duplicate key "glint"; expected it only once)"},
        {R"({"glint": 1, "lights": [{"name": "a"}, {"spot": {"exponent": 1, "exponent": 1}}]})",
         R"(1: /lights/1/spot: duplicate key "exponent"; expected it only once)"},
        {"{\"glint\": 1,\n\"a\xff"
         "b\": 1}",
         "2: the byte 0xff is not UTF-8; expected UTF-8 text"},
        {"{\"glint\": \"\xc0\xaf\"}", "1: the byte 0xc0 is not UTF-8; expected UTF-8 text"},
    };
    for (const Wrong& wrong : table) CHECK(line_of(wrong.text) == std::string("s:").append(wrong.line));
}

TEST_CASE("a document that is not a scene of version 1 is refused", "[scene_error]") {
    const std::vector<Wrong> table{
        {"[]", R"(the value is an array; expected an object, such as {"glint": 1})"},
        {"3", R"(3 is a number; expected an object, such as {"glint": 1})"},
        {"null", R"(null is not a value; expected an object, such as {"glint": 1})"},
        {R"("glint")", R"("glint" is a string; expected an object, such as {"glint": 1})"},
        {"{}", R"(the key "glint" is missing; expected "glint": 1, the version of the format)"},
        {R"({"GLINT": 1})", R"(the key "glint" is missing; expected "glint": 1, the version of the format)"},
        {R"({"glint": 2})", "/glint: version 2 is not known; expected 1"},
        {R"({"glint": "1"})", R"(/glint: "1" is a string; expected 1, the version of the format)"},
        {R"({"glint": null})", "/glint: null is not a value; expected 1, the version of the format"},
    };
    for (const Wrong& wrong : table) CHECK(line_of(wrong.text) == std::string("s: ").append(wrong.line));
}

TEST_CASE("an unknown key is reported with the nearest known one", "[scene_error]") {
    check_members({
        {R"("camra": {})", R"(/camra: unknown key "camra"; expected "camera")"},
        {R"("": {})", R"(/: unknown key ""; expected "npr")"},
        {R"("a/b~c": 1)", R"(/a~1b~0c: unknown key "a/b~c"; expected "about")"},
        {R"("a\u0000\u001b[31m": 1)", R"(/a\x00\x1b[31m: unknown key "a\x00\x1b[31m"; expected "about")"},
        {R"("comment": null)", R"(/comment: unknown key "comment"; expected "camera")"},
    });
}

TEST_CASE("an invalid light is reported at its JSON pointer", "[scene_error]") {
    check_members({
        {R"("lights": [{"positon": [1, 2, 3]}])",
         R"(/lights/0/positon: unknown key "positon"; expected "position")"},
        {R"("lights": [{}, {"spot": {"cutoff_deg": 120}}])",
         "/lights/1/spot/cutoff_deg: 120 is out of range; expected 0 to 90, or 180"},
        {R"("lights": [{"spot": {"cutoff_deg": 90.5}}])",
         "/lights/0/spot/cutoff_deg: 90.5 is out of range; expected 0 to 90, or 180"},
        {R"("lights": [{"spot": {"cutoff_deg": -1}}])",
         "/lights/0/spot/cutoff_deg: -1 is out of range; expected 0 to 90, or 180"},
        {R"("lights": [{"spot": {"exponent": -1}}])",
         "/lights/0/spot/exponent: -1 is out of range; expected 0 to 1e7"},
        {R"("lights": [{"spot": {"direction": [0, 0, 0]}}])",
         "/lights/0/spot/direction: a zero direction; expected the direction of the cone's axis"},
        {R"("lights": [{"spot": {"direction": [0, 1e-60, 0]}}])",
         "/lights/0/spot/direction: a zero direction; expected the direction of the cone's axis"},
        {R"("lights": [{"position": [1, 2, 3, 0]}])",
         "/lights/0/position: w is 0; expected w > 0 for a point light"},
        {R"("lights": [{"type": "area", "position": [1, 2, 3, -1]}])",
         "/lights/0/position: w is -1; expected w > 0 for an area light"},
        {R"("lights": [{"type": "directional", "position": [1, 2, 3, 1]}])",
         "/lights/0/position: w is 1; expected w = 0 for a directional light"},
        {R"("lights": [{"type": "directional", "position": [0, 0, 0]}])",
         "/lights/0/position: a zero direction; expected the direction towards the light"},
        {R"("lights": [{"position": [1e5, 2, 3, 1e-4]}])",
         "/lights/0/position: divided by w, it is 1000000000; expected a number between -1e7 and 1e7"},
        {R"("lights": [{"position": [1, 2]}])", "/lights/0/position: an array of 2; expected 3 or 4 numbers"},
        {R"("lights": [{"position": [1, 2, 3, 1, 1]}])",
         "/lights/0/position: an array of 5; expected 3 or 4 numbers"},
        {R"("lights": [{"position": [1, 2, "x"]}])",
         R"(/lights/0/position/2: "x" is a string; expected a number)"},
        {R"("lights": [{"position": null}])",
         "/lights/0/position: null is not a value; expected an array of 3 or 4 numbers"},
        {R"("lights": {})", "/lights: the value is an object; expected an array of lights"},
        {R"("lights": [[]])", "/lights/0: the value is an array; expected an object"},
        {R"("lights": [{"type": "pont"}])",
         R"(/lights/0/type: "pont" is not known; expected directional, point, spot or area)"},
        {R"("lights": [{"type": 3}])",
         "/lights/0/type: 3 is a number; expected directional, point, spot or area"},
        {R"("lights": [{"space": "view"}])",
         R"(/lights/0/space: "view" is not known; expected world or camera)"},
        {R"("lights": [{"name": 1}])", "/lights/0/name: 1 is a number; expected a string"},
        {R"("lights": [{"enabled": 1}])", "/lights/0/enabled: 1 is a number; expected true or false"},
        {R"("lights": [{"intensity": -0.5}])",
         "/lights/0/intensity: -0.5 is out of range; expected 0 to 1e7"},
        {R"("lights": [{"diffuse": [1, -1, 1]}])",
         "/lights/0/diffuse/1: -1 is out of range; expected 0 to 1e7"},
        {R"("lights": [{"diffuse": 1}])", "/lights/0/diffuse: 1 is a number; expected an array of 3 numbers"},
        {R"("lights": [{"falloff": {"constant": 0}}])",
         "/lights/0/falloff: constant, linear and quadratic are all 0; expected one of them above 0"},
        {R"("lights": [{"falloff": {"constant": 1e-60}}])",
         "/lights/0/falloff: constant, linear and quadratic are all 0; expected one of them above 0"},
        {R"("lights": [{"falloff": {"linear": -1}}])",
         "/lights/0/falloff/linear: -1 is out of range; expected 0 to 1e7"},
        {R"("lights": [{"area": {"samples": 5}}])",
         "/lights/0/area/samples: 5 is out of range; expected 1, 4, 9, 16, 25, 36, 49 or 64"},
        {R"("lights": [{"area": {"samples": 0}}])",
         "/lights/0/area/samples: 0 is out of range; expected 1, 4, 9, 16, 25, 36, 49 or 64"},
        {R"("lights": [{"area": {"edge_u": [0, 0, 1]}}])",
         "/lights/0/area: edge_u and edge_v span no area; expected two edges that are neither zero nor "
         "parallel"},
        {R"("lights": [{"area": {"edge_u": [0, 0, 0]}}])",
         "/lights/0/area: edge_u and edge_v span no area; expected two edges that are neither zero nor "
         "parallel"},
    });
}

TEST_CASE("a camera that breaks its rules is reported at its pointer", "[scene_error]") {
    check_members({
        {R"("camera": {"eye": [0, 0, 0]})",
         "/camera: eye and target are the same point; expected two different points"},
        {R"("camera": {"eye": [1, 0, 1e7], "target": [1.00000001, 0, 1e7]})",
         "/camera: eye and target are the same point; expected two different points"},
        {R"("camera": {"up": [0, 0, 2]})",
         "/camera: up is parallel to the viewing direction; expected an up that is not along the line from "
         "eye "
         "to target"},
        {R"("camera": {"up": [0, 0, 0]})", "/camera: up is zero; expected a direction"},
        {R"("camera": {"eye": [0.1, 0.2, 0.3], "up": [1, 2, 3]})",
         "/camera: up is parallel to the viewing direction; expected an up that is not along the line from "
         "eye "
         "to target"},
        {R"("camera": {"projection": {"near": 1e-50}})",
         "/camera/projection/near: 1e-50 is out of range; expected more than 0, up to 1e7"},
        {R"("camera": {"projection": {"near": 0}})",
         "/camera/projection/near: 0 is out of range; expected more than 0, up to 1e7"},
        {R"("camera": {"projection": {"near": 5, "far": 2}})",
         "/camera/projection: near 5 is not less than far 2; expected 0 < near < far"},
        {R"("camera": {"projection": {"near": 1, "far": 1.00000001}})",
         "/camera/projection: near 1 is not less than far 1; expected 0 < near < far"},
        {R"("camera": {"projection": {"fov_y_deg": 180}})",
         "/camera/projection/fov_y_deg: 180 is out of range; expected more than 0, less than 180"},
        {R"("camera": {"projection": {"fov_y_deg": 179.9999999}})",
         "/camera/projection/fov_y_deg: 179.9999999 is out of range; expected more than 0, less than 180"},
        {R"("camera": {"projection": {"type": "orthographic", "height": 0}})",
         "/camera/projection/height: 0 is out of range; expected more than 0, up to 1e7"},
        {R"("camera": {"projection": {"type": "orthographic", "fov_y_deg": 45}})",
         R"(/camera/projection/fov_y_deg: not a key of the projection "orthographic"; expected type, height, near or far)"},
        {R"("camera": {"projection": {"type": "frustum", "left": 1}})",
         R"(/camera/projection: "right" is missing; expected all six numbers of a frustum)"},
        {R"("camera": {"projection": {"type": "frustum", "left": 1, "right": 1, "bottom": 0, "top": 1, "near": 1, "far": 2}})",
         "/camera/projection: left and right are both 1; expected two different numbers"},
        {R"("camera": {"projection": {"type": "frustum", "left": 0, "right": 1, "bottom": 1, "top": 1, "near": 1, "far": 2}})",
         "/camera/projection: bottom and top are both 1; expected two different numbers"},
        {R"("camera": {"projection": {"type": "ortho"}})",
         R"(/camera/projection/type: "ortho" is not known; expected perspective, orthographic or frustum)"},
        {R"("camera": {"projection": {"far_": 1}})",
         R"(/camera/projection/far_: unknown key "far_"; expected "far")"},
    });
}

TEST_CASE("an object that breaks its rules is reported at its pointer", "[scene_error]") {
    check_members({
        {R"("objects": [{"transform": {"scale": [1, 0, 1]}}])",
         "/objects/0/transform/scale/1: a scale of 0; expected a number other than 0 (negative values "
         "mirror)"},
        {R"("objects": [{"transform": {"scale": [1, 1, 1e-60]}}])",
         "/objects/0/transform/scale/2: a scale of 0; expected a number other than 0 (negative values "
         "mirror)"},
        {R"("objects": [{"transform": {"rotate": [1, 1, 1]}}])",
         R"(/objects/0/transform/rotate: unknown key "rotate"; expected "rotate_deg")"},
        {R"("objects": [{"transform": {"translate": [1e8, 0, 0]}}])",
         "/objects/0/transform/translate/0: 100000000 is out of range; expected a number between -1e7 and "
         "1e7"},
        {R"("objects": [{"mesh": "teapot"}])",
         R"(/objects/0/mesh: "teapot" is a string; expected an object)"},
        {R"("objects": [{"mesh": {"primitive": "ball"}}])",
         R"(/objects/0/mesh/primitive: "ball" is not known; expected sphere, bumpy-sphere, icosphere, cube, plane, tessellated-quad, torus, cylinder, cone, teapot, knot, skew-quad or t-junction)"},
        {R"("objects": [{"mesh": {"detail": 0}}])",
         "/objects/0/mesh/detail: 0 is out of range; expected a whole number from 1 to 2800"},
        {R"("objects": [{"mesh": {"detail": 1.5}}])",
         "/objects/0/mesh/detail: 1.5 is not a whole number; expected a whole number from 1 to 2800"},
        {R"("objects": [{"mesh": {"primitive": "skew-quad", "detail": 2}}])",
         "/objects/0/mesh/detail: 2 is out of range; expected 1"},
        {R"("objects": [{"mesh": {"file": "a.obj", "primitive": "cube"}}])",
         R"(/objects/0/mesh: both "file" and "primitive"; expected one of the two)"},
        {R"("objects": [{"mesh": {"file": "a.obj", "detail": 3}}])",
         R"(/objects/0/mesh: "detail" together with "file"; expected this key only for a primitive)"},
        {R"("objects": [{"mesh": {"primitive": "cube", "part": null}}])",
         R"(/objects/0/mesh: "part" without "file"; expected this key only for a file)"},
        {R"("objects": [{"mesh": {"file": ""}}])",
         "/objects/0/mesh/file: an empty file name; expected the name of a mesh file"},
        {R"("objects": [{"mesh": {"file": "a\u0000.obj"}}])",
         "/objects/0/mesh/file: a file name with a zero byte; expected the name of a mesh file"},
        {R"("objects": [{"normals": {"crease_deg": 181}}])",
         "/objects/0/normals/crease_deg: 181 is out of range; expected 0 to 180"},
        {R"("objects": [{"normals": {"source": "face"}}])",
         R"(/objects/0/normals/source: "face" is not known; expected auto, file, facet, vertex or analytic)"},
        {R"("objects": [{"normals": {"weighting": "none"}}])",
         R"(/objects/0/normals/weighting: "none" is not known; expected uniform, area or angle)"},
        {R"("objects": [{"material": {"shininess": 10001}}])",
         "/objects/0/material/shininess: 10001 is out of range; expected 0 to 10000"},
        {R"("objects": [{"material": {"shininess": -1}}])",
         "/objects/0/material/shininess: -1 is out of range; expected 0 to 10000"},
        {R"("objects": [{"material": {"roughness": 1.5}}])",
         "/objects/0/material/roughness: 1.5 is out of range; expected 0 to 1"},
        {R"("objects": [{"material": {"f0": [0, 0, -0.1]}}])",
         "/objects/0/material/f0/2: -0.1 is out of range; expected 0 to 1e7"},
        {R"("objects": [{"material": {"kd": [0, 0, 0]}}])",
         R"(/objects/0/material/kd: unknown key "kd"; expected "f0")"},
    });
}

TEST_CASE("a name of more than 1000 characters is refused, regardless of its byte count", "[scene_error]") {
    for (const std::string list : {"lights", "objects"})
        for (const std::string character : {"n", "\u00E9"}) {
            std::string name;
            for (int i = 0; i < 1000; ++i) name += character;
            const auto with_name = [&](const std::string& text) {
                return line_of(fmt::format(R"({{"glint": 1, "{}": [{{"name": "{}"}}]}})", list, text));
            };
            CHECK(with_name(name) == "no problem");
            CHECK(with_name(name + "n") ==
                  fmt::format("s: /{}/0/name: has 1001 characters; expected at most 1000", list));
        }
}

TEST_CASE("shading, npr and display that break their rules are reported at their pointers", "[scene_error]") {
    check_members({
        {R"("global_ambient": [0, 0, -1])", "/global_ambient/2: -1 is out of range; expected 0 to 1e7"},
        {R"("global_ambient": [0, 0])", "/global_ambient: an array of 2; expected 3 numbers"},
        {R"("shading": {"mode": "Phong"})",
         R"(/shading/mode: "Phong" is not known; expected flat, facet, gouraud or phong)"},
        {R"("shading": {"reflection": "blinn"})",
         R"(/shading/reflection: "blinn" is not known; expected none, lambert, phong, blinn-phong, retro, oren-nayar or cook-torrance)"},
        {R"("shading": {"interpolation": "linear"})",
         R"(/shading/interpolation: "linear" is not known; expected perspective, screen or scanline)"},
        {R"("shading": {"flat_point": "first"})",
         R"(/shading/flat_point: "first" is not known; expected centroid or provoking)"},
        {R"("shading": {"cull": "both"})",
         R"(/shading/cull: "both" is not known; expected none, back or front)"},
        {R"("shading": {"rules": "opengl"})",
         R"(/shading/rules: "opengl" is not known; expected lecture or opengl2)"},
        {R"("shading": {"power_table": 1})",
         "/shading/power_table: 1 is out of range; expected 0, or 2 to 65536 entries"},
        {R"("shading": {"power_table": 2.5})",
         "/shading/power_table: 2.5 is not a whole number; expected 0, or 2 to 65536 entries"},
        {R"("shading": {"power_table": true})",
         "/shading/power_table: true is not allowed here; expected 0, or 2 to 65536 entries"},
        {R"("shading": {"two_sided": "yes"})",
         R"(/shading/two_sided: "yes" is a string; expected true or false)"},
        {R"("shading": {"terms": {"difuse": true}})",
         R"(/shading/terms/difuse: unknown key "difuse"; expected "diffuse")"},
        {R"("shading": {"mistakes": {"no_clamp": true}})",
         R"(/shading/mistakes/no_clamp: unknown key "no_clamp"; expected "no_clamp_of_cosine")"},
        {R"("shading": {"mistakes": {"normals_flipped": 1}})",
         "/shading/mistakes/normals_flipped: 1 is a number; expected true or false"},
        {R"("shading": {"mistakes": []})", "/shading/mistakes: the value is an array; expected an object"},
        {R"("npr": {"crease_deg": 200})", "/npr/crease_deg: 200 is out of range; expected 0 to 180"},
        {R"("npr": {"stroke_width_px": -1})", "/npr/stroke_width_px: -1 is out of range; expected 0 to 1e7"},
        {R"("npr": {"warm": [-1, 0, 0]})", "/npr/warm/0: -1 is out of range; expected 0 to 1e7"},
        {R"("npr": {"alpha": true})", "/npr/alpha: true is not allowed here; expected a number"},
        {R"("display": {"exposure": 0})",
         "/display/exposure: 0 is out of range; expected more than 0, up to 1e7"},
        {R"("display": {"exposure": 1e8})",
         "/display/exposure: 100000000 is out of range; expected more than 0, up to 1e7"},
        {R"("display": {"transfer": "gamma"})",
         R"(/display/transfer: "gamma" is not known; expected none or srgb)"},
        {R"("display": {"background": [0.1, 0.1, 0.12, 1]})",
         "/display/background: an array of 4; expected 3 numbers"},
    });
}
